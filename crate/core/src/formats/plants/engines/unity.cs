
        // Events that this script has added, and no others, have this function.
        const string Function = "OnFootEvent";

        static bool Change(AnimationClip clip, bool add)
        {
            if (clip == null)
            {
                return false;
            }
            Undo.RegisterCompleteObjectUndo(clip, "Foot events");
            // A clip that was imported at another frame rate has another length.
            var isScaled = Math.Abs(clip.length - Duration) > 1.5f / Rate;
            var scale = isScaled ? clip.length / Duration : 1f;
            var before = AnimationUtility.GetAnimationEvents(clip);
            AnimationUtility.SetAnimationEvents(clip, Replaced(before, add, time => time * scale, clip.length));
            EditorUtility.SetDirty(clip);
            return true;
        }

        // Events of an imported model are part of its import settings. Their times are from 0 at the first frame
        // of a clip, which may be a part of its take, to 1 at the last.
        static bool Import(ModelImporter importer, bool add)
        {
            var takes = importer.defaultClipAnimations;
            var clips = importer.clipAnimations.Length > 0 ? importer.clipAnimations : takes;
            foreach (var clip in clips)
            {
                var take = Array.Find(takes, other => other.takeName == clip.takeName) ?? clip;
                var rate = (take.lastFrame - take.firstFrame) / Duration;
                var offset = take.firstFrame - clip.firstFrame;
                var frames = clip.lastFrame - clip.firstFrame;
                clip.events = Replaced(clip.events, add, time => (time * rate + offset) / frames, 1f);
            }
            importer.clipAnimations = clips;
            importer.SaveAndReimport();
            return true;
        }

        // Returns the events with those of the clip added or removed. An animation of a part of the clip has only
        // its events; end is the time of its last frame.
        static AnimationEvent[] Replaced(AnimationEvent[] before, bool add, Func<float, float> at, float end)
        {
            var events = new List<AnimationEvent>();
            foreach (var other in before)
            {
                if (other.functionName != Function)
                {
                    events.Add(other);
                }
            }
            foreach (var contact in Events)
            {
                var time = at(contact.Key);
                var halfFrame = at(0.5f / Rate) - at(0f);
                if (add && time >= -halfFrame && time <= end + halfFrame)
                {
                    events.Add(new AnimationEvent
                    {
                        time = Math.Max(0f, Math.Min(time, end)),
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
