namespace Football.Physics;

/// <summary>The air of a scene, asked point by point through one virtual call: for models that add to it what no fused form knows.</summary>
internal abstract class PointAir
{
    /// <inheritdoc cref="IFlightKernel{TStep}.Drags"/>
    public abstract bool Drags { get; }

    /// <inheritdoc cref="IFlightKernel{TStep}.Lifts"/>
    public abstract bool Lifts { get; }

    /// <inheritdoc cref="IFlightKernel{TStep}.SpinDecays"/>
    public abstract bool SpinDecays { get; }

    /// <inheritdoc cref="IAir.Jumps"/>
    public abstract bool Jumps { get; }

    /// <inheritdoc cref="IAir.Bound"/>
    public abstract RateBound Bound { get; }

    /// <inheritdoc cref="IAir.FastestWind"/>
    public abstract double FastestWind { get; }

    /// <summary>The air of a scene, but for the game's own forces.</summary>
    public static PointAir Of(Scene scene) => FieldAir.IsOf(scene) ? new Model<FieldAir>(scene) : OfLaws(scene);

    /// <summary>The laws of a scene alone: without wind by place or time, and without a knuckle force.</summary>
    public static PointAir OfLaws(Scene scene)
    {
        Maker maker = default;
        return AirChoice.Choose<Maker, PointAir>(scene, ref maker);
    }

    /// <inheritdoc cref="IAir.Evaluate"/>
    public abstract double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors);

    /// <inheritdoc cref="IFlightKernel{TStep}.AtStart"/>
    public abstract void AtPoint(PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);

    private struct Maker : IAirVisitor<PointAir>
    {
        public readonly PointAir Visit<TAir>(Scene scene)
            where TAir : struct, IAir => new Model<TAir>(scene);
    }

    private sealed class Model<TAir> : PointAir
        where TAir : struct, IAir
    {
        private TAir _air;

        public Model(Scene scene)
        {
            _air = default;
            _air.Prepare(scene);
        }

        public override bool Drags => _air.Drags;

        public override bool Lifts => _air.Lifts;

        public override bool SpinDecays => _air.SpinDecays;

        public override bool Jumps => _air.Jumps;

        public override RateBound Bound => _air.Bound;

        public override double FastestWind => _air.FastestWind;

        public override double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors) => _air.Evaluate(in ball, branch, out factors);

        public override void AtPoint(
            PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
            _air.AtStart(ref step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);
    }
}
