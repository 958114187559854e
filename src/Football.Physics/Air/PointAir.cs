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

    /// <summary>An air, asked point by point.</summary>
    public static PointAir Of<TAir>(in TAir air)
        where TAir : struct, IAir => new Model<TAir>(in air);

    /// <inheritdoc cref="IAir.Evaluate"/>
    public abstract double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors);

    /// <inheritdoc cref="IFlightKernel{TStep}.AtStart"/>
    public abstract void AtPoint(PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);

    private sealed class Model<TAir> : PointAir
        where TAir : struct, IAir
    {
        private TAir _air;

        public Model(in TAir air) => _air = air;

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
