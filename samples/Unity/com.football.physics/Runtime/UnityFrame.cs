using FootballPhysics.Engines;

namespace FootballPhysics.Unity
{
    /// <summary>Conversions between the library's types and Unity's, through the one mapping of handedness.</summary>
    public static class UnityFrame
    {
        /// <summary>A position, velocity or direction of Unity's, for the library.</summary>
        public static Vector3d FromUnity(UnityEngine.Vector3 vector)
        {
            return EngineFrame.LeftHanded.Vector(new Vector3d(vector.x, vector.y, vector.z));
        }

        /// <summary>A spin of Unity's (like Rigidbody.angularVelocity), for the library.</summary>
        public static Vector3d SpinFromUnity(UnityEngine.Vector3 spin)
        {
            return EngineFrame.LeftHanded.Spin(new Vector3d(spin.x, spin.y, spin.z));
        }

        /// <summary>A position, velocity or direction of the library's, for Unity.</summary>
        public static UnityEngine.Vector3 ToUnity(Vector3d vector)
        {
            return Rounded(EngineFrame.LeftHanded.Vector(vector));
        }

        /// <summary>A spin of the library's, for Unity.</summary>
        public static UnityEngine.Vector3 SpinToUnity(Vector3d spin)
        {
            return Rounded(EngineFrame.LeftHanded.Spin(spin));
        }

        /// <summary>A rotation of the library's, for Unity.</summary>
        public static UnityEngine.Quaternion ToUnity(Quaterniond rotation)
        {
            Quaterniond q = EngineFrame.LeftHanded.Rotation(rotation);
            return new UnityEngine.Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
        }

        /// <summary>A rotation of Unity's, for the library.</summary>
        public static Quaterniond FromUnity(UnityEngine.Quaternion rotation)
        {
            return EngineFrame.LeftHanded.Rotation(new Quaterniond(rotation.x, rotation.y, rotation.z, rotation.w));
        }

        private static UnityEngine.Vector3 Rounded(Vector3d v)
        {
            return new UnityEngine.Vector3((float)v.X, (float)v.Y, (float)v.Z);
        }
    }
}
