namespace FootballPhysics.Tests.Symmetry;

/// <summary>A reflection of the world in x or in z: positions and velocities are polar vectors, spins axial ones.</summary>
internal readonly struct Mirror
{
    private readonly double _x;
    private readonly double _z;

    private Mirror(double x, double z)
    {
        _x = x;
        _z = z;
    }

    public static Mirror InX => new(-1, 1);

    public static Mirror InZ => new(1, -1);

    public Vector3d Polar(Vector3d v) => new(_x * v.X, v.Y, _z * v.Z);

    // A reflection turns axial vectors like polar ones, and then round.
    public Vector3d Axial(Vector3d v) => new(-_x * v.X, -v.Y, -_z * v.Z);

    public Quaterniond Rotation(Quaterniond q) => new(-_x * q.X, -q.Y, -_z * q.Z, q.W);

    public Scene Scene(Scene scene) => scene with { Air = scene.Air with { Wind = Polar(scene.Air.Wind) } };

    public override string ToString() => _x < 0 ? "x" : "z";
}
