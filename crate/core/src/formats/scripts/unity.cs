
        [MenuItem("Assets/Plantigrade/Add " + Menu)]
        static void Add()
        {
            ForEachSelected(true);
        }

        [MenuItem("Assets/Plantigrade/Remove " + Menu)]
        static void Remove()
        {
            ForEachSelected(false);
        }

        static void ForEachSelected(bool add)
        {
            var found = false;
            foreach (var selected in Selection.objects)
            {
                var importer = AssetImporter.GetAtPath(AssetDatabase.GetAssetPath(selected)) as ModelImporter;
                found |= importer != null ? Import(importer, add) : Change(selected as AnimationClip, add);
            }
            if (!found)
            {
                Debug.LogError("Select " + Target + " in the project window first.");
            }
        }
