using Football.Scenarios.Input;

namespace Football.Scenarios;

/// <summary>Plays a scenario.</summary>
public static class ScenarioRun
{
    /// <summary>Events that a result has at most; what happened between the first and the last of them is counted.</summary>
    private const int MostEvents = 65_536;

    /// <summary>Plays it to its end.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the library's range.</exception>
    /// <exception cref="RefusedException">Its numbers, though each allowed, grew beyond what a double can hold.</exception>
    public static Outcome Play(Scenario scenario)
    {
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation);
        var highest = new HighestPoint(state.Position.Y);
        var log = new StepLog(mostEvents: MostEvents) { Observer = highest };
        List<Moment>? samples = scenario.Samples ? [Moment.Of(in state)] : null;

        bool ended = simulator.Run(
            ref state, scenario.TimeStep, scenario.Duration, scenario.StopAt, log, samples is null ? null : at => samples.Add(Moment.Of(in at)));

        Moment final = Final(scenario, in state, log.Events, ended);
        if (!ended)
        {
            // What many steps add up to is off by rounding; what was asked for is not.
            final = final with { Time = scenario.Duration };
        }

        if (samples is { Count: > 1 })
        {
            samples[^1] = final;
        }

        var outcome = new Outcome
        {
            Final = final,
            Events = log.Events.Span.ToArray(),
            Missed = log.Events.Dropped,
            Bounces = log.Events.Impacts,
            Apex = highest.Apex,
            Steps = log.Steps,
            Evaluations = log.Evaluations,
            Samples = samples,
            NameOf = simulator.NameOf,
            Derivatives = scenario.Derivatives ? DerivativesOf(scenario, simulator) : null,
        };
        return IsFinite(outcome)
            ? outcome
            : throw new RefusedException(FormattableString.Invariant(
                $"the motion is not finite up to {scenario.Duration} s; allowed: a scenario whose places and speeds stay within what a double can hold."));
    }

    /// <summary>
    /// At the event that ended the run the state is the event's: an impact's own upward speed, the last motion before rest.
    /// The ball's own state has already lost them there.
    /// </summary>
    private static Moment Final(Scenario scenario, in BallState state, EventBuffer events, bool ended)
    {
        var final = Moment.Of(in state);
        BallEventKind? kind = scenario.StopAt == StopAt.Impact && ended ? BallEventKind.Impact
            : state.Motion == MotionState.Stopped ? BallEventKind.Rest
            : null;
        for (int i = events.Count - 1; kind is not null && i >= 0; i--)
        {
            ref readonly BallEvent last = ref events[i];
            if (last.Kind != kind)
            {
                continue;
            }

            bool bounces = kind == BallEventKind.Impact && last.Thing == 0 && Vector3d.Dot(last.Velocity, last.Normal) >= scenario.Scene.Ground.MinimumBounceSpeed;
            return final with
            {
                State = bounces ? MotionState.Airborne : final.State,
                Position = last.Position,
                Velocity = last.Velocity,
                Spin = last.Spin,
            };
        }

        return final;
    }

    private static LaunchDerivatives DerivativesOf(Scenario scenario, Simulator simulator)
    {
        var derivatives = new LaunchDerivatives(simulator);
        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation);
        derivatives.Run(ref state, scenario.TimeStep, scenario.Duration, scenario.StopAt);
        return derivatives;
    }

    private static bool IsFinite(Outcome outcome) =>
        outcome.Final.IsFinite
        && double.IsFinite(outcome.Apex)
        && outcome.Events.All(item => double.IsFinite(item.Time) && item.Position.IsFinite && item.Velocity.IsFinite && item.Spin.IsFinite
            && item.VelocityBefore.IsFinite && item.SpinBefore.IsFinite)
        && (outcome.Samples?.All(sample => sample.IsFinite) ?? true);

    /// <summary>The greatest height of the centre, located inside the step.</summary>
    private sealed class HighestPoint(double height) : PieceObserver
    {
        public double Apex { get; private set; } = height;

        public override bool Add(in PathPiece piece)
        {
            Apex = Math.Max(Apex, piece.Apex);
            return false;
        }
    }
}
