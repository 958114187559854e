using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>A camera as a 3 × 4 matrix from positions to pixels.</summary>
/// <remarks>
/// (a, b, w) = matrix · (x, y, z, 1) in the library's coordinates, with y up; the pixel is u = a/w, v = b/w. u grows to the right of the image and v downwards,
/// and w is positive in front of the camera. A camera that moves or zooms is one camera per frame. Remove the distortion of the lens from the pixels beforehand.
/// </remarks>
public sealed class TrackCamera
{
    /// <summary>The number of elements of a matrix.</summary>
    private const int Size = 12;

    /// <summary>The minimum volume of the three rows, as a share of the product of their lengths. Below it, the rank is less than 3 within rounding.</summary>
    private const double LeastVolume = 1e-9;

    /// <summary>The depth below which a position is not in front of the camera, in m.</summary>
    private const double LeastDepth = 1e-3;

    private readonly double[] _matrix;

    /// <summary>Creates a camera.</summary>
    /// <param name="matrix">The matrix, row by row: 12 numbers. Any positive multiple is the same camera.</param>
    /// <exception cref="ArgumentNullException"><paramref name="matrix"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">
    /// There are not 12 finite numbers, or the left 3 × 3 part is not of rank 3, or the matrix mirrors the image or looks backwards.
    /// </exception>
    public TrackCamera(IReadOnlyList<double> matrix)
    {
        // 1. Check the matrix. 2. Scale it, so that the third row gives the depth in metres. 3. Solve for the centre, where the matrix gives 0.
        Check.Given(nameof(matrix), matrix);
        if (matrix.Count != Size)
        {
            throw Check.Refusal("matrix", FormattableString.Invariant($"a list of {matrix.Count}"), "3 rows of 4 finite numbers");
        }

        for (int i = 0; i < Size; i++)
        {
            Check.Finite(Check.Item("matrix", i), matrix[i]);
        }

        (Vector3d a, Vector3d b, Vector3d w) = (Row(matrix, 0), Row(matrix, 1), Row(matrix, 2));
        double volume = Vector3d.Dot(Vector3d.Cross(a / a.Length, b / b.Length), w / w.Length);
        if (!(Math.Abs(volume) > LeastVolume))
        {
            throw Check.Refusal("matrix", "of a rank below 3 in its left 3 × 3 part", "rank 3");
        }

        if (volume < 0)
        {
            throw Check.Refusal(
                "matrix", FormattableString.Invariant($"one with a left determinant of {volume:0.###} (rows of length 1)"),
                "a determinant above 0, with u to the right, v downwards and w positive in front of the camera; negate the second row if v points up, or all rows if w is negative");
        }

        double scale = 1 / w.Length;
        _matrix = new double[Size];
        for (int i = 0; i < Size; i++)
        {
            _matrix[i] = scale * matrix[i];
        }

        (a, b, w) = (Row(_matrix, 0), Row(_matrix, 1), Row(_matrix, 2));
        Position = -((_matrix[3] * Vector3d.Cross(b, w)) + (_matrix[7] * Vector3d.Cross(w, a)) + (_matrix[11] * Vector3d.Cross(a, b))) / Vector3d.Dot(Vector3d.Cross(a, b), w);
        if (!(Math.Max(Math.Abs(Position.X), Math.Max(Math.Abs(Position.Y), Math.Abs(Position.Z))) <= Limits.Length))
        {
            throw Check.Refusal("matrix", FormattableString.Invariant($"one of a camera at {Position}"), FormattableString.Invariant($"a camera within ±{Limits.Length} m"));
        }

        Forward = w;
    }

    /// <summary>Creates the camera with the same pixels that looks the other way.</summary>
    private TrackCamera(TrackCamera opposite)
    {
        _matrix = Array.ConvertAll(opposite._matrix, element => -element);
        Position = opposite.Position;
        Forward = -opposite.Forward;
    }

    /// <summary>The matrix, row by row, scaled so that w is the depth in m.</summary>
    public IReadOnlyList<double> Matrix => _matrix;

    /// <summary>The centre of projection, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The direction of the optical axis, a unit vector.</summary>
    public Vector3d Forward { get; }

    /// <summary>Creates a camera that looks at a point, with a level horizon and square pixels.</summary>
    /// <param name="position">The position of the camera, in m.</param>
    /// <param name="target">The point at the centre of the image, in m; not straight above or below the camera.</param>
    /// <param name="focalLength">The focal length, in pixels. Above 0.</param>
    /// <param name="width">The width of the image, in pixels. Above 0.</param>
    /// <param name="height">The height of the image, in pixels. Above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public static TrackCamera LookingAt(Vector3d position, Vector3d target, double focalLength, double width, double height)
    {
        Check.Place(nameof(position), position);
        Check.Place(nameof(target), target);
        Check.Positive(nameof(focalLength), focalLength);
        Check.Positive(nameof(width), width);
        Check.Positive(nameof(height), height);
        Vector3d forward = target - position;
        Vector3d right = Vector3d.Cross(forward, Vector3d.Up);
        if (!(right.Length > LeastVolume * forward.Length))
        {
            throw Check.Refusal(nameof(target), target.ToString(), "a point that is not straight above or below the camera, or in it");
        }

        // v grows downwards: right × down = forward.
        forward /= forward.Length;
        right /= right.Length;
        Vector3d down = Vector3d.Cross(forward, right);
        Vector3d a = (focalLength * right) + (0.5 * width * forward);
        Vector3d b = (focalLength * down) + (0.5 * height * forward);
        return new TrackCamera(
        [
            a.X, a.Y, a.Z, -Vector3d.Dot(in a, in position),
            b.X, b.Y, b.Z, -Vector3d.Dot(in b, in position),
            forward.X, forward.Y, forward.Z, -Vector3d.Dot(in forward, in position),
        ]);
    }

    /// <summary>Computes the pixel of a position.</summary>
    /// <param name="position">The position, in m.</param>
    /// <param name="u">The pixel to the right.</param>
    /// <param name="v">The pixel downwards.</param>
    /// <returns>False if the position is not in front of the camera; the pixel is then NaN.</returns>
    public bool TryProject(in Vector3d position, out double u, out double v)
    {
        double depth = Depth(in position);
        bool isInFront = depth >= LeastDepth;
        u = isInFront ? Along(0, in position) / depth : double.NaN;
        v = isInFront ? Along(1, in position) / depth : double.NaN;
        return isInFront;
    }

    /// <summary>Returns the camera with the same pixels that looks the other way.</summary>
    internal TrackCamera Opposite() => new(this);

    /// <summary>Returns the distance of a position from the camera along the optical axis, in m.</summary>
    internal double Depth(in Vector3d position) => Along(2, in position);

    /// <summary>Computes a pixel even if the position is not in front of the camera, as if it were just in front. Searches try such positions.</summary>
    internal void Project(in Vector3d position, double leastDepth, out double u, out double v)
    {
        double depth = Math.Max(leastDepth, Depth(in position));
        u = Along(0, in position) / depth;
        v = Along(1, in position) / depth;
    }

    /// <summary>Returns the equation n·x = d of the plane of positions that a row and a pixel give.</summary>
    internal void Plane(int row, double pixel, out Vector3d n, out double d)
    {
        n = Row(_matrix, row) - (pixel * Forward);
        d = -(_matrix[(4 * row) + 3] - (pixel * _matrix[Size - 1]));
    }

    private double Along(int row, in Vector3d position) =>
        (_matrix[4 * row] * position.X) + (_matrix[(4 * row) + 1] * position.Y) + (_matrix[(4 * row) + 2] * position.Z) + _matrix[(4 * row) + 3];

    private static Vector3d Row(IReadOnlyList<double> matrix, int row) => new(matrix[4 * row], matrix[(4 * row) + 1], matrix[(4 * row) + 2]);
}
