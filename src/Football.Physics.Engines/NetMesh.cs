using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>A net as points and threads, for drawing. It hangs flat, and bulges at the position of the ball.</summary>
public sealed class NetMesh
{
    /// <summary>The width of a bulge, in m: at this distance from its centre, the depth is 1/e.</summary>
    private const double BulgeWidth = 0.75;

    /// <summary>The maximum number of mesh cells along a side.</summary>
    private const int Most = 120;

    private readonly Vector3d[] _flat;
    private readonly Vector3d[] _points;
    private readonly int[] _threads;
    private bool _bulges;

    /// <summary>Creates a net that hangs flat.</summary>
    /// <param name="net">The net.</param>
    /// <param name="mesh">The width of a mesh, in m; above 0, at most 10; default 0.12. It is increased if a side would have more than 120
    /// meshes.</param>
    /// <exception cref="ArgumentNullException"><paramref name="net"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public NetMesh(Net net, double mesh = 0.12)
    {
        Check.Given(nameof(net), net);
        net.Validate(nameof(net));
        Check.Within(nameof(mesh), mesh, 0, 10, exclusiveLow: true);
        Vector3d along = net.Along.Normalized();
        Vector3d across = Vector3d.Cross(net.Normal.Normalized(), along);
        int columns = Meshes(2 * net.HalfLength, mesh);
        int rows = Meshes(2 * net.HalfWidth, mesh);
        _flat = new Vector3d[(columns + 1) * (rows + 1)];
        _threads = new int[2 * ((columns * (rows + 1)) + (rows * (columns + 1)))];
        int thread = 0;
        for (int j = 0; j <= rows; j++)
        {
            for (int i = 0; i <= columns; i++)
            {
                int at = (j * (columns + 1)) + i;
                _flat[at] = net.Center + (net.HalfLength * ((2.0 * i / columns) - 1) * along) + (net.HalfWidth * ((2.0 * j / rows) - 1) * across);
                if (i < columns)
                {
                    _threads[thread++] = at;
                    _threads[thread++] = at + 1;
                }

                if (j < rows)
                {
                    _threads[thread++] = at;
                    _threads[thread++] = at + columns + 1;
                }
            }
        }

        _points = (Vector3d[])_flat.Clone();
    }

    /// <summary>The current positions of the knots, in m.</summary>
    public ReadOnlySpan<Vector3d> Points => _points;

    /// <summary>The threads, as pairs of point indices.</summary>
    public ReadOnlySpan<int> Threads => _threads;

    /// <summary>Deforms the net to a bulge, with a bell curve of 0.75 m width. Does not allocate.</summary>
    /// <param name="bulge">The bulge.</param>
    /// <returns>True if any point has moved, so that the net must be drawn again.</returns>
    public bool Follow(in NetBulge bulge)
    {
        bool before = _bulges;
        _bulges = bulge.Depth > 0;
        if (!_bulges)
        {
            if (before)
            {
                Array.Copy(_flat, _points, _flat.Length);
            }

            return before;
        }

        Vector3d middle = bulge.Position - (bulge.Depth * bulge.Direction);
        for (int i = 0; i < _flat.Length; i++)
        {
            Vector3d off = _flat[i] - middle;
            double across = Vector3d.Dot(in off, bulge.Direction);
            double far = (off.LengthSquared - (across * across)) / (BulgeWidth * BulgeWidth);
            _points[i] = far > 9 ? _flat[i] : _flat[i] + (bulge.Depth * Elementary.Exp(-far) * bulge.Direction);
        }

        return true;
    }

    private static int Meshes(double length, double mesh) => (int)Math.Max(1, Math.Min(Most, Math.Ceiling(length / mesh)));
}
