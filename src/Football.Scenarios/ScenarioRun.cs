using FootballPhysics.Scenarios.Input;
using FootballPhysics.Simulation;

namespace FootballPhysics.Scenarios;

/// <summary>Simulates a scenario.</summary>
public static class ScenarioRun
{
    /// <summary>The maximum number of events in a result. Events between the kept ones are only counted.</summary>
    private const int MostEvents = 65_536;

    /// <summary>Simulates a scenario to its end.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the library's range.</exception>
    /// <exception cref="RefusedException">The motion overflowed, although each number is allowed.</exception>
    public static Outcome Play(Scenario scenario)
    {
        if (scenario.Balls.Count > 0)
        {
            return PlaySeveral(scenario);
        }

        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        (KinematicBody Body, BodyMotion From)[] moves = scenario.BeforeStep is null && scenario.Scene.Bodies is { } bodies ? [.. bodies.Select(body => (body, BodyMotion.Of(body)))] : [];
        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation ?? simulator.LaunchOrientation);
        var highest = new HighestPoint(state.Position.Y);
        var log = new StepLog(mostEvents: MostEvents) { Observer = highest };
        List<Moment>? samples = scenario.Samples ? [Moment.Of(in state)] : null;

        scenario.BeforeStep?.Invoke(state);
        Action<BallState>? afterStep = samples is null ? scenario.BeforeStep : at =>
        {
            samples.Add(Moment.Of(in at));
            scenario.BeforeStep?.Invoke(at);
        };
        bool ended = simulator.Run(ref state, scenario.TimeStep, scenario.Duration, scenario.StopAt, log, afterStep);

        // The ball pushes bodies that have a mass: put them back, so that a second run is the same.
        foreach ((KinematicBody body, BodyMotion from) in moves)
        {
            from.ApplyTo(body);
        }

        Moment final = Final(scenario, in state, log.Events, ended);
        if (!ended)
        {
            // A sum of many steps has a rounding error; the requested time has none.
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
            ImpulseOf = ImpulseOf(scenario, item => simulator.ImpactOf(in item), several: false),
            ImpactOf = item => simulator.ImpactOf(in item),
            Derivatives = scenario.Derivatives ? DerivativesOf(scenario) : null,
        };
        return IsFinite(outcome)
            ? outcome
            : throw NotFinite(scenario);
    }

    /// <summary>Simulates several balls, until all of them stop.</summary>
    private static Outcome PlaySeveral(Scenario scenario)
    {
        var group = new BallGroup(scenario.Scene, [.. scenario.Balls.Select(ball => ball.Ball)], scenario.Settings, scenario.BallContact);
        BallState[] states = [.. scenario.Balls.Select((ball, i) => group.SimulatorOf(i).Launch(ball.Position, ball.Velocity, ball.Spin, ball.Orientation ?? group.SimulatorOf(i).LaunchOrientation))];
        var log = new StepLog(mostEvents: MostEvents);
        List<Moment>[] samples = scenario.Samples ? [.. states.Select(state => new List<Moment> { Moment.Of(in state) })] : [];
        bool ended = group.Run(states, scenario.TimeStep, scenario.Duration, scenario.StopAt, log, samples.Length == 0 ? null : () =>
        {
            for (int i = 0; i < states.Length; i++)
            {
                samples[i].Add(Moment.Of(in states[i]));
            }
        });
        Moment[] finals = [.. states.Select(state => ended ? Moment.Of(in state) : Moment.Of(in state) with { Time = scenario.Duration })];
        for (int i = 0; i < samples.Length; i++)
        {
            samples[i][^1] = finals[i];
        }

        var outcome = new Outcome
        {
            Final = finals[0],
            Balls = finals,
            BallSamples = samples,
            Events = log.Events.Span.ToArray(),
            Missed = log.Events.Dropped,
            Bounces = log.Events.Impacts,
            Apex = 0,
            Steps = log.Steps,
            Evaluations = log.Evaluations,
            NameOf = group.SimulatorOf(0).NameOf,
            ImpulseOf = ImpulseOf(scenario, item => group.SimulatorOf(item.Ball).ImpactOf(in item), several: true),
            ImpactOf = item => group.SimulatorOf(item.Ball).ImpactOf(in item),
        };
        return IsFinite(outcome) ? outcome : throw NotFinite(scenario);
    }

    /// <summary>Returns a function that computes the impulse of an event; null for events without one.</summary>
    /// <remarks>
    /// Impacts with objects that have a mass have an impulse; with several balls, all impacts except those on the ground. Collider 0 is the ground, and
    /// the obstacles come next.
    /// </remarks>
    private static Func<BallEvent, Vector3d?> ImpulseOf(Scenario scenario, Func<BallEvent, Impact> impactOf, bool several)
    {
        IReadOnlyList<Obstacle> obstacles = scenario.Scene.Obstacles;
        bool HasImpulse(int thing) => thing > 0 && (several || (thing <= obstacles.Count && double.IsFinite(obstacles[thing - 1].Mass)));
        return item => item.Kind == BallEventKind.Impact && HasImpulse(item.ColliderIndex) ? impactOf(item).Impulse : null;
    }

    private static RefusedException NotFinite(Scenario scenario) => new(FormattableString.Invariant(
        $"the motion overflows before {scenario.Duration} s. Reduce the speeds, the coefficients or stop.time."));

    /// <summary>Returns the state at the end.</summary>
    /// <remarks>
    /// If an event ended the run, the state is that of the event: with the upward speed of an impact, or with the last motion before rest. The ball's
    /// own state no longer has them.
    /// </remarks>
    private static Moment Final(Scenario scenario, in BallState state, EventBuffer events, bool ended)
    {
        var final = Moment.Of(in state);
        BallEventKind? kind = scenario.StopAt == StopAt.Impact && ended ? BallEventKind.Impact
            : state.Motion == MotionState.Rest ? BallEventKind.Rest
            : null;
        for (int i = events.Count - 1; kind is not null && i >= 0; i--)
        {
            ref readonly BallEvent last = ref events[i];
            if (last.Kind != kind)
            {
                continue;
            }

            bool bounces = kind == BallEventKind.Impact && last.ColliderIndex == 0 && Vector3d.Dot(last.Velocity, last.Normal) >= scenario.Scene.Ground.MinimumBounceSpeed;
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

    private static LaunchDerivatives DerivativesOf(Scenario scenario)
    {
        // Use a new simulator: the run has moved the objects that yield.
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        var derivatives = new LaunchDerivatives(simulator);
        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation ?? simulator.LaunchOrientation);
        derivatives.Run(ref state, scenario.TimeStep, scenario.Duration, scenario.StopAt);
        return derivatives;
    }

    private static bool IsFinite(Outcome outcome) =>
        outcome.Final.IsFinite
        && outcome.Balls.All(final => final.IsFinite)
        && double.IsFinite(outcome.Apex)
        && outcome.Events.All(item => double.IsFinite(item.Time) && item.Position.IsFinite && item.Velocity.IsFinite && item.Spin.IsFinite
            && item.VelocityBefore.IsFinite && item.SpinBefore.IsFinite)
        && (outcome.Samples?.All(sample => sample.IsFinite) ?? true)
        && outcome.BallSamples.All(samples => samples.All(sample => sample.IsFinite));

    /// <summary>The motion of a body of the scene.</summary>
    private readonly record struct BodyMotion(Vector3d Position, Quaterniond Orientation, Vector3d Velocity, Vector3d Spin, double Time, bool IsWithdrawn)
    {
        public static BodyMotion Of(KinematicBody body) => new(body.Position, body.Orientation, body.Velocity, body.Spin, body.Time, body.IsWithdrawn);

        public void ApplyTo(KinematicBody body)
        {
            body.MoveTo(Position, Orientation, Velocity, Spin, Time);
            if (IsWithdrawn)
            {
                body.Withdraw();
            }
        }
    }

    /// <summary>The greatest height of the centre, located inside the step.</summary>
    private sealed class HighestPoint(double height) : PieceObserver
    {
        public double Apex { get; private set; } = height;

        public override bool Add(in PathSegment piece)
        {
            Apex = Math.Max(Apex, piece.Apex);
            return false;
        }
    }
}
