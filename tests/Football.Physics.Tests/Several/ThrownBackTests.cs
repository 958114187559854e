using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Several;

/// <summary>A ball that another ball throws back onto the body that it has just hit: the second impact obeys the law of impacts as the first did.</summary>
public sealed class ThrownBackTests
{
    private const double Mass = 75;

    /// <summary>Cases in which velocity, spin and impulse of the second impact contradicted each other (found by a search, 3 of 4 000).</summary>
    [Fact]
    public void The_cases_that_were_found()
    {
        SurfaceMaterial body = SurfaceMaterial.GoalFrame with { NormalRestitution = 0.6011724861167108, RestitutionSpeedScale = 18.39461396645164, TangentialRestitution = -0.18793663842793779, ImpactFriction = 0.5979869738108475 };
        SurfaceMaterial balls = SurfaceMaterial.Ball with { NormalRestitution = 0.5201837834245777, RestitutionSpeedScale = 30, TangentialRestitution = 0.22431925574960954, ImpactFriction = 0.24773386703277578 };
        int hits = Check(
            new SphereShape(new Vector3d(-0.679964644403389, 2.2491085927090726, -1.9595654647670944), 0.12630934989983506), new Vector3d(2.0483327749075535, 1.8450911568822174, 6.171345052453838), body, balls,
            (new Vector3d(-0.3780186089494716, 2.9147219220490452, 5.89609085226801), new Vector3d(1.2228813532303726, 1.2677234527575696, -19.07371592162673), new Vector3d(-8.062683650086043, -11.137846402878743, 18.99720108082558)),
            (new Vector3d(0.6955042172574917, 2.0975827096459474, 1.916992020263181), new Vector3d(-2.1228588720272965, 4.007891467243414, -6.325872985388068), new Vector3d(12.645411397426008, 29.671614266239942, 11.000058239900271)),
            0.6851484847078771);
        body = body with { NormalRestitution = 0.763861368583278, RestitutionSpeedScale = 19.902699666454577, TangentialRestitution = -0.10875975794861281, ImpactFriction = 0.38087028622549235 };
        balls = balls with { NormalRestitution = 0.526514329043574, TangentialRestitution = 0.13792472599640504, ImpactFriction = 0.4102540197381581 };
        hits += Check(
            new SphereShape(new Vector3d(0.9346565435901574, 3.9038745665213637, -1.2401972507375982), 0.1038347537830783), new Vector3d(-5.14366916497422, -1.898169680140218, 7.32992505384915), body, balls,
            (new Vector3d(-0.9025113195831663, 3.6884689189285287, 0.7514912597623677), new Vector3d(5.039762163042905, 0.05872979759581379, -4.196442897311301), new Vector3d(-8.98492263409371, 46.207185295232314, 17.85609512490564)),
            (new Vector3d(-2.2311537978485596, 2.6493348561264147, 1.7774133587257173), new Vector3d(12.122532121823467, 6.1034811587533975, -9.816162539428042), new Vector3d(-0.9414829715646675, 32.15565124542654, -16.62957725252607)),
            0.5645861758485673);
        Assert.InRange(hits, 4, 20);
    }

    /// <summary>A body, a ball just before it, and a second ball that comes straight after the first: thrown back onto the body within a tenth of a second.</summary>
    [Fact]
    public void Random_ones()
    {
        var random = new Shots(1639);
        int again = 0;
        for (int i = 0; i < 1500; i++)
        {
            SurfaceMaterial body = SurfaceMaterial.GoalFrame with
            {
                NormalRestitution = random.Uniform(0.3, 0.95),
                RestitutionSpeedScale = random.Uniform(15, 60),
                TangentialRestitution = random.Uniform(-0.5, 0.5),
                ImpactFriction = random.Uniform(0.1, 1),
            };
            SurfaceMaterial balls = SurfaceMaterial.Ball with { NormalRestitution = random.Uniform(0.5, 0.95), TangentialRestitution = random.Uniform(-0.5, 0.5), ImpactFriction = random.Uniform(0.1, 0.8) };
            var at = new Vector3d(0, 6, 0);
            Vector3d speed = random.Uniform(2, 9) * new Vector3d(random.Uniform(-0.1, 0.1), random.Uniform(-0.1, 0.1), 1);
            Vector3d Close() => new(random.Uniform(-0.05, 0.05), random.Uniform(-0.05, 0.05), 0);
            int hits = Check(
                new SphereShape(at, random.Uniform(0.1, 0.4)), speed, body, balls,
                (at + Close() + new Vector3d(0, 0, 1.5), new Vector3d(0, 0, -random.Uniform(1, 15)), random.Uniform(0, 40) * random.Direction()),
                (at + Close() + new Vector3d(0, 0, 1.9), new Vector3d(0, 0, -random.Uniform(10, 30)), random.Uniform(0, 40) * random.Direction()),
                0.4);
            again += hits > 1 ? 1 : 0;
        }

        Assert.InRange(again, 300, 1500);
    }

    /// <summary>Two bodies that run at each other bat one ball to and fro: every impact keeps the balance of its impulse and spin, and once they squeeze the ball they give it no more speed than its own or 1 + e times theirs.</summary>
    [Fact]
    public void Batted_to_and_fro_the_balance_holds_too()
    {
        var random = new Shots(42);
        int impacts = 0;
        int squeezes = 0;
        for (int i = 0; i < 300; i++)
        {
            double fast = random.Uniform(1, 8);
            SurfaceMaterial surface = SurfaceMaterial.Boot with { NormalRestitution = random.Uniform(0.5, 0.95), ImpactFriction = random.Uniform(0.1, 1), TangentialRestitution = random.Uniform(-0.4, 0.4) };
            Obstacle Bat(double x, double v) => new() { Shape = new BoxShape(new Vector3d(x, 5, 0), new Vector3d(0.1, 1, 1)), Velocity = new Vector3d(v, 0, 0), Surface = surface };
            var simulator = new Simulator(new Scene { Obstacles = [Bat(-0.8, fast), Bat(0.8, -random.Uniform(0, fast))] });
            BallState ball = simulator.Launch(new Vector3d(random.Uniform(-0.4, 0.4), 5, 0), random.Uniform(0, 5) * random.Direction(), random.Uniform(0, 50) * random.Direction());
            double given = (1 + Math.Min(1, 1.2 * surface.NormalRestitution)) * fast;
            var log = new StepLog();
            for (int frame = 0; frame < 30; frame++)
            {
                log.Clear();
                double came = ball.Velocity.Length;
                bool squeezed = ball.Motion == MotionState.Pinned;
                double spins = 0;
                simulator.Step(ref ball, 1.0 / 60, log);
                foreach (BallEvent item in log.Events)
                {
                    squeezed |= item.Kind == BallEventKind.Pinned;
                    spins = Math.Max(spins, simulator.Scene.Ball.Radius * item.SpinBefore.Length);
                    if (item.Kind == BallEventKind.Impact)
                    {
                        impacts++;
                        Balances(in item, simulator.Scene.Ball, $"bat {i}, frame {frame}");
                    }
                }

                // What it falls is its own, and friction may turn its spin into speed.
                squeezes += squeezed ? 1 : 0;
                Assert.True(!squeezed || ball.Velocity.Length <= Math.Max(came, given) + spins + (9.81 / 60), $"bat {i}, frame {frame}: {came} m/s became {ball.Velocity.Length} m/s");
            }
        }

        Assert.InRange(impacts, 600, 20_000);
        Assert.InRange(squeezes, 100, 20_000);
    }

    private static int Check(
        SphereShape shape, Vector3d speed, SurfaceMaterial body, SurfaceMaterial balls, (Vector3d Position, Vector3d Velocity, Vector3d Spin) first, (Vector3d Position, Vector3d Velocity, Vector3d Spin) second, double time)
    {
        BallProperties[] kinds = [BallProperties.Tunnel, BallProperties.Jabulani];
        var scene = new Scene
        {
            Air = new Air { Density = 1.2, KinematicViscosity = 1.5e-5 },
            Obstacles = [new Obstacle { Name = "body", Shape = shape, Velocity = speed, Mass = Mass, Surface = body }],
        };
        var group = new BallGroup(scene, kinds, null, balls);
        BallState[] states =
        [
            group.SimulatorOf(0).Launch(first.Position, first.Velocity, first.Spin),
            group.SimulatorOf(1).Launch(second.Position, second.Velocity, second.Spin),
        ];
        var log = new StepLog(mostEvents: 4096);
        group.Run(states, 0.01, time, StopAt.Time, log);
        Vector3d velocity = speed;
        var material = new ContactMaterial(body);
        int hits = 0;
        double[] last = [double.NegativeInfinity, double.NegativeInfinity];
        BallEvent[] all = log.Events.Span.ToArray();
        for (int i = 0; i < all.Length; i++)
        {
            BallEvent item = all[i];
            if (item.Kind != BallEventKind.Impact || item.ColliderIndex != 1)
            {
                // Another ball, or the ground, comes between two hits.
                last[item.Ball] = double.NegativeInfinity;
                continue;
            }

            // One body that hits a ball twice in a tenth of a second makes it no faster: there the balance holds, and not the restitution.
            bool again = item.Time - last[item.Ball] < 0.1;
            last[item.Ball] = item.Time;

            // The whole law: from the body's velocity by all impulses before to what the event tells.
            hits++;
            BallProperties ball = kinds[item.Ball];
            Balances(in item, ball, $"{item}");

            // A ball that stays on what gives way has had an impact without restitution.
            bool stays = Array.Exists(all, next => next.Ball == item.Ball && next.Time == item.Time && next.ColliderIndex == 1 && next.Kind is BallEventKind.Slide or BallEventKind.Roll);
            ContactMaterial law = stays ? material.WithoutRestitution() : material;
            ImpactLaw.Apply(ball, in law, item.Normal, in velocity, item.VelocityBefore, item.SpinBefore, out Vector3d after, out Vector3d spin, ball.Mass / Mass);
            Assert.True(again || (after - item.Velocity).Length < 1e-9 * (1 + after.Length), $"{item}: {item.Velocity}, right: {after}");
            Assert.True(again || (spin - item.Spin).Length < 1e-9 * (1 + spin.Length), $"{item}: spin {item.Spin}, right: {spin}");
            velocity -= (ball.Mass * (item.Velocity - item.VelocityBefore)) / Mass;
        }

        return hits;
    }

    /// <summary>I (ω' − ω) = (−r n) × J, but for what the contact takes of the spin about its normal.</summary>
    private static void Balances(in BallEvent item, BallProperties ball, string what)
    {
        Vector3d impulse = ball.Mass * (item.Velocity - item.VelocityBefore);
        Vector3d torque = Vector3d.Cross(-ball.Radius * item.Normal, in impulse);
        Vector3d change = ball.MomentOfInertia * (item.Spin - item.SpinBefore);
        Vector3d off = change - torque;
        Vector3d along = off - (Vector3d.Dot(in off, item.Normal) * item.Normal);
        Assert.True(along.Length < 1e-9 * (1 + impulse.Length), $"{what}: I Δω {change}, r × J {torque}");
    }
}
