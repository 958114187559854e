using System.Globalization;
using System.Reflection;
using FootballPhysics.Contacts;
using FootballPhysics.Simulation;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Stability;

/// <summary>Steps that once took thousands of pieces: no ball is stopped in mid-air, and no path leads into a stationary object.</summary>
public sealed class StepBudgetTests
{
    private const double Radius = 0.11;

    /// <summary>The longest step of a lab's match, which once ended with its budget spent.</summary>
    private const double Tick = 1.0 / 30;

    /// <summary>Evaluations of a step with a few events.</summary>
    private const long Few = 1500;

    [Fact]
    public void A_step_that_continues_has_all_counters_of_its_earlier_calls()
    {
        FieldInfo[] counters = typeof(StepBudget).GetFields(BindingFlags.Public | BindingFlags.Instance);
        Assert.InRange(counters.Length, 10, 30);
        object spent = default(StepBudget);
        for (int i = 0; i < counters.Length; i++)
        {
            counters[i].SetValue(spent, Convert.ChangeType(1 + (i % 7) + (7 * (i % 2)), counters[i].FieldType, CultureInfo.InvariantCulture));
        }

        var log = new StepLog { Continues = true, Spent = (StepBudget)spent };
        var run = new StepRun(0.01, 0, log);
        log.Spent = default;
        run.Close();
        object after = log.Spent;
        Assert.All(counters, counter => Assert.Equal(counter.GetValue(spent), counter.GetValue(after)));
    }

    /// <summary>The evaluations of gaps by searches use up the budget of a step as those of forces do, also in the next call of the step.</summary>
    [Fact]
    public void Searches_count_as_evaluations()
    {
        World world = new Simulator(new Scene()).World;
        var log = new StepLog { Continues = true };
        var run = new StepRun(0.01, 0, log);
        world.SearchEvaluations = 20_000;
        Assert.True(run.Begin(world));
        Assert.Equal(20_000, log.SearchEvaluations);
        Assert.Equal(0, world.SearchEvaluations);
        run.Close();
        var next = new StepRun(0.01, 0, log);
        world.SearchEvaluations = 10_000;
        Assert.False(next.TakesParts(world));
        Assert.False(next.Begin(world));
    }

    [Theory]
    [InlineData(0.9, 0)]
    [InlineData(0.4, 20)]
    [InlineData(0.9, 60)]
    public void A_ball_on_two_surfaces_that_coincide_moves_as_on_one(double speed, double spin)
    {
        // The ends of two capsules with one centre and one radius, as of a post and a bar: the ball slides over the common sphere.
        var tip = new Vector3d(0, 2.1, 0);
        var post = new Obstacle { Name = "post", Shape = new CapsuleShape(Vector3d.Zero, tip, 0.04) };
        var bar = new Obstacle { Name = "bar", Shape = new CapsuleShape(tip, tip + new Vector3d(3, 0, 0), 0.04) };
        BallState both = Slid([post, bar], speed, spin, out StepLog log);
        BallState one = Slid([post], speed, spin, out _);
        Assert.Equal(0, Impacts(log));
        Assert.InRange(log.Evaluations, 1, Few);
        Assert.InRange((both.Position - one.Position).Length, 0, 1e-7);
    }

    [Fact]
    public void A_knuckle_force_that_presses_a_ball_onto_a_wall_takes_no_impacts()
    {
        // In flight the force presses the ball onto the wall, where it does not act: the ball must not go to and fro between the two.
        var board = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 5, -0.05), new Vector3d(50, 50, 0.05)), Surface = SurfaceMaterial.Board };
        int pressed = 0;
        for (int seed = 0; seed < 60; seed++)
        {
            var scene = Scene.Default with
            {
                Obstacles = [board],
                Air = new Air { Wind = new Vector3d(11, 0, 0) },
                Forces = ForceSet.Measured with { KnuckleSeed = seed },
            };
            var simulator = new Simulator(scene);
            BallState ball = simulator.Launch(new Vector3d(0, 2, Radius + 1e-4), new Vector3d(0, 0, -0.003), Vector3d.Zero);
            var log = new StepLog();
            for (int i = 0; i < 15; i++)
            {
                log.Clear();
                simulator.Step(ref ball, Tick, log);
                Assert.Equal(0, log.StalledSteps);
                Assert.True(log.Evaluations < Few, $"seed {seed}: {log.Evaluations} evaluations at {ball.Time} s, {ball}");
                pressed += ball.Motion == MotionState.Sliding ? 1 : 0;
            }
        }

        Assert.True(pressed > 10, $"{pressed} steps on the wall");
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_body_that_pushes_a_ball_leads_no_path_into_what_stands(bool atPost)
    {
        var standing = new List<Obstacle>();
        var foot = new Vector3d(0.6, 0, 0);
        if (atPost)
        {
            standing.Add(new Obstacle { Name = "post", Shape = new CapsuleShape(foot, new Vector3d(0.6, 2, 0), 0.06) });
        }

        for (int seed = 0; seed < 400; seed++)
        {
            var random = new Shots(seed);
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", BodyKind.Player);
            var simulator = new Simulator(Scene.Default with { Bodies = bodies, Obstacles = standing });
            BallState ball = simulator.Launch(new Vector3d(0.2, Radius, random.Uniform(-0.05, 0.05)), Vector3d.Zero, Vector3d.Zero);
            double speed = random.Uniform(0.3, 4);
            double brake = random.Uniform(0, 6);
            var place = new Vector3d(-0.3, 0, random.Uniform(-0.1, 0.1));
            var path = new Trajectory();
            for (int tick = 0; tick < 60; tick++)
            {
                player.MoveTo(place, new Vector3d(speed, 0, 0), ball.Time);
                simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = 1.0 / 60, Duration = 1.0 / 60, StopAt = StopAt.Time }, path);
                for (int k = 1; k < 8; k++)
                {
                    Vector3d at = path.PositionAt(ball.Time + (k / 480.0));
                    double toPost = atPost ? (at - foot).Horizontal.Length - 0.06 : 1;
                    double depth = Radius - Math.Min(at.Y, toPost);
                    Assert.True(depth <= 1e-6, $"seed {seed}, {ball.Time} s: {depth} m, {ball}");
                }

                simulator.Step(ref ball, 1.0 / 60, new StepLog());
                place += new Vector3d(speed / 60, 0, 0);
                speed = Math.Max(0, speed - (brake / 60));
            }
        }
    }

    private static int Impacts(StepLog log)
    {
        int impacts = 0;
        foreach (ref readonly BallEvent item in log.Events)
        {
            impacts += item.Kind == BallEventKind.Impact ? 1 : 0;
        }

        return impacts;
    }

    private static BallState Slid(Obstacle[] obstacles, double speed, double spin, out StepLog log)
    {
        var simulator = new Simulator(Scene.Default with { Obstacles = obstacles });
        var n = new Vector3d(-0.02, 0.8, 0.6).Normalized();
        BallState ball = simulator.Launch(new Vector3d(0, 2.1, 0) + ((Radius + 0.04) * n), new Vector3d(-speed, 0, 0) - (Vector3d.Dot(new Vector3d(-speed, 0, 0), n) * n), spin * n);
        log = new StepLog();
        simulator.Step(ref ball, Tick, log);
        return ball;
    }
}
