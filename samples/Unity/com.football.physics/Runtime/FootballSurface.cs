using System;
using UnityEngine;

namespace Football.Physics.Unity
{
    /// <summary>What a collider is made of, for the ball that hits it. Without one it is as a goal's frame.</summary>
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
        public Surface Surface
        {
            get
            {
                return material switch
                {
                    Material.GoalFrame => Physics.Surface.GoalFrame,
                    Material.Wood => Physics.Surface.Wood,
                    Material.Board => Physics.Surface.Board,
                    Material.Concrete => Physics.Surface.Concrete,
                    Material.Boot => Physics.Surface.Boot,
                    Material.Head => Physics.Surface.Head,
                    Material.Glove => Physics.Surface.Glove,
                    Material.Turf => Physics.Surface.Of(Ground.DryTurf),
                    _ => throw new ArgumentOutOfRangeException(nameof(material)),
                };
            }
        }
    }
}
