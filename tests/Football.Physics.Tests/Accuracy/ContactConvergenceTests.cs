using System.Globalization;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>Measured orders of the methods in contact sets, between events: several surfaces press on a ball in air, and all modes stay the same.</summary>
public sealed class ContactConvergenceTests
{
    private const double Radius = 0.11;
    private const double Finest = 1e-4;
    private const int Halvings = 3;

    /// <summary>A ball that touches and is pressed may tell of it until then, s.</summary>
    private const double Begins = 1e-3;

    /// <summary>The length of every motion, s: a whole number of all steps.</summary>
    private const double Duration = 0.4;

    /// <summary>Light, so that the air makes errors that can be measured in few steps.</summary>
    private static readonly BallProperties s_ball = BallProperties.Tunnel with { Mass = 0.2 };

    /// <summary>Smooth, so that drilling friction on the ground keeps the ball from turning along the board.</summary>
    private static readonly SurfaceMaterial s_board = SurfaceMaterial.HardGround with { SlidingFriction = 0.1 };

    [Theory]
    [InlineData(Integrator.Rk2, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 3.8, 4.6)]
    public void Along_a_board_that_wind_presses_the_ball_against(Integrator integrator, double low, double high) =>
        Hold("along a board", integrator, low, high, random =>
        {
            // Rolls on the ground, slips on the board.
            Scene scene = InWind(new Vector3d(random.Uniform(4, 7), 0, random.Uniform(-2, 2))) with { Obstacles = [Board("board", new Vector3d(-1, 0, 0))] };
            return (scene, [Rolling(Vector3d.Zero, new Vector3d(0, 0, -random.Uniform(6, 9)), Vector3d.Up)]);
        });

    [Theory]
    [InlineData(Integrator.Rk2, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 3.8, 4.6)]
    public void Sliding_along_a_board_and_on_the_ground(Integrator integrator, double low, double high) =>
        Hold("sliding on both", integrator, low, high, random =>
        {
            Scene scene = InWind(new Vector3d(random.Uniform(4, 7), 0, random.Uniform(-3, 3))) with
            {
                Obstacles = [Board("board", new Vector3d(-1, 0, 0))],
                Ground = Ground.Of(SurfaceMaterial.DryTurf with { SlidingFriction = 0.15 }),
            };

            // Topspin, and a sidespin that presses the ball against the board: no load ends, and that on the ground stays the greatest.
            var spin = new Vector3d(random.Uniform(-15, -5), random.Uniform(-12, -5), random.Uniform(-10, 10));
            return (scene, [(new Vector3d(0, Radius, 0), new Vector3d(0, 0, -random.Uniform(12, 16)), spin)]);
        });

    [Theory]
    [InlineData(Integrator.Rk2, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 3.8, 4.6)]
    public void Between_two_boards(Integrator integrator, double low, double high) =>
        Hold("between two boards", integrator, low, high, random =>
        {
            // The board behind merely touches.
            Scene scene = InWind(new Vector3d(random.Uniform(4, 7), 0, random.Uniform(-2, 2))) with
            {
                Obstacles = [Board("board", new Vector3d(-1, 0, 0)), Board("other board", new Vector3d(1, 0, 0))],
            };
            return (scene, [Rolling(Vector3d.Zero, new Vector3d(0, 0, -random.Uniform(6, 9)), Vector3d.Up)]);
        });

    [Theory]
    [InlineData(Integrator.Rk2, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 3.8, 4.6)]
    public void In_a_tilted_gutter(Integrator integrator, double low, double high) =>
        Hold("in a tilted gutter", integrator, low, high, random =>
        {
            (Scene scene, (Vector3d Position, Vector3d Velocity, Vector3d Spin) ball) = Gutter(random.Uniform(5, 15), random.Uniform(25, 50), random.Uniform(5, 9), new Vector3d(random.Uniform(1, 2), 0, random.Uniform(-4, 4)));

            // The wind across keeps the load of one side the greatest.
            return (scene, [ball]);
        });

    private static Obstacle Board(string name, in Vector3d normal) => new() { Name = name, Shape = new PlaneShape(-Radius * normal, normal), Surface = s_board };

    private static Scene InWind(Vector3d wind) => new() { Ball = s_ball, Ground = Ground.Of(SurfaceMaterial.DryTurf), Air = new Air { Wind = wind } };

    private static (Vector3d Position, Vector3d Velocity, Vector3d Spin) Rolling(in Vector3d at, in Vector3d velocity, in Vector3d normal) =>
        (at + (Radius * normal), velocity, Vector3d.Cross(normal, velocity) / Radius);

    /// <summary>Two planes at ±β from the horizontal, whose line runs down by θ towards −z; the ball rolls on both without slip.</summary>
    private static (Scene Scene, (Vector3d Position, Vector3d Velocity, Vector3d Spin) Ball) Gutter(double degrees, double sides, double speed, in Vector3d wind)
    {
        double tilt = degrees * Math.PI / 180;
        double side = sides * Math.PI / 180;
        var up = new Vector3d(0, Math.Cos(tilt), -Math.Sin(tilt));
        var along = new Vector3d(0, -Math.Sin(tilt), -Math.Cos(tilt));
        var across = new Vector3d(1, 0, 0);
        Vector3d left = (Math.Cos(side) * up) + (Math.Sin(side) * across);
        Vector3d right = (Math.Cos(side) * up) - (Math.Sin(side) * across);
        Vector3d position = Radius / Math.Cos(side) * up;
        SurfaceMaterial turf = SurfaceMaterial.DryTurf with { SlidingFriction = 0.9 };
        Scene scene = InWind(wind) with
        {
            Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = -50 },
            Obstacles =
            [
                new Obstacle { Name = "left", Shape = new PlaneShape(Vector3d.Zero, left), Surface = turf },
                new Obstacle { Name = "right", Shape = new PlaneShape(Vector3d.Zero, right), Surface = turf },
            ],
        };

        // ω = v/(r cos β) about the axis through both contacts.
        Vector3d spin = speed / (Radius * Math.Cos(side)) * Vector3d.Cross(up, along);
        return (scene, (position, speed * along, spin));
    }

    private static void Hold(
        string what,
        Integrator integrator,
        double low,
        double high,
        Func<Shots, (Scene Scene, (Vector3d Position, Vector3d Velocity, Vector3d Spin)[] Balls)> draw)
    {
        var random = new Shots(2606);
        var orders = new List<double>();
        double coarsest = integrator == Integrator.Rk4 ? 0.1 : 0.02;
        var largest = new Errors($"{what}: error of the coarsest step");
        for (int i = 0; i < 6; i++)
        {
            (Scene scene, (Vector3d Position, Vector3d Velocity, Vector3d Spin)[] balls) = draw(random);
            BallState[] truth = End(scene, balls, Integrator.Rk4, Finest);
            Assert.All(truth, state => Assert.True(state.Motion is MotionState.Rolling or MotionState.Sliding, $"{what}: {state.Motion}"));
            double Error(double step) => End(scene, balls, integrator, step).Zip(truth).Sum(pair => Vector3d.Distance(pair.First.Position, pair.Second.Position)
                + (0.1 * Vector3d.Distance(pair.First.Velocity, pair.Second.Velocity))
                + (0.01 * Vector3d.Distance(pair.First.Spin, pair.Second.Spin)));

            orders.Add(Order.Observed(coarsest, Halvings, Error));
            largest.Add(i.ToString(CultureInfo.InvariantCulture), Error(coarsest));
        }

        Order.Hold($"{what}, {integrator}", orders, low, high);

        // An order alone could be that of a wrong motion.
        largest.Hold(worst: 1e-3);
    }

    private static BallState[] End(
        Scene scene, (Vector3d Position, Vector3d Velocity, Vector3d Spin)[] balls, Integrator integrator, double step)
    {
        var group = new BallGroup(new Simulator(scene, Flight.With(integrator)), balls.Length);
        BallState[] states = [.. balls.Select((ball, i) => group.SimulatorOf(i).Launch(ball.Position, ball.Velocity, ball.Spin))];
        var log = new StepLog();
        group.Run(states, step, Duration, StopAt.Time, log);

        // Between events: but for contacts that begin at the launch, nothing may happen in any of the runs.
        BallEvent[] later = [.. log.Events.Span.ToArray().Where(item => item.Time > Begins)];
        Assert.True(later.Length == 0, $"{later.Length} events, the first {later.FirstOrDefault()}");
        return states;
    }
}
