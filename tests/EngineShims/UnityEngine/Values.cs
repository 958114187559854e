namespace UnityEngine
{
    public struct Vector3
    {
        public float x;
        public float y;
        public float z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public static Vector3 zero => default;

        public static Vector3 forward => new Vector3(0f, 0f, 1f);

        public static float Dot(Vector3 a, Vector3 b) => (a.x * b.x) + (a.y * b.y) + (a.z * b.z);

        public readonly float magnitude => (float)System.Math.Sqrt((x * x) + (y * y) + (z * z));

        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);

        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);

        public static Vector3 operator *(Vector3 a, float s) => new Vector3(a.x * s, a.y * s, a.z * s);
    }

    public struct Quaternion
    {
        public float x;
        public float y;
        public float z;
        public float w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public static Quaternion Euler(float x, float y, float z) => new Quaternion(0f, 0f, (float)System.Math.Sin(z * System.Math.PI / 360), (float)System.Math.Cos(z * System.Math.PI / 360));

        public static Quaternion identity => new Quaternion(0f, 0f, 0f, 1f);
    }

    public struct Ray
    {
        public Ray(Vector3 origin, Vector3 direction)
        {
            this.origin = origin;
            this.direction = direction;
        }

        public Vector3 origin { get; set; }

        public Vector3 direction { get; set; }
    }

    public struct LayerMask
    {
        public int value { get; set; }

        public static implicit operator LayerMask(int value) => new LayerMask { value = value };
    }

    public struct RaycastHit
    {
        public Collider collider { get; set; }

        public Vector3 point { get; set; }

        public Vector3 normal { get; set; }

        public float distance { get; set; }
    }

    public struct Color
    {
        public float r;
        public float g;
        public float b;
        public float a;

        public Color(float r, float g, float b, float a)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            this.a = a;
        }

        public static Color yellow => new Color(1f, 0.92f, 0.016f, 1f);
    }
}
