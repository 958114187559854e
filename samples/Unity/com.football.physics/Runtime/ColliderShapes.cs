using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Converts Unity's colliders to the library's shapes, in the frame of their transform without its scale.</summary>
    /// <remarks>A CharacterController stands upright however its transform is turned: its frame is at its centre, and does not turn.</remarks>
    internal static class ColliderShapes
    {
        /// <summary>True if the library has the shape of the collider.</summary>
        public static bool HasShape(Collider collider)
        {
            return collider is SphereCollider || collider is CapsuleCollider || collider is BoxCollider || collider is CharacterController;
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

        /// <summary>Returns the origin and the rotation of the frame of the collider's shape.</summary>
        public static Pose PoseOf(Collider collider)
        {
            Vector3 place = collider.transform.position;
            Quaternion turned = collider.transform.rotation;
            if (!(collider is CharacterController controller))
            {
                return new Pose(place, turned);
            }

            Vector3 scale = collider.transform.lossyScale;
            Vector3 center = controller.center;
            return new Pose(place + (turned * new Vector3(center.x * scale.x, center.y * scale.y, center.z * scale.z)), Quaternion.identity);
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
                    return Capsule(Scaled(capsule.center, scale), capsule.direction, capsule.radius * across, 0.5 * capsule.height * along);
                case CharacterController controller:
                    return Capsule(Vector3d.Zero, 1, controller.radius * Math.Max(x, z), 0.5 * controller.height * y);
                default:
                    return null;
            }
        }

        /// <summary>Returns a capsule along an axis, or the sphere that a short one is.</summary>
        private static IShape Capsule(Vector3d center, int direction, double radius, double halfHeight)
        {
            double half = halfHeight - radius;
            if (half <= 0)
            {
                return new SphereShape(center, radius);
            }

            Vector3d axis = half * new Vector3d(direction == 0 ? 1 : 0, direction == 1 ? 1 : 0, direction == 2 ? 1 : 0);
            return new CapsuleShape(center - axis, center + axis, radius);
        }

        private static Vector3d Scaled(Vector3 v, Vector3 scale)
        {
            return UnityFrame.FromUnity(new Vector3(v.x * scale.x, v.y * scale.y, v.z * scale.z));
        }
    }
}
