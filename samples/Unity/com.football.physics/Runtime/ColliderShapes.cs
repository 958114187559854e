using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Converts Unity's colliders to the library's shapes, in the frame of their transform without its scale.</summary>
    internal static class ColliderShapes
    {
        /// <summary>True if the library has the shape of the collider.</summary>
        public static bool HasShape(Collider collider)
        {
            return collider is SphereCollider || collider is CapsuleCollider || collider is BoxCollider;
        }

        /// <summary>Converts a collider. Its surface is that of the FootballSurface on its game object.</summary>
        /// <param name="collider">The collider.</param>
        /// <param name="mass">The mass in impacts, kg; infinite if the collider does not move.</param>
        public static EngineCollider Make(Collider collider, double mass)
        {
            SurfaceMaterial surface = collider.TryGetComponent(out FootballSurface given) ? given.Surface : SurfaceMaterial.GoalFrame;
            IShape shape = Shape(collider);
            return shape == null
                ? new EngineCollider(collider.gameObject.name, surface) { Mass = mass }
                : new EngineCollider(collider.gameObject.name, shape, surface) { Mass = mass };
        }

        private static IShape Shape(Collider collider)
        {
            Vector3 scale = collider.transform.lossyScale;
            float x = Math.Abs(scale.x);
            float y = Math.Abs(scale.y);
            float z = Math.Abs(scale.z);
            switch (collider)
            {
                case SphereCollider sphere:
                    return new SphereShape(Scaled(sphere.center, scale), sphere.radius * Math.Max(x, Math.Max(y, z)));
                case BoxCollider box:
                    return new BoxShape(Scaled(box.center, scale), new Vector3d(0.5 * box.size.x * x, 0.5 * box.size.y * y, 0.5 * box.size.z * z));
                case CapsuleCollider capsule:
                    float along = capsule.direction == 0 ? x : capsule.direction == 1 ? y : z;
                    float across = capsule.direction == 0 ? Math.Max(y, z) : capsule.direction == 1 ? Math.Max(x, z) : Math.Max(x, y);
                    double radius = capsule.radius * across;
                    double half = (0.5 * capsule.height * along) - radius;
                    Vector3d center = Scaled(capsule.center, scale);
                    if (half <= 0)
                    {
                        return new SphereShape(center, radius);
                    }

                    Vector3d axis = half * new Vector3d(capsule.direction == 0 ? 1 : 0, capsule.direction == 1 ? 1 : 0, capsule.direction == 2 ? 1 : 0);
                    return new CapsuleShape(center - axis, center + axis, radius);
                default:
                    return null;
            }
        }

        private static Vector3d Scaled(Vector3 v, Vector3 scale)
        {
            return UnityFrame.FromUnity(new Vector3(v.x * scale.x, v.y * scale.y, v.z * scale.z));
        }
    }
}
