using System.Collections.Generic;

namespace UnityEngine
{
    public enum QueryTriggerInteraction
    {
        UseGlobal,
        Ignore,
        Collide,
    }

    /// <summary>Queries among the colliders that a test has put there, in single precision as the engine has it.</summary>
    public static class Physics
    {
        private const int MostSteps = 200;
        private const float Touching = 1e-5f;

        public static Vector3 gravity { get; set; } = new Vector3(0f, -9.81f, 0f);

        public static List<Collider> All { get; } = new List<Collider>();

        public static int SphereCastNonAlloc(
            Vector3 origin, float radius, Vector3 direction, RaycastHit[] results, float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
        {
            int count = 0;
            for (int i = 0; i < All.Count && count < results.Length; i++)
            {
                if (!Ignores(All[i], queryTriggerInteraction) && March(All[i], origin, radius, direction, maxDistance, out RaycastHit hit))
                {
                    // As the engine does for what the sphere touches at its start.
                    results[count++] = hit.distance > 0f ? hit : new RaycastHit { collider = All[i], normal = direction * -1f };
                }
            }

            return count;
        }

        public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
        {
            int count = 0;
            for (int i = 0; i < All.Count && count < results.Length; i++)
            {
                if (!Ignores(All[i], queryTriggerInteraction) && Distance(All[i], position) <= radius)
                {
                    results[count++] = All[i];
                }
            }

            return count;
        }

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

        private static bool Ignores(Collider collider, QueryTriggerInteraction triggers) => collider.isTrigger && triggers == QueryTriggerInteraction.Ignore;

        private static float Distance(Collider collider, Vector3 point) => collider.Distance(Turned(point - collider.transform.position, collider.transform.rotation, -1f));

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
