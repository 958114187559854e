using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>Any combination of laws, each with its own equation.</summary>
internal sealed class MixedLaws : AirLaws
{
    /// <summary>The value of |u|² below which there is neither drag nor lift.</summary>
    private const double StillAir = 1e-18;

    private readonly IAirLaw _drag;
    private readonly IAirLaw _magnus;
    private readonly IAirLaw _decay;
    private readonly double _ofDrag;
    private readonly double _ofLift;
    private readonly double _radius;
    private readonly bool _fits;

    /// <param name="scene">The scene.</param>
    /// <param name="drag">The factor on the drag.</param>
    /// <param name="lift">The factor on the Magnus force.</param>
    public MixedLaws(Scene scene, double drag, double lift)
    {
        ForceSet forces = scene.Forces;
        _drag = SceneLaws.Drag(scene);
        _magnus = SceneLaws.Magnus(scene);
        _decay = SceneLaws.SpinDecay(scene);
        _ofDrag = drag;
        _ofLift = lift;
        _radius = scene.Ball.Radius;
        Drags = forces.Drag != ForceLaw.None;
        Lifts = forces.Magnus != ForceLaw.None;
        SpinDecays = forces.SpinDecay != ForceLaw.None;
        _fits = forces.Coefficients != AerodynamicModel.Measured && (forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical);
        Jumps = _fits && forces.Coefficients == AerodynamicModel.Published;
        Bound = Scaled(_drag.Bound, drag) + Scaled(_magnus.Bound, lift) + _decay.Bound;
        OrdinaryBound = Bound;
    }

    public override void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        // A stage may overshoot zero spin: lift then stops, but the decay, an even function of ω, continues smoothly.
        AirFlow flow = default;
        flow.SpeedSquared = speedSquared;
        flow.Speed = Math.Sqrt(speedSquared);
        flow.SpinRate = spinRate > 0 ? spinRate : 0;
        flow.AcrossSquared = acrossSquared;
        drag = 0;
        lift = 0;
        if (speedSquared > StillAir)
        {
            // Compute the fitted C_D once for both drag and lift.
            if (_fits)
            {
                flow.SpinParameter = _radius * flow.SpinRate / flow.Speed;
                flow.FittedDragCoefficient = !Jumps ? RegularisedDragFit.Coefficient(flow.Speed, flow.SpinParameter)
                    : region == DragBranch.Spinning ? FittedDrag.WithSpin(flow.SpinParameter) : FittedDrag.WithoutSpin(flow.Speed);
            }

            drag = _ofDrag * _drag.Factor(in flow);
            lift = _ofLift * _magnus.Factor(in flow);
        }

        flow.SpinRate = Math.Abs(spinRate);
        decay = _decay.Factor(in flow);
    }
}
