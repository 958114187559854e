using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The classic pattern of a ball, 12 dark pentagons and 20 light hexagons, as a texture that shows its rotation.</summary>
public static class BallPattern
{
    /// <summary>The brightness of a hexagon, 0 … 1.</summary>
    public const double Light = 0.97;

    /// <summary>The brightness of a pentagon, 0 … 1.</summary>
    public const double Dark = 0.1;

    /// <summary>The brightness of a seam, 0 … 1.</summary>
    public const double Seam = 0.55;

    /// <summary>The distances of the faces of a truncated icosahedron of edge 1 from its centre.</summary>
    private const double PentagonDistance = 2.3274384;
    private const double HexagonDistance = 2.2672839;

    /// <summary>Half the width of a seam, as a share of the radius.</summary>
    private const double HalfSeam = 0.012;

    private static readonly Vector3d[] s_pentagons = Corners();
    private static readonly Vector3d[] s_hexagons = Faces(s_pentagons);

    /// <summary>Returns the brightness of a point on the ball: <see cref="Light"/>, <see cref="Dark"/> or <see cref="Seam"/>.</summary>
    /// <param name="direction">The direction from the ball's centre; any length except zero.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="direction"/> is zero or not finite.</exception>
    public static double At(Vector3d direction)
    {
        Vector3d unit = Check.Direction(nameof(direction), direction);

        // A ray from the centre leaves through the face whose plane it reaches first.
        double first = 0;
        double second = 0;
        bool isDark = false;
        foreach (Vector3d face in s_pentagons)
        {
            Take(Vector3d.Dot(in unit, in face) / PentagonDistance, true, ref first, ref second, ref isDark);
        }

        foreach (Vector3d face in s_hexagons)
        {
            Take(Vector3d.Dot(in unit, in face) / HexagonDistance, false, ref first, ref second, ref isDark);
        }

        // Near an edge, two faces are almost equally close.
        return (first - second) * HexagonDistance < HalfSeam ? Seam : isDark ? Dark : Light;
    }

    /// <summary>Returns the pattern as an image of the whole sphere, with brightness 0 … 255, row by row.</summary>
    /// <remarks>Longitude runs from left to right, latitude from top (y up) to bottom.</remarks>
    /// <param name="width">The width in pixels; 4 … 4096.</param>
    /// <param name="height">The height in pixels; 2 … 4096.</param>
    /// <exception cref="ArgumentOutOfRangeException">A size is out of range.</exception>
    public static byte[] Picture(int width = 256, int height = 128)
    {
        Check.Within(nameof(width), width, 4, 4096);
        Check.Within(nameof(height), height, 2, 4096);
        byte[] pixels = new byte[width * height];
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                pixels[(y * width) + x] = (byte)((255 * At(Direction((x + 0.5) / width, (y + 0.5) / height))) + 0.5);
            }
        }

        return pixels;
    }

    /// <summary>Returns the direction of a point in the image.</summary>
    /// <param name="u">The horizontal coordinate, 0 … 1: one turn around y, from z towards x.</param>
    /// <param name="v">The vertical coordinate, 0 … 1: from y down to −y.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite.</exception>
    public static Vector3d Direction(double u, double v)
    {
        Check.Finite(nameof(u), u);
        Check.Finite(nameof(v), v);
        Quaterniond around = Quaterniond.FromAxisAngle(Vector3d.Up, 2.0 * Math.PI * u);
        Quaterniond down = Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), Math.PI * v);
        return around.Rotate(down.Rotate(Vector3d.Up));
    }

    private static void Take(double near, bool pentagon, ref double first, ref double second, ref bool isDark)
    {
        if (near > first)
        {
            second = first;
            first = near;
            isDark = pentagon;
        }
        else if (near > second)
        {
            second = near;
        }
    }

    /// <summary>Returns the corners of an icosahedron as unit vectors, which are the centres of the pentagons.</summary>
    private static Vector3d[] Corners()
    {
        double golden = 0.5 * (1 + Math.Sqrt(5));
        var corners = new List<Vector3d>();
        foreach (double a in new[] { -1.0, 1.0 })
        {
            foreach (double b in new[] { -golden, golden })
            {
                corners.Add(new Vector3d(0, a, b).Normalized());
                corners.Add(new Vector3d(a, b, 0).Normalized());
                corners.Add(new Vector3d(b, 0, a).Normalized());
            }
        }

        return [.. corners];
    }

    /// <summary>Returns the centres of the icosahedron's faces as unit vectors, which are the centres of the hexagons.</summary>
    private static Vector3d[] Faces(Vector3d[] corners)
    {
        // Two corners share an edge if they are closer than this.
        const double Edge = 1.06;
        var faces = new List<Vector3d>();
        for (int i = 0; i < corners.Length; i++)
        {
            for (int j = i + 1; j < corners.Length; j++)
            {
                for (int k = j + 1; k < corners.Length; k++)
                {
                    if (Vector3d.Distance(in corners[i], in corners[j]) < Edge && Vector3d.Distance(in corners[j], in corners[k]) < Edge && Vector3d.Distance(in corners[i], in corners[k]) < Edge)
                    {
                        faces.Add((corners[i] + corners[j] + corners[k]).Normalized());
                    }
                }
            }
        }

        return [.. faces];
    }
}
