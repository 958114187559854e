using FootballPhysics.Engines;

namespace FootballPhysics.Unity
{
    /// <summary>Conversions between the library's types and Unity's, with the one conversion of handedness.</summary>
    public static class UnityFrame
    {
        /// <summary>Converts a position, velocity or direction from Unity to the library.</summary>
        public static Vector3d FromUnity(UnityEngine.Vector3 vector)
        {
            return EngineFrame.LeftHanded.Vector(new Vector3d(vector.x, vector.y, vector.z));
        }

        /// <summary>Converts a spin (like Rigidbody.angularVelocity) from Unity to the library.</summary>
        public static Vector3d SpinFromUnity(UnityEngine.Vector3 spin)
        {
            return EngineFrame.LeftHanded.Spin(new Vector3d(spin.x, spin.y, spin.z));
        }

        /// <summary>Converts a position, velocity or direction from the library to Unity.</summary>
        public static UnityEngine.Vector3 ToUnity(Vector3d vector)
        {
            return Rounded(EngineFrame.LeftHanded.Vector(vector));
        }

        /// <summary>Converts a spin from the library to Unity.</summary>
        public static UnityEngine.Vector3 SpinToUnity(Vector3d spin)
        {
            return Rounded(EngineFrame.LeftHanded.Spin(spin));
        }

        /// <summary>Converts a rotation from the library to Unity.</summary>
        public static UnityEngine.Quaternion ToUnity(Quaterniond rotation)
        {
            Quaterniond q = EngineFrame.LeftHanded.Rotation(rotation);
            return new UnityEngine.Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
        }

        /// <summary>Converts a rotation from Unity to the library.</summary>
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
