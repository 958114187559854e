namespace Football.Physics;

/// <summary>A place at which the ball is to touch something: of its centre, on the surface that lies a radius off the thing. It moves along that surface by two numbers.</summary>
internal struct BankShotContact
{
    /// <summary>A place is put back onto a surface that is curved in so many steps.</summary>
    private const int MostRaises = 8;

    /// <summary>What is touched.</summary>
    public Collider Thing;

    /// <summary>Centre of the ball, m.</summary>
    public Vector3d Place;

    /// <summary>Normal of the thing there.</summary>
    public Vector3d Normal;

    /// <summary>How the normal turns with the place, 1/m.</summary>
    public SymmetricMatrix3d Curvature;

    /// <summary>The directions along the surface: level, and as steep as it gets.</summary>
    public Vector3d Level;
    public Vector3d Steep;

    /// <summary>Goes to the place on the surface nearest to one.</summary>
    public void GoTo(in Vector3d near, double radius)
    {
        Place = near;
        ShapePoint at = Thing.At(in Place);
        for (int i = 0; i < MostRaises && Math.Abs(at.Distance - radius) > 1e-12; i++)
        {
            Place += (radius - at.Distance) * at.Normal;
            at = Thing.At(in Place);
        }

        Normal = at.Normal;
        Curvature = at.Curvature;
        Axes(in Normal, out Level, out Steep);
    }

    /// <summary>Two directions across a third one, of which the first is level.</summary>
    public static void Axes(in Vector3d direction, out Vector3d level, out Vector3d steep)
    {
        var flat = new Vector3d(direction.Z, 0, -direction.X);
        double size = flat.Length;
        level = size > 1e-9 ? flat / size : new Vector3d(1, 0, 0);
        steep = Vector3d.Cross(in direction, in level);
    }
}
