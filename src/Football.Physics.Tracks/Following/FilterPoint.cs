namespace FootballPhysics.Tracks;

/// <summary>The quantities that a point measures.</summary>
internal enum FilterPointKind : byte
{
    /// <summary>The position in 3D.</summary>
    Position = 0,

    /// <summary>The position along the ground, without the height.</summary>
    OnPlan = 1,

    /// <summary>A pixel of a camera.</summary>
    Pixel = 2,
}

/// <summary>A measured point of the stream.</summary>
internal struct FilterPoint
{
    public double Time;

    /// <summary>The position; without height, Y is 0; for a pixel, X is u and Y is v.</summary>
    public Vector3d Value;

    /// <summary>The standard deviation of each coordinate, in m or pixels.</summary>
    public double Deviation;

    public FilterPointKind Kind;

    /// <summary>The number of measured coordinates.</summary>
    public readonly int Rows => Kind == FilterPointKind.Position ? 3 : 2;

    /// <summary>The camera of a pixel, row by row; see <see cref="TrackCamera.Matrix"/>.</summary>
    public CameraRows Camera;

    /// <summary>The least depth in front of a camera at which a position is projected, in m.</summary>
    private const double LeastDepth = 0.1;

    /// <summary>Returns the coordinates that the point would have if the ball were at a position.</summary>
    public readonly Vector3d Of(in Vector3d position)
    {
        switch (Kind)
        {
            case FilterPointKind.Position:
                return position;
            case FilterPointKind.OnPlan:
                return new Vector3d(position.X, position.Z, 0);
            default:
                double depth = Math.Max(LeastDepth, Camera.W.Along(in position));
                return new Vector3d(Camera.U.Along(in position) / depth, Camera.V.Along(in position) / depth, 0);
        }
    }

    /// <summary>Returns the change of the coordinates with the position along an axis.</summary>
    /// <param name="position">The position of the ball.</param>
    /// <param name="expected">The coordinates there; see <see cref="Of"/>.</param>
    /// <param name="axis">The axis.</param>
    public readonly Vector3d Slope(in Vector3d position, in Vector3d expected, in Vector3d axis)
    {
        const double Step = 1e-3;
        return Kind == FilterPointKind.Pixel ? (Of(position + (Step * axis)) - expected) / Step : Of(in axis);
    }

    /// <summary>The measured coordinates in the order of <see cref="Of"/>.</summary>
    public readonly Vector3d Measured => Kind == FilterPointKind.OnPlan ? new Vector3d(Value.X, Value.Z, 0) : Value;
}

/// <summary>A row of a camera matrix.</summary>
internal struct CameraRow
{
    public Vector3d Normal;
    public double Offset;

    public readonly double Along(in Vector3d position) => Vector3d.Dot(in Normal, in position) + Offset;
}

/// <summary>The rows of a camera matrix, copied so that a point allocates nothing.</summary>
internal struct CameraRows
{
    public CameraRow U;
    public CameraRow V;
    public CameraRow W;

    public static CameraRows Of(TrackCamera camera) => new() { U = Row(camera, 0), V = Row(camera, 4), W = Row(camera, 8) };

    private static CameraRow Row(TrackCamera camera, int at) =>
        new() { Normal = new Vector3d(camera.Matrix[at], camera.Matrix[at + 1], camera.Matrix[at + 2]), Offset = camera.Matrix[at + 3] };
}
