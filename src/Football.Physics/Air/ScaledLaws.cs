using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The laws of a scene with factors on drag and Magnus force: what <see cref="ScaledAir"/> does as a force, as laws that leave the axis of the spin alone.</summary>
internal struct ScaledLaws : IAir
{
    private readonly PointAir _laws;
    private readonly double _drag;
    private readonly double _lift;

    private ScaledLaws(ScaledAir scaled)
    {
        _laws = scaled.Laws;
        _drag = scaled.Drag;
        _lift = scaled.Lift;
    }

    public readonly bool Drags => _laws.Drags;

    public readonly bool Lifts => _laws.Lifts;

    public readonly bool SpinDecays => _laws.SpinDecays;

    public readonly bool Jumps => _laws.Jumps;

    public readonly bool Varies
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool TurnsAxis
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly double FastestWind => 0;

    public readonly RateBound Bound
    {
        get
        {
            RateBound bound = _laws.Bound;
            double most = Math.Max(1.0, Math.Max(_drag, Math.Abs(_lift)));
            return new RateBound(most * bound.PerSpeed, most * bound.PerSpin, most * bound.Constant);
        }
    }

    /// <summary>The air of a scene whose only own force is one that scales its laws.</summary>
    /// <returns>False where something else acts too.</returns>
    public static bool TryOf(Scene scene, out ScaledLaws laws)
    {
        if (!FieldAir.IsOf(scene) && scene.Forces.Custom.Count == 1 && scene.Forces.Custom[0] is ScaledAir scaled && scaled.IsMadeFor(scene))
        {
            laws = new ScaledLaws(scaled);
            return true;
        }

        laws = default;
        return false;
    }

    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    public double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors) => AirRates.Evaluate(ref this, in ball, branch, out factors);

    public readonly void Begin(double spinRate, DragBranch branch, out PointStep step) => step.Branch = branch;

    public readonly void AtStart(ref PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtStage(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    public readonly void Expand(ref PointStep step, double speedChange, double spinChange)
    {
    }

    public readonly void AtStage(in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        _laws.AtPoint(step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);
        drag *= _drag;
        lift *= _lift;
    }

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
        integrator.Fly<ScaledLaws, PointStep>(ref this, ref motion, in wind, branch, upward, h, out step);
}
