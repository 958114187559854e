using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>The numbers of a kick, for the inspector.</summary>
    [Serializable]
    public sealed class FootballKick
    {
        /// <summary>The speed, m/s.</summary>
        [Range(0f, 60f), Tooltip("Ball speed, m/s; 30 is a hard shot.")]
        public float speed = 25f;

        /// <summary>The angle above the horizontal, degrees.</summary>
        [Range(-90f, 90f), Tooltip("Angle above the horizontal, degrees.")]
        public float elevation = 15f;

        /// <summary>The angle to the right of forward, degrees, in the direction of Unity's rotations about y.</summary>
        [Range(-180f, 180f), Tooltip("Angle to the right of forward (z), degrees.")]
        public float heading;

        /// <summary>The topspin, rad/s; negative is backspin.</summary>
        [Range(-200f, 200f), Tooltip("Topspin, rad/s: positive makes the ball dip, negative is backspin.")]
        public float topSpin;

        /// <summary>The sidespin, rad/s; positive bends to the left.</summary>
        [Range(-200f, 200f), Tooltip("Sidespin, rad/s: positive bends the ball to the left.")]
        public float sideSpin;

        /// <summary>The direction of the kick, in Unity's frame.</summary>
        public Vector3 Direction
        {
            get
            {
                float up = elevation * Mathf.Deg2Rad;
                float right = heading * Mathf.Deg2Rad;
                return new Vector3(Mathf.Cos(up) * Mathf.Sin(right), Mathf.Sin(up), Mathf.Cos(up) * Mathf.Cos(right));
            }
        }

        /// <summary>Sets speed and angles from a velocity.</summary>
        public void Set(Vector3 velocity)
        {
            speed = velocity.magnitude;
            elevation = Mathf.Atan2(velocity.y, Mathf.Sqrt((velocity.x * velocity.x) + (velocity.z * velocity.z))) * Mathf.Rad2Deg;
            heading = Mathf.Atan2(velocity.x, velocity.z) * Mathf.Rad2Deg;
        }
    }
}
