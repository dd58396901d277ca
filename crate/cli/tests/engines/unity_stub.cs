// Stub of the functions of Unity that the exported script calls, with their documented parameters. Runs the
// commands of the script twice and removes, for an animation clip and for a model, and prints the events.
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

    public class ModelImporterClipAnimation { public AnimationEvent[] events = { }; }

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

    static void Main(string[] arguments)
    {
        var clip = new UnityEngine.AnimationClip
        {
            length = float.Parse(arguments[0], CultureInfo.InvariantCulture),
        };
        UnityEditor.Selection.objects = new[] { clip, new UnityEngine.Object() };
        var type = Assembly.GetExecutingAssembly().GetTypes().Single(t => t.Name.StartsWith("FootEvents_"));
        foreach (var command in new[] { "Add", "Add", "Remove" })
        {
            var method = type.GetMethod(command, BindingFlags.NonPublic | BindingFlags.Static);
            var menu = ((UnityEditor.MenuItem)method.GetCustomAttributes(typeof(UnityEditor.MenuItem), false)[0]).Path;
            if (!menu.StartsWith("Assets/Plantigrade/")) throw new Exception(menu);
            method.Invoke(null, null);
            Print("clip", clip.stored);
            Print("model", UnityEditor.AssetImporter.model.clipAnimations[0].events);
        }
    }
}
