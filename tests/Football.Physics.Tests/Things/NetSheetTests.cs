using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>A net by itself: its box, what it does to a ball at a depth, how fast, and how far a part of a step may go.</summary>
public sealed class NetSheetTests
{
    private static readonly BallProperties Ball = Scene.Default.Ball;
    private static readonly Vector3d Normal = new Vector3d(1, 2, 0.5).Normalized();
    private static readonly Vector3d Along = Vector3d.Cross(in Normal, new Vector3d(0.3, -0.4, 1)).Normalized();

    private static readonly Net Net = new() { Center = new Vector3d(3, 2, -1), Normal = Normal, Along = Along, HalfLength = 2, HalfWidth = 0.7 };

    [Fact]
    public void Its_box_is_that_of_its_corners()
    {
        Vector3d across = Vector3d.Cross(in Normal, in Along);
        Vector3d[] corners = [.. from a in new[] { -2.0, 2 } from b in new[] { -0.7, 0.7 } select Net.Center + (a * Along) + (b * across)];
        Bounds3d box = new NetSheet(Net, Ball).Bounds;
        Assert.Equal(corners.Min(at => at.X), box.Min.X, 1e-12);
        Assert.Equal(corners.Min(at => at.Y), box.Min.Y, 1e-12);
        Assert.Equal(corners.Min(at => at.Z), box.Min.Z, 1e-12);
        Assert.Equal(corners.Max(at => at.X), box.Max.X, 1e-12);
        Assert.Equal(corners.Max(at => at.Y), box.Max.Y, 1e-12);
        Assert.Equal(corners.Max(at => at.Z), box.Max.Z, 1e-12);
    }

    /// <summary>At a depth δ it pulls with k δ/m, by b δ̇ more, holds along itself and takes spin: each from its own equation, on both sides.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void It_pulls_holds_and_takes_spin_by_its_depth(double side)
    {
        var sheet = new NetSheet(Net, Ball);
        const double Depth = 0.08;
        Vector3d place = Net.Center + (side * (Ball.Radius - Depth) * Normal) + (0.4 * Along);
        var spin = new Vector3d(3, -20, 7);
        foreach ((double inward, double along) in new[] { (0.0, 0.0), (0.3, 2.0), (-0.2, -1.0), (-3.0, 1.0) })
        {
            MotionRates push = sheet.Push(new FootballPhysics.Motion(place, (-side * inward * Normal) + (along * Along), in spin), side);
            double pull = Math.Max(0, Net.Stiffness * Depth * (1 + (Net.Damping * inward))) / Ball.Mass;
            Assert.Equal(side * pull, Vector3d.Dot(push.Acceleration, in Normal), 1e-9);
            Assert.Equal(-Net.TangentialDamping * Depth * along / Ball.Mass, Vector3d.Dot(push.Acceleration, in Along), 1e-9);
            Assert.Equal(0, (push.SpinAcceleration + (Net.SpinDamping * Depth / Ball.MomentOfInertia * spin)).Length, 1e-9);
        }

        MotionRates off = sheet.Push(new FootballPhysics.Motion(Net.Center + (side * 2 * Ball.Radius * Normal), Along, in spin), side);
        Assert.Equal(0, off.Acceleration.Length + off.SpinAcceleration.Length);
    }

    /// <summary>Its rates, by differences of the push itself: those of the damped pull, the hold and the spin together, and √(k/m) of the spring.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(0.05)]
    [InlineData(0.2)]
    public void Its_rate_is_that_of_all_that_it_does(double depth)
    {
        var sheet = new NetSheet(Net, Ball);
        Vector3d place = Net.Center + ((Ball.Radius - depth) * Normal);
        MotionRates At(Vector3d velocity, Vector3d spin) => sheet.Push(new FootballPhysics.Motion(in place, in velocity, in spin), 1);
        double pull = Vector3d.Dot(At(Vector3d.Zero, Vector3d.Zero).Acceleration - At(0.1 * Normal, Vector3d.Zero).Acceleration, in Normal) / 0.1;
        double hold = -Vector3d.Dot(At(Along, Vector3d.Zero).Acceleration, in Along);
        double spin = -At(Vector3d.Zero, Vector3d.Up).SpinAcceleration.Y;
        Assert.Equal(pull + hold + spin + Math.Sqrt(Net.Stiffness / Ball.Mass), sheet.RateAt(depth), 1e-8);
    }

    /// <summary>A spring alone, x⁽⁶⁾ = −k³ x, and a hold alone, x⁽⁶⁾ = −λ⁵ v: |x⁽⁶⁾| h⁶/46080.</summary>
    [Fact]
    public void A_path_bends_off_its_ends_by_its_sixth_derivative()
    {
        const double Depth = 0.05;
        Vector3d place = Net.Center + ((Ball.Radius - Depth) * Normal);
        Net spring = Net with { Damping = 0, TangentialDamping = 0 };
        Net hold = Net with { Stiffness = 0, Damping = 0 };
        double k = Net.Stiffness / Ball.Mass;
        foreach (double h in new[] { 0.001, 0.004 })
        {
            double expected = Math.Pow(h, 6) * k * k * k * Depth / 46080;
            Assert.Equal(1, new NetSheet(spring, Ball).Bends(in place, Vector3d.Zero, 1, h) / expected, 1e-10);
            double deepest = Depth + (3 * h);
            double lambda = Net.TangentialDamping / Ball.Mass * deepest;
            double held = Math.Pow(h, 6) * Math.Pow(lambda, 5) * 3 / 46080;
            Assert.Equal(1, new NetSheet(hold, Ball).Bends(in place, 3 * Along, 1, h) / held, 1e-10);
            Assert.Equal(0, new NetSheet(hold, Ball).Bends(in place, 3 * Normal, 1, h), 1e-25);

            // With its damping the pull settles at k b δ + √k, and is 1 + b δ̇ as strong.
            double rate = (k * Net.Damping * deepest) + Math.Sqrt(k);
            double pulled = Math.Pow(h, 6) * Math.Pow(rate, 4) * k * deepest * (1 + (Net.Damping * 3)) / 46080;
            Assert.Equal(1, new NetSheet(Net with { TangentialDamping = 0 }, Ball).Bends(in place, -3 * Normal, 1, h) / pulled, 1e-10);
        }
    }

    /// <summary>A part p is as long as p Σ λ(δ + p v) = c allows: the rates of all nets that hold the ball add up.</summary>
    [Fact]
    public void A_part_of_a_step_in_nets_is_as_long_as_the_rate_at_its_end_allows()
    {
        Net other = Net with { Name = "other", Stiffness = 4000 };
        Scene scene = Scene.Default with { Nets = [Net, other] };
        var world = new World(scene);
        var sheet = new NetSheet(Net, scene.Ball);
        var second = new NetSheet(other, scene.Ball);
        double At(double depth, double speed, ulong nets = 1, ulong sides = 3) =>
            world.NetForces.Longest(nets, sides, Net.Center + ((Ball.Radius - depth) * Normal), speed * Along);
        double change = At(0, 0) * sheet.RateAt(0);
        foreach ((double depth, double speed) in new[] { (0.0, 0.0), (0.05, 0.0), (0.05, 3.0), (0.1, 20.0) })
        {
            double part = At(depth, speed);
            Assert.Equal(change, part * sheet.RateAt(depth + (part * speed)), 1e-9);
            double both = At(depth, speed, 3);
            Assert.Equal(change, both * (sheet.RateAt(depth + (both * speed)) + second.RateAt(depth + (both * speed))), 1e-9);
            Assert.True(both < At(depth, speed, 2) && At(depth, speed, 2) < part);
        }

        // Off the net it is as at its face; the other side is another depth.
        Assert.Equal(At(0, 0), At(-0.05, 0), 1e-12);
        Assert.Equal(At((2 * Ball.Radius) - 0.05, 0), At(0.05, 0, 1, 0), 1e-12);
        Assert.Equal(double.PositiveInfinity, At(0.05, 1, 0));
    }

    /// <summary>The deepest of the nets that the ball is in, the first of those as deep; none where it is in none.</summary>
    [Fact]
    public void The_deepest_net_is_looked_for_among_those_that_the_ball_is_in()
    {
        Net[] nets = [.. new[] { 0.0, 0.03, 0.06, 0.03 }.Select(off => Net with { Center = Net.Center + (off * Normal) })];
        var world = new World(Scene.Default with { Nets = nets });
        BallState state = default;
        state.Position = Net.Center + (0.08 * Normal);
        foreach ((ulong inside, ulong sides, int expected) in new (ulong, ulong, int)[] { (0, 15, -1), (1, 15, 0), (15, 15, 2), (11, 15, 1), (10, 15, 1), (9, 15, 3), (3, 15, 1), (15, 0, 0), (8, 15, 3), (14, 0, 1) })
        {
            state.Nets = inside;
            state.NetSides = sides;
            Assert.Equal(expected, world.NetForces.Deepest(in state));
        }
    }

    [Fact]
    public void A_ball_hangs_in_a_net_that_stopped_there_and_on_nothing_else()
    {
        var simulator = new Simulator(Pitch.Standard.On());
        World world = simulator.World!;
        BallState state = simulator.Launch(new Vector3d(0, 1, 53), new Vector3d(1, 0, 0), Vector3d.Zero);
        foreach (MotionState motion in new[] { MotionState.Airborne, MotionState.Rest })
        {
            foreach (ulong nets in new[] { 0ul, 2ul })
            {
                foreach (int carrier in new[] { 0, world.ThingOfNet(0), world.ThingOfNet(1) })
                {
                    state.Motion = motion;
                    state.Nets = nets;
                    state.Carrier = carrier;
                    Assert.Equal(motion == MotionState.Rest && nets != 0 && carrier != 0, world.HangsInNet(in state));
                }
            }
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
