using UnityEditor;
using UnityEngine;

namespace FootballPhysics.Unity.Editor
{
    /// <summary>The menu GameObject → Football, which adds the prefabs of the package at useful positions.</summary>
    public static class FootballMenu
    {
        private const string Prefabs = "Packages/com.football.physics/Prefabs/";

        /// <summary>Adds a ball.</summary>
        [MenuItem("GameObject/Football/Football", false, 10)]
        public static void AddBall(MenuCommand command)
        {
            Add("Football", command);
        }

        /// <summary>Adds a goal, 20 m ahead of the origin.</summary>
        [MenuItem("GameObject/Football/Goal", false, 11)]
        public static void AddGoal(MenuCommand command)
        {
            Add("Goal", command);
        }

        /// <summary>Adds a pitch by Law 1 with its two goals.</summary>
        [MenuItem("GameObject/Football/Pitch with Goals", false, 12)]
        public static void AddPitch(MenuCommand command)
        {
            Add("Pitch", command);
        }

        /// <summary>Adds a futsal pitch with its two goals.</summary>
        [MenuItem("GameObject/Football/Futsal Pitch with Goals", false, 13)]
        public static void AddFutsalPitch(MenuCommand command)
        {
            Add("Futsal Pitch", command);
        }

        /// <summary>Adds a wall of five players.</summary>
        [MenuItem("GameObject/Football/Wall", false, 14)]
        public static void AddWall(MenuCommand command)
        {
            Add("Wall", command);
        }

        /// <summary>Adds a goalkeeper.</summary>
        [MenuItem("GameObject/Football/Keeper", false, 15)]
        public static void AddKeeper(MenuCommand command)
        {
            Add("Keeper", command);
        }

        /// <summary>Adds shooting by mouse, with the path and a score.</summary>
        [MenuItem("GameObject/Football/Shooting by Mouse", false, 16)]
        public static void AddShooting(MenuCommand command)
        {
            Add("Shooting", command);
        }

        private static void Add(string name, MenuCommand command)
        {
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(Prefabs + name + ".prefab");
            var made = (GameObject)PrefabUtility.InstantiatePrefab(prefab);
            GameObjectUtility.SetParentAndAlign(made, command.context as GameObject);
            Undo.RegisterCreatedObjectUndo(made, "Add " + name);
            Selection.activeObject = made;
        }
    }
}
