
        // A clip cannot be divided, but its model.
        static bool Change(AnimationClip clip, bool add)
        {
            return false;
        }

        // The segments are parts of the first take.
        static bool Import(ModelImporter importer, bool add)
        {
            var takes = importer.defaultClipAnimations;
            if (takes.Length == 0)
            {
                return false;
            }
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
            return true;
        }
    }
}
#endif
