namespace FootballPhysics.Labs.Rebounds;

/// <summary>The shape of an object that balls meet.</summary>
internal enum MoverShape
{
    Sphere,
    Capsule,
    Box,
}

/// <summary>The kind of an object that balls meet.</summary>
internal enum MoverKind
{
    Standing,
    Obstacle,
    Body,
    Engine,
}

/// <summary>An object that balls meet: its shape, its material and its motion, with a geometry that does not call the library's shapes.</summary>
internal sealed class Mover
{
    /// <summary>The radius of a sphere in X; the radius of a capsule in X and half its length in Y, along its own y; the half sizes of a box.</summary>
    public required Vector3d Size { get; init; }

    public required MoverShape Shape { get; init; }

    public required MoverKind Kind { get; init; }

    /// <summary>The position at time 0, m.</summary>
    public required Vector3d Origin { get; init; }

    public required Quaterniond Orientation { get; init; }

    public required Vector3d Velocity { get; init; }

    /// <summary>The spin about the origin, rad/s.</summary>
    public Vector3d Spin { get; init; }

    public double Mass { get; init; } = double.PositiveInfinity;

    public required double Restitution { get; init; }

    public required double TangentialRestitution { get; init; }

    public required double Friction { get; init; }

    /// <summary>The distance of the farthest point of the surface from the origin, m.</summary>
    public double Reach => Shape == MoverShape.Box ? Size.Length : Size.X + Size.Y;

    public SurfaceMaterial Surface => Material(Restitution, TangentialRestitution, Friction);

    /// <summary>Returns a material with one restitution for all speeds, and no friction other than that of impacts.</summary>
    public static SurfaceMaterial Material(double restitution, double tangential, double friction) => SurfaceMaterial.Boot with
    {
        NormalRestitution = restitution,
        RestitutionSpeedScale = double.PositiveInfinity,
        GrazingRestitutionGain = 0,
        TangentialRestitution = tangential,
        ImpactFriction = friction,
        TorsionalPatchRadius = 0,
    };

    /// <summary>Returns the position and the orientation at a time, if nothing pushes the object.</summary>
    public MoverPose At(double time)
    {
        double rate = Spin.Length;
        Quaterniond turned = rate > 0 ? (Quaterniond.FromAxisAngle(Spin / rate, rate * time) * Orientation).Normalized() : Orientation;
        return new MoverPose(Origin + (time * Velocity), turned);
    }

    /// <summary>Returns the distance from a point to the surface, and the direction away from the surface.</summary>
    public (double Distance, Vector3d Normal) From(in Vector3d point, in MoverPose pose)
    {
        Vector3d local = pose.ToLocal(in point);
        Vector3d nearest = Shape switch
        {
            MoverShape.Sphere => Vector3d.Zero,
            MoverShape.Capsule => new Vector3d(0, Math.Clamp(local.Y, -Size.Y, Size.Y), 0),
            _ => new Vector3d(Math.Clamp(local.X, -Size.X, Size.X), Math.Clamp(local.Y, -Size.Y, Size.Y), Math.Clamp(local.Z, -Size.Z, Size.Z)),
        };
        Vector3d way = local - nearest;
        double length = way.Length;
        double radius = Shape == MoverShape.Box ? 0 : Size.X;
        return length > 0 ? (length - radius, pose.Orientation.Rotate(way / length)) : (-radius, Vector3d.Up);
    }

    /// <summary>Returns the shape for the library, about the origin or at the position at time 0.</summary>
    public IShape ToShape(bool isPlaced)
    {
        Vector3d at = isPlaced ? Origin : Vector3d.Zero;
        Quaterniond turned = isPlaced ? Orientation : Quaterniond.Identity;
        Vector3d axis = turned.Rotate(new Vector3d(0, Size.Y, 0));
        return Shape switch
        {
            MoverShape.Sphere => new SphereShape(at, Size.X),
            MoverShape.Capsule => new CapsuleShape(at - axis, at + axis, Size.X),
            _ => new BoxShape(at, Size, turned),
        };
    }
}

/// <summary>A position and an orientation.</summary>
internal readonly record struct MoverPose(Vector3d Origin, Quaterniond Orientation)
{
    public Vector3d ToLocal(in Vector3d point) => new Quaterniond(-Orientation.X, -Orientation.Y, -Orientation.Z, Orientation.W).Rotate(point - Origin);
}
