using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Players push a ball along a post in long steps: the path of a step leads round the post, not through it.</summary>
public sealed class PushedAlongPostTests
{
    private const double Radius = 0.11;
    private const double PostRadius = 0.06;
    private const double PlayerRadius = 0.25;
    private const double Height = 1.2;

    /// <summary>A path is no deeper in the post than this, m.</summary>
    private const double Entered = 1e-6;

    /// <summary>A ball that is on the post is no farther off than this, m.</summary>
    private const double Touching = 1e-5;

    /// <summary>Places in a step at which the path is compared with the post.</summary>
    private const int Samples = 200;

    /// <summary>The limit of a step, and the trials of a group beside it.</summary>
    private const long MostEvaluations = 32_768;

    private static readonly IShape s_player = new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), PlayerRadius);

    /// <summary>A part of 0.1 s, all that was left of a step, turned the normal of a post by half a radian; its path was 0.6 mm inside.</summary>
    [Theory]
    [InlineData(0.05, 1)]
    [InlineData(0.15, 1)]
    [InlineData(0.25, 1)]
    [InlineData(1, 1)]
    [InlineData(0.15, 2)]
    [InlineData(0.25, 2)]
    public void The_path_stays_outside_the_post(double frame, int count)
    {
        var random = new Shots(91);
        double deepest = 0;
        int along = 0;
        string where = "";
        for (int i = 0; i < 60; i++)
        {
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", s_player);
            var post = new Obstacle { Name = "post", Shape = new CapsuleShape(Vector3d.Zero, new Vector3d(0, 3, 0), PostRadius), Surface = SurfaceMaterial.GoalFrame };
            var simulator = new Simulator(Scene.Default with { Bodies = bodies, Obstacles = [post] });

            // The player runs past the post, and has the ball between himself and the post.
            double speed = random.Uniform(0.3, 4);
            double aside = random.Uniform(0.1, PostRadius + Radius + PlayerRadius);
            var from = new Vector3d(-Math.Sqrt(Square(PostRadius + (2 * Radius) + PlayerRadius) - Square(aside)), 0, aside);
            player.MoveTo(from, new Vector3d(speed, 0, 0), 0);
            Vector3d place = ((PostRadius + Radius) / (PostRadius + (2 * Radius) + PlayerRadius) * from) + new Vector3d(0, Height, 0);
            BallState[] balls = new BallState[count];
            balls[0] = simulator.Launch(place, Vector3d.Zero, Vector3d.Zero);
            Trajectory[] paths = new Trajectory[count];
            for (int k = 0; k < count; k++)
            {
                paths[k] = new Trajectory(1 << 12);
            }

            if (count > 1)
            {
                // A second ball falls onto the first one, and interrupts its step.
                balls[1] = simulator.Launch(place + new Vector3d(-0.05, 0.23 + (frame * i / 400), 0.05), Vector3d.Zero, Vector3d.Zero);
            }

            BallGroup? group = count > 1 ? new BallGroup(simulator, count) : null;
            var log = new StepLog();
            for (int step = 0; step * frame < 0.5; step++)
            {
                player.MoveTo(from + (step * frame * speed * new Vector3d(1, 0, 0)), new Vector3d(speed, 0, 0), balls[0].Time);
                Vector3d start = balls[0].Position;
                double time = balls[0].Time;
                var look = new LookAheadRequest { TimeStep = frame, Duration = frame, StopAt = StopAt.Time };
                log.Clear();
                if (group is null)
                {
                    simulator.LookAhead(in balls[0], look, paths[0]);
                    simulator.Step(ref balls[0], frame, log);
                }
                else
                {
                    group.LookAhead(balls, look, paths);
                    group.Step(balls, frame, log);
                }

                Assert.Equal(0, log.StalledSteps);
                Assert.InRange(log.Evaluations, 0, count * MostEvaluations);
                for (int k = 1; k < Samples; k++)
                {
                    double depth = -Gap(paths[0].PositionAt(time + (frame * k / Samples)));
                    where = depth > deepest ? FormattableString.Invariant($"push {i}, step {step}, part {k} of {Samples}") : where;
                    deepest = Math.Max(deepest, depth);

                    // It goes along the post there, and has come round it by more than 0.1 rad.
                    double turned = Vector3d.Dot(start.Horizontal.Normalized(), paths[0].PositionAt(time + (frame * k / Samples)).Horizontal.Normalized());
                    along += Math.Abs(depth) < Touching && turned < 0.995 ? 1 : 0;
                }
            }
        }

        Assert.True(deepest <= Entered, $"{deepest} m inside: {where}");
        Assert.True(along > 100, $"{along} places along the post");
    }

    private static double Gap(Vector3d center) => center.Horizontal.Length - PostRadius - Radius;

    private static double Square(double value) => value * value;
}
