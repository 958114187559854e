using System;
using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MenuItem : Attribute
    {
        public MenuItem(string itemName) => menuItem = itemName;

        public MenuItem(string itemName, bool isValidateFunction, int priority)
            : this(itemName) => this.priority = priority;

        public string menuItem { get; }

        public int priority { get; }
    }

    public sealed class MenuCommand
    {
        public MenuCommand(UnityEngine.Object? context) => this.context = context;

        public UnityEngine.Object? context { get; }
    }

    /// <summary>Gives what a test has put there.</summary>
    public static class AssetDatabase
    {
        public static Func<string, UnityEngine.Object?> Assets { get; set; } = path => null;

        public static T? LoadAssetAtPath<T>(string assetPath)
            where T : UnityEngine.Object => (T?)Assets(assetPath);
    }

    public static class PrefabUtility
    {
        /// <summary>In the shim the prefab itself.</summary>
        public static UnityEngine.Object InstantiatePrefab(UnityEngine.Object assetComponentOrGameObject) => assetComponentOrGameObject;
    }

    public static class GameObjectUtility
    {
        public static void SetParentAndAlign(GameObject child, GameObject? parent) => child.transform.SetParent(parent is null ? null : parent.transform);
    }

    public static class Selection
    {
        public static UnityEngine.Object? activeObject { get; set; }
    }

    public static class EditorApplication
    {
        public static double timeSinceStartup { get; set; }
    }

    public class EditorWindow : ScriptableObject
    {
        public static T GetWindow<T>(string title)
            where T : EditorWindow => CreateInstance<T>();

        public void Repaint()
        {
        }
    }

    public sealed class SceneView : EditorWindow
    {
        public static event Action<SceneView>? duringSceneGui;

        public static void RepaintAll() => duringSceneGui?.Invoke(new SceneView());
    }

    public enum BuildTargetGroup
    {
        Unknown,
        Standalone = 1,
        Android = 7,
    }

    public enum ScriptingImplementation
    {
        Mono2x,
        IL2CPP,
        WinRTDotNET,
    }

    public static class PlayerSettings
    {
        /// <summary>What a test has chosen.</summary>
        public static ScriptingImplementation Backend { get; set; }

        public static ScriptingImplementation GetScriptingBackend(Build.NamedBuildTarget buildTarget) => Backend;

        public static Build.Il2CppCodeGeneration GetIl2CppCodeGeneration(Build.NamedBuildTarget buildTarget) => EditorUserBuildSettings.il2CppCodeGeneration;
    }

    public static class EditorUserBuildSettings
    {
        public static Build.Il2CppCodeGeneration il2CppCodeGeneration { get; set; }
    }
}

namespace UnityEditor.Build
{
    public enum Il2CppCodeGeneration
    {
        OptimizeSpeed,
        OptimizeSize,
    }

    public readonly struct NamedBuildTarget
    {
        public static NamedBuildTarget FromBuildTargetGroup(BuildTargetGroup buildTargetGroup) => default;
    }

    public interface IOrderedCallback
    {
        int callbackOrder { get; }
    }

    public interface IPreprocessBuildWithReport : IOrderedCallback
    {
        void OnPreprocessBuild(Reporting.BuildReport report);
    }
}

namespace UnityEditor.Build.Reporting
{
    public sealed class BuildReport : UnityEngine.Object
    {
        public BuildSummary summary => default;
    }

    public struct BuildSummary
    {
        public BuildTargetGroup platformGroup { get; set; }
    }
}
