
        [MenuItem("Assets/Plantigrade/Add segments of " + Menu)]
        static void Add()
        {
            ForEachSelected(true);
        }

        [MenuItem("Assets/Plantigrade/Remove segments of " + Menu)]
        static void Remove()
        {
            ForEachSelected(false);
        }

        static void ForEachSelected(bool add)
        {
            var found = false;
            foreach (var selected in Selection.objects)
            {
                var path = AssetDatabase.GetAssetPath(selected);
                var importer = AssetImporter.GetAtPath(path) as ModelImporter;
                if (importer != null && importer.defaultClipAnimations.Length > 0)
                {
                    Import(importer, add);
                    found = true;
                }
            }
            if (!found)
            {
                Debug.LogError("Select the model with the animation in the project window first.");
            }
        }

        // The segments are parts of the first take.
        static void Import(ModelImporter importer, bool add)
        {
            var takes = importer.defaultClipAnimations;
            var clips = new List<ModelImporterClipAnimation>();
            foreach (var clip in importer.clipAnimations.Length > 0 ? importer.clipAnimations : takes)
            {
                if (!clip.name.StartsWith(Prefix, StringComparison.Ordinal))
                {
                    clips.Add(clip);
                }
            }
            var take = takes[0];
            var rate = Duration > 0f ? (take.lastFrame - take.firstFrame) / Duration : 0f;
            foreach (var segment in Segments)
            {
                if (add)
                {
                    clips.Add(new ModelImporterClipAnimation
                    {
                        name = Prefix + segment.Item3,
                        takeName = take.takeName,
                        firstFrame = take.firstFrame + segment.Item1 * rate,
                        lastFrame = Math.Min(take.firstFrame + segment.Item2 * rate, take.lastFrame),
                    });
                }
            }
            importer.clipAnimations = clips.ToArray();
            importer.SaveAndReimport();
        }
    }
}
#endif
