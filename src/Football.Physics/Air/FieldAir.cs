using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The air of a scene whose wind depends on place or time, or with a knuckle force: laws by place and time that leave the axis of the spin alone.</summary>
/// <remarks>A drag law that jumps is not located in such air: each evaluation takes the branch that holds there.</remarks>
internal struct FieldAir : IAir
{
    private readonly PointAir _air;
    private readonly IWind? _wind;
    private readonly KnuckleForce? _knuckle;
    private readonly double _radiusSquared;
    private readonly bool _jumps;

    public readonly bool Drags => _air.Drags;

    public readonly bool Lifts => _air.Lifts;

    public readonly bool SpinDecays => _air.SpinDecays;

    public readonly bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool Varies
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly bool TurnsAxis
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly double FastestWind => _wind?.Fastest ?? 0;

    public readonly RateBound Bound => _air.Bound + (_knuckle?.Bound ?? default);

    /// <summary>Whether a scene has such air.</summary>
    public static bool IsOf(Scene scene) => scene.Air.WindField is not null || scene.Forces.KnuckleSeed is not null;

    /// <summary>The air of a scene with its wind by place and time, and its knuckle force.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="laws">Its laws alone.</param>
    public FieldAir(Scene scene, PointAir laws)
    {
        _air = laws;
        _jumps = _air.Jumps;
        _wind = scene.Air.WindField;
        _knuckle = KnuckleForce.Of(scene);
        _radiusSquared = scene.Ball.Radius * scene.Ball.Radius;
    }

    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    public readonly double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors)
    {
        Vector3d u = _wind is null ? ball.AirVelocity : ball.AirVelocity - _wind.At(ball.Time, ball.Position);
        DragBranch here = _jumps ? DragJump.At(u.LengthSquared, _radiusSquared * ball.Spin.LengthSquared).Branch : branch;
        double rate = _air.Evaluate(ball.In(in u), here, out factors);
        if (_knuckle is not null && ball.Motion == MotionState.Airborne)
        {
            factors.AirSpeed = u.Length;
            factors.Acceleration = _knuckle.Acceleration(in u, ball.Spin, ball.AirDistance);
        }

        return rate;
    }

    /// <summary>The wind by place and time, m/s.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d WindAt(double time, in Vector3d position) => _wind is null ? Vector3d.Zero : _wind.At(time, in position);

    /// <summary>The factors of the laws in flight: D, 1/s; L |ω|, 1/s; angular deceleration, rad/s².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void AtPoint(double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        PointStep step;
        step.Branch = _jumps ? DragJump.At(speedSquared, _radiusSquared * spinRate * spinRate).Branch : DragBranch.Unknown;
        _air.AtPoint(step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);
    }

    /// <summary>Acceleration by the knuckle force, m/s², and |u|, which the distance flown grows by; nothing where there is none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d Side(in Vector3d u, in Vector3d spin, double distance, out double airSpeed)
    {
        if (_knuckle is null)
        {
            airSpeed = 0;
            return Vector3d.Zero;
        }

        airSpeed = u.Length;
        return _knuckle.Acceleration(in u, in spin, distance);
    }

    public readonly void Begin(double spinRate, DragBranch branch, out PointStep step) => step.Branch = branch;

    public readonly void AtStart(ref PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        _air.AtPoint(step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    public readonly void Expand(ref PointStep step, double speedChange, double spinChange)
    {
    }

    public readonly void AtStage(in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        _air.AtPoint(step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    public void Fly<TIntegrator>(
        ref TIntegrator integrator,
        bool covered,
        double speedSquared,
        ref FlightMotion motion,
        in Vector3d wind,
        DragBranch branch,
        double upward,
        double h,
        out FlightStep step)
        where TIntegrator : struct, IIntegrator =>
        integrator.Fly<FieldAir, PointStep>(ref this, ref motion, in wind, branch, upward, h, out step);
}
