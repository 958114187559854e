namespace Football.Physics;

/// <summary>The whole state of a ball: an unmanaged value.</summary>
/// <remarks>
/// Copying it is a snapshot, comparing its bytes is equality, and a step depends on nothing else that changes.
/// Make one with <see cref="Simulator.Launch(Vector3d, Vector3d, Vector3d)"/>; all zero bytes are not a valid state.
/// </remarks>
public struct BallState
{
    /// <summary>Time since the launch, s.</summary>
    public double Time { get; internal set; }

    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position { get; internal set; }

    /// <summary>Velocity of the centre, m/s.</summary>
    public Vector3d Velocity
    {
        readonly get => Flight.Velocity;
        internal set => Flight.Velocity = value;
    }

    /// <summary>Velocity and spin.</summary>
    internal FlightMotion Flight;

    /// <summary>What the ball is doing.</summary>
    public MotionState Motion { get; internal set; }

    /// <summary>The branch of the drag law that the ball is on. Beside <see cref="Motion"/>, so that there is no padding between fields.</summary>
    internal DragBranch Branch;

    /// <summary>Angular velocity in the world frame, rad/s.</summary>
    public readonly Vector3d Spin => SpinAxis * SpinRate;

    /// <summary>Orientation, body to world. Put together when asked for: in flight it costs nothing until then.</summary>
    public readonly Quaterniond Orientation => Angle == 0
        ? BaseOrientation
        : (Quaterniond.FromAxisAngle(SpinAxis, Angle) * BaseOrientation).Normalized();

    /// <summary>In flight the unit axis of rotation, which is constant there; on the ground the spin itself.</summary>
    internal Vector3d SpinAxis
    {
        readonly get => Flight.Axis;
        set => Flight.Axis = value;
    }

    /// <summary>In flight the size of the spin, rad/s; on the ground 1.</summary>
    internal double SpinRate
    {
        readonly get => Flight.SpinRate;
        set => Flight.SpinRate = value;
    }

    /// <summary>Angle turned about <see cref="SpinAxis"/> since <see cref="BaseOrientation"/>, rad.</summary>
    internal double Angle;

    /// <summary>Orientation when <see cref="Angle"/> was last zero.</summary>
    internal Quaterniond BaseOrientation;

    /// <summary>Sets the spin of a ball in the air.</summary>
    internal void SetFlightSpin(in Vector3d spin)
    {
        FoldRotation();
        double rate = spin.Length;
        SpinAxis = rate > 0 ? spin / rate : Vector3d.Up;
        SpinRate = rate;
    }

    /// <summary>Sets the spin of a ball on the ground.</summary>
    internal void SetGroundSpin(in Vector3d spin)
    {
        FoldRotation();
        SpinAxis = spin;
        SpinRate = 1;
    }

    /// <summary>Moves the angle turned so far into the base orientation, before the axis changes.</summary>
    internal void FoldRotation()
    {
        BaseOrientation = Orientation;
        Angle = 0;
    }

    /// <summary>A state, refused where it never was one of a ball.</summary>
    internal static BallState Launched(in BallState state) =>
        state.BaseOrientation == default
            ? throw new ArgumentException("state was never launched; allowed: a state from Simulator.Launch, or a copy of a ball's.", nameof(state))
            : state;
}
