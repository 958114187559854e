using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The air of a scene with forces of the game's own: they may do anything, so the ball is integrated with its whole spin vector.</summary>
internal struct OwnForcesAir : IAir
{
    private readonly PointAir _air;
    private readonly OwnForces _forces;

    /// <summary>The air of a scene with its forces.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="air">Its air without them.</param>
    public OwnForcesAir(Scene scene, PointAir air)
    {
        _air = air;
        _forces = new OwnForces(scene);
    }

    public readonly bool Drags => _air.Drags;

    public readonly bool Lifts => _air.Lifts;

    public readonly bool SpinDecays => _air.SpinDecays;

    public readonly bool Jumps => _air.Jumps;

    public readonly bool Varies
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly bool TurnsAxis
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly double FastestWind => _air.FastestWind;

    public readonly RateBound Bound => _air.Bound;

    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    public readonly double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors)
    {
        double rate = _air.Evaluate(in ball, branch, out factors);
        _forces.AddTo(in ball, ref factors);
        return rate;
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
        integrator.Fly<OwnForcesAir, PointStep>(ref this, ref motion, in wind, branch, upward, h, out step);
}
