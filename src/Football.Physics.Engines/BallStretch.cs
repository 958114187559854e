namespace FootballPhysics.Engines;

/// <summary>The shape of a squashed ball: a scale along an axis, and one across it.</summary>
public readonly record struct BallStretch
{
    private readonly double _flatter;

    internal BallStretch(in Vector3d axis, double flatter)
    {
        Axis = axis;
        _flatter = flatter;
    }

    /// <summary>The axis, in the frame of the world; a unit vector.</summary>
    public Vector3d Axis { get; }

    /// <summary>The scale along the axis; 0.4 … 1.</summary>
    public double Along => 1.0 - _flatter;

    /// <summary>The scale across the axis, which keeps the volume; 1 … 1.6.</summary>
    public double Across => 1.0 / Math.Sqrt(1.0 - _flatter);

    /// <summary>True if the ball is round.</summary>
    public bool IsRound => _flatter == 0;

    /// <summary>The shortest rotation that turns <see cref="Vector3d.Up"/> to the axis.</summary>
    /// <remarks>
    /// An engine that scales along the axes of an object uses two objects: the outer one has this rotation and the scale (<see cref="Across"/>,
    /// <see cref="Along"/>, <see cref="Across"/>), the inner one the inverse of this rotation, followed by that of the ball.
    /// </remarks>
    public Quaterniond Frame
    {
        get
        {
            // (ŷ × n, 1 + ŷ·n), normalized; half a turn about x if n = −ŷ.
            Vector3d n = Axis == Vector3d.Zero ? Vector3d.Up : Axis;
            return n.Y > -1.0 + 1e-12 ? new Quaterniond(n.Z, 0, -n.X, 1.0 + n.Y).Normalized() : new Quaterniond(1, 0, 0, 0);
        }
    }

    /// <summary>Stretches a vector from the centre of the ball, in the frame of the world.</summary>
    /// <param name="v">The vector.</param>
    public Vector3d Apply(in Vector3d v) => (Across * v) + ((Along - Across) * Vector3d.Dot(Axis, in v) * Axis);
}
