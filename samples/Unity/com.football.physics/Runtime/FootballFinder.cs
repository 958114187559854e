using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Finds objects that a component needs and that the inspector does not set.</summary>
    internal static class FootballFinder
    {
        /// <summary>Returns the first ball of the scene; null if there is none.</summary>
        public static FootballBall Ball()
        {
#if UNITY_2023_1_OR_NEWER
            return Object.FindAnyObjectByType<FootballBall>();
#else
            return Object.FindObjectOfType<FootballBall>();
#endif
        }

        /// <summary>Returns all goals of the scene.</summary>
        public static FootballGoal[] Goals()
        {
#if UNITY_6000_4_OR_NEWER
            return Object.FindObjectsByType<FootballGoal>();
#elif UNITY_2023_1_OR_NEWER
            return Object.FindObjectsByType<FootballGoal>(FindObjectsSortMode.None);
#else
            return Object.FindObjectsOfType<FootballGoal>();
#endif
        }
    }
}
