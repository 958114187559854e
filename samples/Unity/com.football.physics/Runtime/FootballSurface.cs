using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>The material of a collider. Colliders without this component have the material of a goal frame.</summary>
    [AddComponentMenu("Football/Football Surface"), DisallowMultipleComponent]
    public sealed class FootballSurface : MonoBehaviour
    {
        /// <summary>The material.</summary>
        public Material material = Material.GoalFrame;

        /// <summary>Materials to choose from.</summary>
        public enum Material
        {
            GoalFrame,
            Wood,
            Board,
            Concrete,
            Boot,
            Head,
            Glove,
            Turf,
        }

        /// <summary>The numbers of the material.</summary>
        public SurfaceMaterial Surface
        {
            get
            {
                return material == Material.Turf ? SurfaceMaterial.MatchTurf : SurfaceMaterial.Presets[FootballPreset.NameOf(material.ToString())];
            }
        }
    }
}
