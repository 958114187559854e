using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>Events: order, time, completeness, whatever the step.</summary>
public sealed class EventTests
{
    public static TheoryData<Integrator> Integrators() => Flight.EveryIntegrator();

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void Every_life_has_its_events_in_order(Profile profile, Integrator integrator)
    {
        var random = new Shots(9);
        for (int i = 0; i < 40; i++)
        {
            Flight.Play(
                profile.Scene() with { Air = new Air { Wind = new Vector3d(random.Uniform(-3, 3), 0, random.Uniform(-3, 3)) } },
                Flight.With(integrator),
                0.005,
                100,
                StopAt.Rest,
                new Vector3d(0, random.Uniform(0.11, 3), 0),
                random.Velocity(0, 20, -40, 40),
                random.Uniform(0, 40) * random.Direction(),
                out StepLog log);
            string kinds = Flight.Kinds(log);
            Assert.Matches("^(Impact )*(Slide )?(Roll )?Rest$", kinds);
            for (int k = 1; k < log.Events.Count; k++)
            {
                Assert.True(log.Events[k].Time >= log.Events[k - 1].Time, kinds);
                Assert.True(log.Events[k].Time > log.Events[k - 1].Time || log.Events[k].Kind > log.Events[k - 1].Kind, kinds);
            }

            foreach (ref readonly BallEvent item in log.Events)
            {
                Assert.Equal(0.11, item.Position.Y, 1e-11);
                if (item.Kind != BallEventKind.Impact)
                {
                    Assert.Equal(item.VelocityBefore, item.Velocity);
                    Assert.Equal(0, item.Velocity.Y);
                }
            }
        }
    }

    [Theory]
    [ProfileData]
    public void Many_impacts_in_one_long_step_are_those_of_many_short_ones(Profile profile)
    {
        // 0.02 m of drop and e = 0.9: some thirty impacts in a second, which without air every step finds exactly.
        Scene scene = Scene.Vacuum with { Ground = profile.Ground() with { Material = profile.Ground().Material with { NormalRestitution = 0.9, GrazingRestitutionGain = 0, RestitutionSpeedScale = double.PositiveInfinity }, MinimumBounceSpeed = 0.02 } };
        foreach (Integrator integrator in new[] { Integrator.Rk2, Integrator.Rk4 })
        {
            StepLog Play(double step, out BallState state)
            {
                state = Flight.Play(
                    scene, Flight.With(integrator), step, 1, StopAt.Time, new Vector3d(0, 0.13, 0), new Vector3d(1, 0, 2), new Vector3d(3, 4, 5), out StepLog log);
                return log;
            }

            StepLog once = Play(1, out BallState longStep);
            StepLog often = Play(0.001, out BallState shortSteps);
            Assert.True(once.Events.Count > 12, $"{once.Events.Count} impacts");
            Assert.Equal(Flight.Kinds(often), Flight.Kinds(once));
            for (int i = 0; i < once.Events.Count; i++)
            {
                Assert.Equal(often.Events[i].Time, once.Events[i].Time, 1e-10);
            }

            Assert.InRange(Vector3d.Distance(longStep.Position, shortSteps.Position), 0, 1e-9);
            Assert.InRange(Differences.Rotation(longStep.Orientation, shortSteps.Orientation), 0, 1e-9);
        }
    }

    /// <summary>A ball that dips below the ground and comes up again within one step still hits it.</summary>
    [Fact]
    public void An_impact_hidden_between_the_ends_of_a_step_is_found()
    {
        // Light enough for the wind to blow it up again.
        Scene scene = Scene.Published with
        {
            Gravity = 0,
            Air = new Air { Wind = new Vector3d(0, 10, 0) },
            Forces = ForceSet.None with { Drag = ForceLaw.Constant, DragCoefficient = 1 },
        };
        foreach (Integrator integrator in new[] { Integrator.Rk2, Integrator.Rk4 })
        {
            BallState state = Flight.Play(
                scene, Flight.With(integrator), 0.2, 1, StopAt.Impact, new Vector3d(0, 0.111, 0), new Vector3d(0, -0.3, 0), Vector3d.Zero, out StepLog log);
            Assert.Equal("Impact", Flight.Kinds(log));
            Assert.Equal(0.0034, state.Time, 2e-4);
        }
    }

    /// <summary>A hop shorter than the step, from contact back to contact.</summary>
    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void A_hop_inside_one_step_does_not_sink_into_the_ground(Profile profile, Integrator integrator)
    {
        foreach (double vertical in new[] { 0.25, 0.3, 1, 3 })
        {
            foreach (double timeStep in new[] { 0.04, 0.1, 0.5 })
            {
                var simulator = new Simulator(profile.Scene(), Flight.With(integrator));
                BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3, vertical, 0), Vector3d.Zero);
                var log = new StepLog();
                for (int i = 0; i < 20; i++)
                {
                    simulator.Step(ref state, timeStep, log);
                    Assert.True(state.Position.Y >= 0.11 - 1e-12, $"{vertical} m/s, {timeStep} s, step {i}: {state.Position}");
                }

                foreach (ref readonly BallEvent item in log.Events)
                {
                    Assert.Equal(0.11, item.Position.Y, 1e-11);
                }
            }
        }
    }

    /// <summary>
    /// A step a little shorter than the impact does not touch the ground, one a little longer does. Among surfaces of any shape the instant is that of the path between the
    /// step's ends.
    /// </summary>
    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void The_impact_time_is_the_root_of_the_step_itself(Profile profile, Integrator integrator)
    {
        var random = new Shots(24);
        var simulator = new Simulator(profile.Scene() with { Forces = profile.SmoothForces() }, Flight.With(integrator));
        foreach ((double timeStep, double tolerance) in profile == Profile.Published ? new[] { (0.01, 1e-12), (0.04, 1e-12), (0.25, 1e-9) } : [(0.01, 1e-9), (0.04, 1e-8)])
        {
            for (int i = 0; i < 40; i++)
            {
                BallState state = simulator.Launch(new Vector3d(0, 2, 0), random.Velocity(10, 30, 5, 40), random.Uniform(5, 40) * random.Direction());
                var log = new StepLog();
                BallState start = state;
                while (log.Events.Count == 0)
                {
                    start = state;
                    simulator.Step(ref state, timeStep, log);
                }

                BallEvent impact = log.Events[0];
                Assert.Equal(0.11, impact.Position.Y);

                // A step of first order that is a little longer is another step; less than a nanometre below contact the ball still only touches.
                double other = integrator is Integrator.Euler or Integrator.SemiImplicitEuler ? 1e-8 : 0;
                Assert.False(Hits(simulator, start, impact.Time - start.Time - tolerance - other), $"{timeStep} s, shot {i}");
                Assert.True(Hits(simulator, start, impact.Time - start.Time + 1e-9 + other + (1e-9 / -impact.VelocityBefore.Y)), $"{timeStep} s, shot {i}");
            }
        }
    }

    [Theory]
    [InlineData(1e-2)]
    [InlineData(1e-4)]
    [InlineData(1e-6)]
    public void Bisection_finds_the_impact_within_its_tolerance(double tolerance)
    {
        var random = new Shots(25);
        var errors = new Errors("impact time");
        for (int i = 0; i < 50; i++)
        {
            Vector3d velocity = random.Velocity(5, 25, 10, 60);
            double exact = 2 * velocity.Y / 9.81;
            var settings = new SolverSettings { Integrator = Integrator.Rk2, CollisionTiming = CollisionTiming.Bisection, CollisionTolerance = tolerance };
            Flight.Play(Scene.Vacuum, settings, 0.03, 10, StopAt.Impact, new Vector3d(0, 0.11, 0), velocity, Vector3d.Zero, out StepLog log);
            errors.Add($"{velocity}", Math.Abs(log.Events[0].Time - exact));
        }

        errors.Hold(worst: tolerance);
        Assert.True(errors.Worst > 0.02 * tolerance, "a search that is better than its tolerance is not this search");
    }

    [Fact]
    public void Bisection_costs_an_integration_a_halving_and_exact_timing_one_or_two()
    {
        long Evaluations(CollisionTiming timing)
        {
            var settings = new SolverSettings { Integrator = Integrator.Rk2, CollisionTiming = timing };
            Flight.Play(Scene.Vacuum, settings, 0.01, 10, StopAt.Impact, new Vector3d(0, 0.11, 0), new Vector3d(10, 9, 0), Vector3d.Zero, out StepLog log);
            return log.Evaluations - (2 * log.Steps);
        }

        Assert.Equal(2, Evaluations(CollisionTiming.Exact));
        Assert.InRange(Evaluations(CollisionTiming.Bisection), 2 * 14, 2 * 16);
    }

    [Theory]
    [ProfileData]
    public void Every_method_spends_its_own_number_of_evaluations_on_a_step(Profile profile)
    {
        long[] expected = [1, 1, 2, 4];
        foreach (Integrator integrator in Flight.Integrators)
        {
            Flight.Play(
                profile.Scene() with { Forces = profile.SmoothForces() }, Flight.With(integrator), 0.01, 0.5, StopAt.Time, new Vector3d(0, 30, 0), new Vector3d(20, 5, 0), new Vector3d(3, 4, 5), out StepLog log);
            Assert.Equal(50, log.Steps);
            Assert.Equal(50 * expected[(int)integrator], log.Evaluations);
        }
    }

    [Theory]
    [ProfileData]
    public void Watching_a_flight_adds_no_pieces_to_it(Profile profile)
    {
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(profile.Scene(), Flight.With(integrator));
            BallState alone = simulator.Launch(new Vector3d(0, 30, 0), new Vector3d(20, 5, 0), new Vector3d(3, 4, 15));
            BallState watched = alone;
            var log = new StepLog();
            var watchedLog = new StepLog { Observer = new PieceLimit(int.MaxValue) };
            for (int i = 0; i < 100; i++)
            {
                simulator.Step(ref alone, 0.01, log);
                simulator.Step(ref watched, 0.01, watchedLog);
            }

            Assert.Equal(alone, watched);
            Assert.Equal(log.Steps, watchedLog.Steps);
            Assert.Equal(log.Evaluations, watchedLog.Evaluations);
        }
    }

    [Fact]
    public void The_drag_laws_jump_costs_a_few_evaluations_and_a_bounded_number_of_splits()
    {
        var random = new Shots(26);
        for (int i = 0; i < 300; i++)
        {
            // Slow shots with little spin: the ones that chatter between the branches.
            Flight.Play(
                Scene.Published,
                SolverSettings.Default,
                0.01,
                60,
                StopAt.Impact,
                new Vector3d(0, 0.11, 0),
                random.Velocity(12, 20, 10, 40),
                random.Uniform(4, 9) * random.Direction(),
                out StepLog log);
            double steps = Math.Ceiling(log.Events[0].Time / 0.01);
            Assert.InRange(log.Evaluations, 4 * steps, (4 * steps * 1.6) + 40);
        }
    }

    [Theory]
    [ProfileData]
    public void A_buffer_grows_and_drops_nothing(Profile profile)
    {
        Scene scene = Scene.Vacuum with { Ground = profile.Ground() with { Material = profile.Ground().Material with { NormalRestitution = 0.95 }, MinimumBounceSpeed = 0.001 } };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog(1);
        simulator.Step(ref state, 100, log);
        Assert.True(log.Events.Count > 100);
        Assert.EndsWith("Impact Roll Rest", Flight.Kinds(log), StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => log.Events[log.Events.Count]);
        Assert.Throws<ArgumentOutOfRangeException>(() => log.Events[-1]);
        Assert.Throws<ArgumentOutOfRangeException>(() => new StepLog(0));
        log.Clear();
        Assert.Equal(0, log.Events.Count + log.Steps + log.Evaluations);
    }

    private static bool Hits(Simulator simulator, BallState from, double step)
    {
        var log = new StepLog();
        simulator.Step(ref from, step, log);
        return log.Events.Count > 0;
    }
}
