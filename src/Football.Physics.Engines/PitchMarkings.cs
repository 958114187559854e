namespace FootballPhysics.Engines;

/// <summary>Draws the lines of a pitch as specified in Law 1 of the game, or by futsal rules if its goals are narrower than 5 m.</summary>
internal sealed class PitchMarkings
{
    /// <summary>The radius of the centre circle and of the penalty arcs, in m.</summary>
    private const double CircleRadius = 9.15;

    private const int Parts = 64;

    private readonly List<Vector3d> _points = [];
    private readonly List<int> _triangles = [];
    private readonly double _half;

    /// <summary>Draws all lines, with the centre of the pitch at the origin.</summary>
    public PitchMarkings(Pitch pitch, double lineWidth)
    {
        _half = 0.5 * lineWidth;
        double x = 0.5 * pitch.Width;
        double z = 0.5 * pitch.Length;
        Rectangle(-x, -z, x, z);
        Line(-x, 0, x, 0);
        Spot(0, 0);
        bool futsal = pitch.Goal.Width < 5;
        Arc(0, 0, futsal ? 3 : CircleRadius, 0, 1);
        foreach (double end in new[] { -1.0, 1.0 })
        {
            foreach (double side in new[] { -1.0, 1.0 })
            {
                // Add a quarter circle in each corner, inside the pitch.
                Arc(side * x, end * z, futsal ? 0.25 : 1, Turn(-side, -end) - 0.125, Turn(-side, -end) + 0.125);
            }

            if (futsal)
            {
                Futsal(pitch, end, z);
            }
            else
            {
                Areas(pitch, end, z);
            }
        }
    }

    /// <summary>The corners of the triangles, in m.</summary>
    public Vector3d[] Points => [.. _points];

    /// <summary>The triangles: three point indices each, clockwise seen from above.</summary>
    public int[] Triangles => [.. _triangles];

    private void Areas(Pitch pitch, double end, double z)
    {
        double post = 0.5 * pitch.Goal.Width;
        Area(post + 16.5, 16.5, end, z);
        Area(post + 5.5, 5.5, end, z);
        Spot(0, end * (z - 11));

        // Add the part of the circle around the penalty mark that is outside the area: cos φ = 5.5/9.15.
        const double HalfArc = 0.1474;
        double inwards = Turn(0, -end);
        Arc(0, end * (z - 11), CircleRadius, inwards - HalfArc, inwards + HalfArc);
    }

    private void Futsal(Pitch pitch, double end, double z)
    {
        double post = 0.5 * pitch.Goal.Width;
        double inwards = Turn(0, -end);
        foreach (double side in new[] { -1.0, 1.0 })
        {
            double aside = Turn(side, 0);
            double middle = 0.5 * (inwards + (Math.Abs(inwards - aside) > 0.5 ? aside + Math.Sign(inwards - aside) : aside));
            Arc(side * post, end * z, 6, middle - 0.125, middle + 0.125);
        }

        Line(-post, end * (z - 6), post, end * (z - 6));
        Spot(0, end * (z - 6));
        Spot(0, end * (z - 10));
    }

    private void Area(double x, double depth, double end, double z)
    {
        Line(-x, end * z, -x, end * (z - depth));
        Line(x, end * z, x, end * (z - depth));
        Line(-x, end * (z - depth), x, end * (z - depth));
    }

    private void Rectangle(double x0, double z0, double x1, double z1)
    {
        Line(x0, z0, x1, z0);
        Line(x0, z1, x1, z1);
        Line(x0, z0, x0, z1);
        Line(x1, z0, x1, z1);
    }

    /// <summary>Adds a straight line, including its end caps.</summary>
    private void Line(double x0, double z0, double x1, double z1)
    {
        bool alongX = z0 == z1;
        (double low, double high) = alongX ? (Math.Min(x0, x1), Math.Max(x0, x1)) : (Math.Min(z0, z1), Math.Max(z0, z1));
        (low, high) = (low - _half, high + _half);
        Quad(
            alongX ? new Vector3d(low, 0, z0 - _half) : new Vector3d(x0 - _half, 0, low),
            alongX ? new Vector3d(high, 0, z0 - _half) : new Vector3d(x0 + _half, 0, low),
            alongX ? new Vector3d(high, 0, z0 + _half) : new Vector3d(x0 + _half, 0, high),
            alongX ? new Vector3d(low, 0, z0 + _half) : new Vector3d(x0 - _half, 0, high));
    }

    private void Spot(double x, double z) => Ring(x, z, 0, 2 * _half, 0, 1);

    private void Arc(double x, double z, double radius, double from, double to) => Ring(x, z, radius - _half, radius + _half, from, to);

    /// <summary>Adds a part of a ring; angles are in turns from x towards z.</summary>
    private void Ring(double x, double z, double inner, double outer, double from, double to)
    {
        for (int i = 0; i < Parts; i++)
        {
            Vector3d a = Around(from + ((to - from) * i / Parts));
            Vector3d b = Around(from + ((to - from) * (i + 1) / Parts));
            var middle = new Vector3d(x, 0, z);
            Quad(middle + (inner * a), middle + (outer * a), middle + (outer * b), middle + (inner * b));
        }
    }

    /// <summary>Adds a quadrilateral whose corners run from x to z: clockwise seen from above, with x to the right and z down the page.</summary>
    private void Quad(Vector3d a, Vector3d b, Vector3d c, Vector3d d)
    {
        int first = _points.Count;
        _points.AddRange([a, b, c, d]);
        _triangles.AddRange([first, first + 1, first + 2, first, first + 2, first + 3]);
    }

    private static Vector3d Around(double turns) => Quaterniond.FromAxisAngle(Vector3d.Up, -2.0 * Math.PI * turns).Rotate(new Vector3d(1, 0, 0));

    /// <summary>Returns the direction of two signs (x, z), in turns.</summary>
    private static double Turn(double x, double z) => (Math.Sign(x), Math.Sign(z)) switch
    {
        (1, 0) => 0,
        (1, 1) => 0.125,
        (0, 1) => 0.25,
        (-1, 1) => 0.375,
        (-1, 0) => 0.5,
        (-1, -1) => 0.625,
        (0, -1) => 0.75,
        _ => 0.875,
    };
}
