using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Things;

/// <summary>Nets as they are asked: their boxes, which of them a ball is in, and how long a part of a step in them may be.</summary>
public sealed class NetSheetTests
{
    [Fact]
    public void A_box_around_a_net_is_as_large_as_the_net()
    {
        var random = new Random(3);
        for (int i = 0; i < 100; i++)
        {
            Vector3d normal = new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();
            Vector3d along = Vector3d.Cross(in normal, new Vector3d(random.NextDouble(), 0.3, random.NextDouble() - 2)).Normalized();
            Vector3d across = Vector3d.Cross(in normal, in along);
            var center = new Vector3d(random.Next(-5, 5), 1, random.Next(-5, 5));
            var net = new NetSheet(new Net { Center = center, Normal = normal, Along = along, HalfLength = 3.5, HalfWidth = 1.2 }, new BallProperties());
            Vector3d[] corners = [.. from a in new[] { -3.5, 3.5 } from b in new[] { -1.2, 1.2 } select center + (a * along) + (b * across)];
            Bounds3d box = net.Bounds;
            foreach (Func<Vector3d, double> axis in new Func<Vector3d, double>[] { p => p.X, p => p.Y, p => p.Z })
            {
                Assert.Equal(corners.Min(axis), axis(box.Min), 1e-12);
                Assert.Equal(corners.Max(axis), axis(box.Max), 1e-12);
            }
        }
    }

    [Fact]
    public void A_ball_is_deepest_in_the_net_that_it_is_deepest_in()
    {
        var simulator = new Simulator(Pitch.Standard.On());
        World world = simulator.World!;
        var random = new Random(8);
        for (int i = 0; i < 300; i++)
        {
            BallState state = simulator.Launch(new Vector3d(8 * (random.NextDouble() - 0.5), 0.2 + (3 * random.NextDouble()), 52.5 + (3 * random.NextDouble())), new Vector3d(1, 0, 0), Vector3d.Zero);
            state.Nets = (ulong)random.Next(1 << world.Nets.Length);
            state.NetSides = (ulong)random.Next(1 << world.Nets.Length);
            int expected = -1;
            double most = double.NegativeInfinity;
            for (int net = 0; net < world.Nets.Length; net++)
            {
                // δ = r − σ (p − c)·n
                double side = (state.NetSides >> net & 1) != 0 ? 1 : -1;
                double depth = world.Ball.Radius - (side * world.Nets[net].PlaceInFrame(state.Position).Z);
                if ((state.Nets >> net & 1) != 0 && depth > most)
                {
                    most = depth;
                    expected = net;
                }
            }

            Assert.Equal(expected, world.DeepestNet(in state));
            Assert.False(world.HangsInNet(in state));
            state.Motion = MotionState.Stopped;
            state.Carrier = random.Next(2) == 0 ? 0 : world.ThingOfNet(random.Next(world.Nets.Length));
            Assert.Equal(state.Carrier != 0 && state.Nets != 0, world.HangsInNet(in state));
        }
    }

    /// <summary>However deep and fast, a step of 1/60 s is as good as fifty short ones: the parts are as short as the net is stiff there.</summary>
    [Theory]
    [ProfileData]
    public void A_frame_in_a_net_ends_where_short_steps_end(Profile profile)
    {
        Scene scene = Pitch.Standard.On() with { Forces = profile.Forces() };
        scene = scene with { Nets = [.. scene.Nets.Select(net => net with { Stiffness = 3 * net.Stiffness })] };
        double worst = 0;
        foreach (double speed in new[] { 8.0, 20, 33 })
        {
            foreach (double side in new[] { -0.2, 0.0, 0.35 })
            {
                // From the line into the back net, and back out of it.
                var velocity = new Vector3d(side * speed, 0.12 * speed, speed);
                Vector3d coarse = After(1.0 / 60);
                Vector3d fine = After(1.0 / 3000);
                worst = Math.Max(worst, (coarse - fine).Length);

                Vector3d After(double step)
                {
                    var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
                    BallState state = simulator.Launch(new Vector3d(0.5, 1.1, 52.3), velocity, new Vector3d(10, 20, -5));
                    var log = new StepLog();
                    simulator.Run(ref state, step, 24.0 / 60, StopAt.Time, log);
                    Assert.Contains(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Net);
                    return state.Position;
                }
            }
        }

        Assert.InRange(worst, 0, 2e-5);
    }
}
