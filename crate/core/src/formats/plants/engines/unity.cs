
        // Events that this script has added, and no others, have this function.
        const string Function = "OnFootEvent";

        [MenuItem("Assets/Plantigrade/Add foot events of " + Menu)]
        static void Add()
        {
            ForEachSelected(true);
        }

        [MenuItem("Assets/Plantigrade/Remove foot events of " + Menu)]
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
                var clip = selected as AnimationClip;
                if (importer != null)
                {
                    Import(importer, add);
                    found = true;
                }
                else if (clip != null)
                {
                    Undo.RegisterCompleteObjectUndo(clip, "Foot events");
                    AnimationUtility.SetAnimationEvents(
                        clip,
                        Replaced(AnimationUtility.GetAnimationEvents(clip), add, 1f, clip.length));
                    EditorUtility.SetDirty(clip);
                    found = true;
                }
            }
            if (!found)
            {
                Debug.LogError("Select the animation clip, or the model with the clip, in the project window first.");
            }
        }

        // Events of an imported model are part of its import settings; their times are from 0 to 1.
        static void Import(ModelImporter importer, bool add)
        {
            var clips = importer.clipAnimations.Length > 0
                ? importer.clipAnimations
                : importer.defaultClipAnimations;
            foreach (var clip in clips)
            {
                clip.events = Replaced(clip.events, add, Duration, Duration);
            }
            importer.clipAnimations = clips;
            importer.SaveAndReimport();
        }

        // Returns the events with those of the clip added or removed. Times are divided by unit seconds.
        static AnimationEvent[] Replaced(AnimationEvent[] before, bool add, float unit, float length)
        {
            var events = new List<AnimationEvent>();
            foreach (var other in before)
            {
                if (other.functionName != Function)
                {
                    events.Add(other);
                }
            }
            if (add)
            {
                // A clip that was imported at another frame rate has another length.
                var scale = Math.Abs(length - Duration) > 1.5f / Rate ? length / Duration : 1f;
                foreach (var contact in Events)
                {
                    events.Add(new AnimationEvent
                    {
                        time = Math.Min(contact.Key * scale, length) / unit,
                        functionName = Function,
                        stringParameter = contact.Value,
                        messageOptions = SendMessageOptions.DontRequireReceiver,
                    });
                }
            }
            events.Sort((a, b) => a.time.CompareTo(b.time));
            return events.ToArray();
        }
    }
}
#endif
