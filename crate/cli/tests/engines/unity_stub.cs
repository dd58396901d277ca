// Stub of the functions of Unity that the exported scripts call, with their documented parameters. Runs the
// commands of the script twice and removes, for an animation clip and for a model, and prints the events, or the
// clips of the model.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    public class Object { }

    public enum SendMessageOptions { RequireReceiver, DontRequireReceiver }

    public class AnimationEvent
    {
        public float time;
        public string functionName;
        public string stringParameter;
        public SendMessageOptions messageOptions;
    }

    public class AnimationClip : Object
    {
        public float length;
        internal AnimationEvent[] stored = { new AnimationEvent { time = 0.1f, functionName = "Other" } };
    }

    public static class Debug
    {
        public static void LogError(object message) { throw new Exception((string)message); }
    }
}

namespace UnityEditor
{
    using UnityEngine;

    [AttributeUsage(AttributeTargets.Method)]
    public class MenuItem : Attribute
    {
        public readonly string Path;
        public MenuItem(string itemName) { Path = itemName; }
    }

    public static class Selection { public static UnityEngine.Object[] objects; }

    public static class Undo
    {
        public static void RegisterCompleteObjectUndo(UnityEngine.Object objectToUndo, string name) { }
    }

    public static class EditorUtility { public static void SetDirty(UnityEngine.Object target) { } }

    public static class AnimationUtility
    {
        public static AnimationEvent[] GetAnimationEvents(AnimationClip clip) { return clip.stored; }
        public static void SetAnimationEvents(AnimationClip clip, AnimationEvent[] events) { clip.stored = events; }
    }

    public static class AssetDatabase
    {
        public static string GetAssetPath(UnityEngine.Object assetObject)
        {
            return assetObject is AnimationClip ? "clip.anim" : "model.fbx";
        }
    }

    public class AssetImporter
    {
        internal static ModelImporter model = new ModelImporter();
        public static AssetImporter GetAtPath(string path) { return path == "model.fbx" ? model : null; }
        public void SaveAndReimport() { }
    }

    public class ModelImporterClipAnimation
    {
        public string name = "walk";
        public string takeName = "Take 001";
        public float firstFrame = 1;
        public float lastFrame;
        public AnimationEvent[] events = { };
    }

    public class ModelImporter : AssetImporter
    {
        public ModelImporterClipAnimation[] clipAnimations = { };
        public ModelImporterClipAnimation[] defaultClipAnimations = { new ModelImporterClipAnimation() };
    }
}

static class Program
{
    static void Print(string name, IEnumerable<UnityEngine.AnimationEvent> events)
    {
        var texts = events.Select(e => string.Format(
            CultureInfo.InvariantCulture, "{0:0.000000} {1} {2}", e.time, e.functionName, e.stringParameter));
        Console.WriteLine(name + "|" + string.Join(",", texts));
    }

    // The clips of the model; the take has 25 frames per second, and begins at frame 1.
    static void PrintClips(UnityEditor.ModelImporter model)
    {
        var texts = model.clipAnimations.Select(clip => string.Format(
            CultureInfo.InvariantCulture,
            "{0:0.000000} {1:0.000000} {2} {3}",
            (clip.firstFrame - 1) / 25, (clip.lastFrame - 1) / 25, clip.takeName.Length, clip.name));
        Console.WriteLine("clips|" + string.Join(",", texts));
    }

    static void Main(string[] arguments)
    {
        var length = float.Parse(arguments[0], CultureInfo.InvariantCulture);
        var clip = new UnityEngine.AnimationClip { length = length };
        var model = UnityEditor.AssetImporter.model;
        model.defaultClipAnimations[0].lastFrame = 1 + length * 25;
        if (arguments.Length > 1)
        {
            // A clip of the second half of the take.
            model.clipAnimations = new[]
            {
                new UnityEditor.ModelImporterClipAnimation
                {
                    firstFrame = 1 + length * 12.5f, lastFrame = 1 + length * 25,
                },
            };
        }
        UnityEditor.Selection.objects = new[] { clip, new UnityEngine.Object() };
        var isScript = new Func<Type, bool>(t => t.Name.StartsWith("FootEvents_") || t.Name.StartsWith("Segments_"));
        var type = Assembly.GetExecutingAssembly().GetTypes().Single(isScript);
        foreach (var command in new[] { "Add", "Add", "Remove" })
        {
            var method = type.GetMethod(command, BindingFlags.NonPublic | BindingFlags.Static);
            var menu = ((UnityEditor.MenuItem)method.GetCustomAttributes(typeof(UnityEditor.MenuItem), false)[0]).Path;
            if (!menu.StartsWith("Assets/Plantigrade/")) throw new Exception(menu);
            method.Invoke(null, null);
            if (type.Name.StartsWith("Segments_"))
            {
                PrintClips(model);
                continue;
            }
            Print("clip", clip.stored);
            Print("model", model.clipAnimations[0].events);
        }
    }
}
