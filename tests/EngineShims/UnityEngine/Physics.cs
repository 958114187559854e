using System.Collections.Generic;

namespace UnityEngine
{
    public enum QueryTriggerInteraction
    {
        UseGlobal,
        Ignore,
        Collide,
    }

    /// <summary>The colliders of a scene, and queries among those that a test has put there, in single precision as the engine has it.</summary>
    public readonly struct PhysicsScene
    {
        private static readonly Dictionary<int, List<Collider>> s_colliders = new Dictionary<int, List<Collider>>();
        private readonly int _handle;

        public PhysicsScene(int handle) => _handle = handle;

        /// <summary>What a test puts there.</summary>
        public List<Collider> All
        {
            get
            {
                if (!s_colliders.TryGetValue(_handle, out List<Collider>? all))
                {
                    all = new List<Collider>();
                    s_colliders.Add(_handle, all);
                }

                return all;
            }
        }

        public int SphereCast(
            Vector3 origin, float radius, Vector3 direction, RaycastHit[] results, float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
        {
            int count = 0;
            for (int i = 0; i < All.Count && count < results.Length; i++)
            {
                if (Sees(All[i], layerMask, queryTriggerInteraction) && Physics.March(All[i], origin, radius, direction, maxDistance, out RaycastHit hit))
                {
                    // As the engine does for what the sphere touches at its start.
                    results[count++] = hit.distance > 0f ? hit : new RaycastHit { collider = All[i], normal = direction * -1f };
                }
            }

            return count;
        }

        public int OverlapSphere(Vector3 position, float radius, Collider[] results, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
        {
            int count = 0;
            for (int i = 0; i < All.Count && count < results.Length; i++)
            {
                if (Sees(All[i], layerMask, queryTriggerInteraction) && Physics.Distance(All[i], position) <= radius)
                {
                    results[count++] = All[i];
                }
            }

            return count;
        }

        /// <summary>True for a collider that exists, in one of the layers, and is no trigger that the query ignores.</summary>
        private static bool Sees(Collider collider, int layerMask, QueryTriggerInteraction triggers) =>
            collider != null && (layerMask >> collider.gameObject.layer & 1) != 0 && !(collider.isTrigger && triggers == QueryTriggerInteraction.Ignore);
    }

    public static class PhysicsSceneExtensions
    {
        public static PhysicsScene GetPhysicsScene(this SceneManagement.Scene scene) => new PhysicsScene(scene.handle);
    }

    public static class Physics
    {
        private const int MostSteps = 200;
        private const float Touching = 1e-5f;

        public static Vector3 gravity { get; set; } = new Vector3(0f, -9.81f, 0f);

        public static PhysicsScene defaultPhysicsScene => default;

        public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results, int layerMask, QueryTriggerInteraction queryTriggerInteraction) =>
            defaultPhysicsScene.OverlapSphere(position, radius, results, layerMask, queryTriggerInteraction);

        /// <summary>The colliders of the default scene.</summary>
        public static List<Collider> All => defaultPhysicsScene.All;

        /// <summary>Moves a sphere on until it touches a collider.</summary>
        internal static bool March(Collider collider, Vector3 origin, float radius, Vector3 direction, float maxDistance, out RaycastHit hit)
        {
            float gone = 0f;
            for (int i = 0; i < MostSteps && gone <= maxDistance; i++)
            {
                Vector3 at = origin + (direction * gone);
                float gap = Distance(collider, at) - radius;
                if (gap <= Touching)
                {
                    Vector3 normal = Normal(collider, at);
                    hit = new RaycastHit { collider = collider, distance = gone, normal = normal, point = at - (normal * (gap + radius)) };
                    return true;
                }

                gone += gap;
            }

            hit = default;
            return false;
        }

        internal static float Distance(Collider collider, Vector3 point) => collider.Distance(Turned(point - collider.transform.position, collider.transform.rotation, -1f));

        private static Vector3 Normal(Collider collider, Vector3 at)
        {
            const float Step = 1e-3f;
            float x = Distance(collider, at + new Vector3(Step, 0f, 0f)) - Distance(collider, at - new Vector3(Step, 0f, 0f));
            float y = Distance(collider, at + new Vector3(0f, Step, 0f)) - Distance(collider, at - new Vector3(0f, Step, 0f));
            float z = Distance(collider, at + new Vector3(0f, 0f, Step)) - Distance(collider, at - new Vector3(0f, 0f, Step));
            var gradient = new Vector3(x, y, z);
            return gradient * (1f / gradient.magnitude);
        }

        private static Vector3 Turned(Vector3 v, Quaternion q, float sign) => new Quaternion(sign * q.x, sign * q.y, sign * q.z, q.w) * v;
    }
}
