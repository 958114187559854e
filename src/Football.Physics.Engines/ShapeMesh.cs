using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>A triangle mesh for drawing the objects of a scene, in the library's frame.</summary>
/// <remarks>It can represent posts and players, boards, a ball, and the lines or the ground of a pitch.</remarks>
public sealed class ShapeMesh
{
    /// <summary>The number of segments around a circle.</summary>
    private const int Around = 24;

    /// <summary>The number of segments from pole to pole of a sphere.</summary>
    private const int Down = 16;

    private readonly Vector3d[] _points;
    private readonly Vector3d[] _normals;
    private readonly double[] _picture;
    private readonly int[] _triangles;

    private ShapeMesh(Vector3d[] points, Vector3d[] normals, double[] picture, int[] triangles)
    {
        _points = points;
        _normals = normals;
        _picture = picture;
        _triangles = triangles;
    }

    /// <summary>The corners of the triangles, in m.</summary>
    public ReadOnlySpan<Vector3d> Points => _points;

    /// <summary>The outward unit normals at the corners.</summary>
    public ReadOnlySpan<Vector3d> Normals => _normals;

    /// <summary>The texture coordinates of each corner, from the left and from the top, 0 … 1; two numbers each.</summary>
    /// <remarks>A ball uses the image of <see cref="BallPattern"/>. Empty if there is no texture.</remarks>
    public ReadOnlySpan<double> TextureCoordinates => _picture;

    /// <summary>The triangles: three point indices each, clockwise seen from outside.</summary>
    /// <remarks>A mirrored frame keeps this order, because it also mirrors the view.</remarks>
    public ReadOnlySpan<int> Triangles => _triangles;

    /// <summary>Creates the mesh of a ball, with the texture coordinates of <see cref="BallPattern"/>.</summary>
    /// <param name="radius">The radius, in m; above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="radius"/> is not above 0.</exception>
    public static ShapeMesh OfBall(double radius)
    {
        Check.Positive(nameof(radius), radius);
        return Round(new Vector3d(0, 0, 0), new Vector3d(0, 0, 0), radius, 2 * Around, Down);
    }

    /// <summary>Creates the mesh of a capsule, such as a post, a bar or a player.</summary>
    /// <param name="shape">The capsule.</param>
    /// <exception cref="ArgumentNullException"><paramref name="shape"/> is null.</exception>
    public static ShapeMesh Of(CapsuleShape shape)
    {
        Check.Given(nameof(shape), shape);
        return Round(shape.To, shape.From, shape.Radius, Around, Down);
    }

    /// <summary>Creates the mesh of a box.</summary>
    /// <param name="shape">The box.</param>
    /// <exception cref="ArgumentNullException"><paramref name="shape"/> is null.</exception>
    public static ShapeMesh Of(BoxShape shape)
    {
        Check.Given(nameof(shape), shape);
        var points = new List<Vector3d>();
        var normals = new List<Vector3d>();
        var triangles = new List<int>();
        Vector3d[] axes = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)];
        for (int axis = 0; axis < 3; axis++)
        {
            foreach (double side in new[] { -1.0, 1.0 })
            {
                Vector3d normal = side * axes[axis];
                Vector3d right = axes[(axis + 1) % 3];
                Vector3d up = Vector3d.Cross(in normal, in right);
                int first = points.Count;
                foreach ((double a, double b) in new[] { (-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0) })
                {
                    Vector3d corner = normal + (a * right) + (b * up);
                    points.Add(shape.Center + shape.Rotation.Rotate(new Vector3d(corner.X * shape.HalfSize.X, corner.Y * shape.HalfSize.Y, corner.Z * shape.HalfSize.Z)));
                    normals.Add(shape.Rotation.Rotate(normal));
                }

                // Up and then right, which is clockwise seen from outside because up = normal × right.
                triangles.AddRange([first, first + 1, first + 2, first, first + 2, first + 3]);
            }
        }

        return new ShapeMesh([.. points], [.. normals], [], [.. triangles]);
    }

    /// <summary>Creates the mesh of a pitch's lines, centred at the origin at y = 0.</summary>
    /// <remarks>The lines follow Law 1, or the futsal rules if the goals are narrower than 5 m.</remarks>
    /// <param name="pitch">The pitch.</param>
    /// <param name="lineWidth">The width of the lines, in m; above 0, at most 1; default 0.12, the maximum that the Laws allow.</param>
    /// <exception cref="ArgumentNullException"><paramref name="pitch"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="lineWidth"/> is out of range.</exception>
    public static ShapeMesh LinesOf(Pitch pitch, double lineWidth = 0.12)
    {
        Check.Given(nameof(pitch), pitch);
        Check.Within(nameof(lineWidth), lineWidth, 0, 1, exclusiveLow: true);
        var lines = new PitchMarkings(pitch, lineWidth);
        return Level(lines.Points, lines.Triangles);
    }

    /// <summary>Creates the mesh of a pitch's ground with a margin around it, at y = 0.</summary>
    /// <param name="pitch">The pitch.</param>
    /// <param name="margin">The width of the margin beyond the lines, in m; not negative; default 5.</param>
    /// <exception cref="ArgumentNullException"><paramref name="pitch"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="margin"/> is negative.</exception>
    public static ShapeMesh GroundOf(Pitch pitch, double margin = 5)
    {
        Check.Given(nameof(pitch), pitch);
        Check.NotNegative(nameof(margin), margin);
        double x = (0.5 * pitch.Width) + margin;
        double z = (0.5 * pitch.Length) + margin;
        return Level([new(-x, 0, -z), new(x, 0, -z), new(x, 0, z), new(-x, 0, z)], [0, 1, 2, 0, 2, 3]);
    }

    private static ShapeMesh Level(Vector3d[] points, int[] triangles)
    {
        var normals = new Vector3d[points.Length];
        Array.Fill(normals, Vector3d.Up);
        return new ShapeMesh(points, normals, [], triangles);
    }

    /// <summary>Creates two hemispheres around two points, the first on top, and the surface between them.</summary>
    private static ShapeMesh Round(Vector3d top, Vector3d bottom, double radius, int around, int down)
    {
        Vector3d axis = top == bottom ? Vector3d.Up : (top - bottom).Normalized();
        Vector3d cross = Vector3d.Cross(Vector3d.Up, in axis);
        Quaterniond turn = axis.Y < -0.999999
            ? new Quaterniond(1, 0, 0, 0)
            : new Quaterniond(cross.X, cross.Y, cross.Z, 1.0 + axis.Y).Normalized();

        // The middle row appears twice, once at each end.
        int rows = down + 2;
        int columns = around + 1;
        var points = new Vector3d[rows * columns];
        var normals = new Vector3d[points.Length];
        double[] picture = new double[2 * points.Length];
        var triangles = new List<int>();
        for (int row = 0; row < rows; row++)
        {
            double v = (double)(row <= down / 2 ? row : row - 1) / down;
            for (int column = 0; column < columns; column++)
            {
                int at = (row * columns) + column;
                double u = (double)column / around;
                normals[at] = turn.Rotate(BallPattern.Direction(u, v));
                points[at] = (row <= down / 2 ? top : bottom) + (radius * normals[at]);
                picture[2 * at] = u;
                picture[(2 * at) + 1] = v;
                if (row + 1 < rows && column < around)
                {
                    // Seen from outside, z towards x runs to the right, and the next row is below.
                    triangles.AddRange([at, at + 1, at + columns + 1, at, at + columns + 1, at + columns]);
                }
            }
        }

        return new ShapeMesh(points, normals, picture, [.. triangles]);
    }
}
