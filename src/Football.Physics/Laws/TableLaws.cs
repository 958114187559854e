using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>Tabulated laws, optionally scaled.</summary>
/// <remarks>An absent force is a scale of 0 of the law itself.</remarks>
/// <typeparam name="TLaw">The type of the laws.</typeparam>
internal sealed class TableLaws<TLaw> : AirLaws
    where TLaw : struct, ITableLaw
{
    private readonly double _ofDrag;
    private readonly double _ofLift;
    private readonly ReverseLift _reverse;
    private TableAir<TLaw> _air;

    /// <param name="scene">The scene.</param>
    /// <param name="drag">The factor on the drag.</param>
    /// <param name="lift">The factor on the Magnus force.</param>
    public TableLaws(Scene scene, double drag, double lift)
    {
        ForceSet forces = scene.Forces;
        _air = new TableAir<TLaw>(scene);
        _reverse.Prepare(scene);
        Drags = forces.Drag != ForceLaw.None;
        Lifts = forces.Magnus != ForceLaw.None;
        SpinDecays = forces.SpinDecay != ForceLaw.None;
        _ofDrag = drag;
        _ofLift = lift;

        // Lift depends on the same C_D as drag, and jumps together with it.
        Jumps = _air.Jumps && (forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical);
        Bound = BoundUpTo(2.0 * Limits.Speed);
        OrdinaryBound = BoundUpTo(OrdinarySpeed);

        RateBound BoundUpTo(double fastest) =>
            Scaled(SceneLaws.DragBound(scene, fastest), drag) + Scaled(SceneLaws.Magnus(scene).Bound, lift) + SceneLaws.SpinDecay(scene).Bound;
    }

    public override void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        _air.FactorsAnywhere(speedSquared, spinRate, acrossSquared, region, out drag, out lift, out decay);
        lift += _reverse.Acts ? _reverse.Part(speedSquared, spinRate, acrossSquared) : 0;
        drag *= _ofDrag;
        lift *= _ofLift;
    }

    public override bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        bool spins = _air.FactorsPerSpin(speedSquared, spinSquared, crossSquared, region, out drag, out lift, out decay);
        lift += spins && _reverse.Acts ? _reverse.Part(speedSquared, 1.0, crossSquared) : 0;
        drag *= _ofDrag;
        lift *= _ofLift;
        return spins;
    }
}
