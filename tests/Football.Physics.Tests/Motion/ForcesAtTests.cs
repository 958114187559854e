using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Motion;

/// <summary>The forces that a game can show are those of the step: their sum is the acceleration of its first evaluation.</summary>
public sealed class ForcesAtTests
{
    private static readonly Obstacle s_board = new() { Name = "board", Shape = new PlaneShape(new Vector3d(2, 0, 0), new Vector3d(-1, 0, 0)), Surface = SurfaceMaterial.Board };

    /// <summary>Each scene, with a kick, and the motion or contact that it must contain.</summary>
    private static readonly Dictionary<string, (Func<Scene> Scene, Vector3d Position, Vector3d Velocity, Vector3d Spin, string Has)> s_cases = new()
    {
        ["default"] = (() => Scene.Default, new Vector3d(0, 1, 0), new Vector3d(3, 8, -22), new Vector3d(9, 50, -4), "flight ground"),
        ["published"] = (() => Scene.Published, new Vector3d(0, 1, 0), new Vector3d(3, 4, -22), new Vector3d(9, 50, -4), "flight ground"),
        ["published, no spin"] = (() => Scene.Published, new Vector3d(0, 4, 0), new Vector3d(0, 1, -14), Vector3d.Zero, "flight ground"),
        ["regularised"] = (() => Scene.Published with { Forces = ForceSet.Regularized }, new Vector3d(0, 1, 0), new Vector3d(3, 4, -22), new Vector3d(9, 50, -4), "flight ground"),
        ["vacuum"] = (() => Scene.Vacuum, new Vector3d(0, 1, 0), new Vector3d(3, 4, -12), new Vector3d(9, 50, -4), "flight ground"),
        ["gusts and seams"] = (() => new Scene
        {
            Air = new Air { Wind = new Vector3d(1, 0, 0), WindField = new WindByHeight(7, 1, -2, gusts: new Gusts { Seed = 11 }) },
            Forces = ForceSet.Measured with { KnuckleSeed = 5 },
        }, new Vector3d(0, 1, 0), new Vector3d(0, 6, -27), new Vector3d(0.5, 1, 0), "flight ground"),
        ["own force"] = (() => new Scene { Forces = ForceSet.Measured with { CustomForces = [IForce.From(at => new Vector3d(0.5, 0.2 * at.Position.Y, -0.1 * at.Velocity.Z))], KnuckleSeed = 3 } },
            new Vector3d(0, 1, 0), new Vector3d(0, 6, -15), new Vector3d(0, 30, 5), "flight ground"),
        ["beach ball"] = (() => new Scene { Ball = BallProperties.BeachBall }, new Vector3d(0, 1, 0), new Vector3d(0, 3, -12), new Vector3d(5, 20, 5), "flight ground"),
        ["slide on a slope"] = (() => new Scene { Ground = new Ground { Normal = new Vector3d(0.1, 1, 0.2) } }, new Vector3d(0, 0.11, 0), new Vector3d(2, 0, -9), new Vector3d(-60, 5, 0), "ground"),
        ["hills"] = (() => new Scene { Ground = new Ground { Heights = new HeightField(-30, -60, 15, Hills()) } }, new Vector3d(0, 1, 0), new Vector3d(1, 2, -9), new Vector3d(-20, 15, 3), "flight ground"),
        ["stripes of the wind"] = (() => new Scene { Air = new Air { Wind = new Vector3d(9, 0, 4) } }, new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -9), new Vector3d(10, 5, 60), "ground"),
        ["turntable"] = (() => new Scene
        {
            Ground = Ground.None,
            Obstacles = [new Obstacle { Shape = new PlaneShape(Vector3d.Zero, Vector3d.Up), Spin = new Vector3d(0, 2, 0), Surface = SurfaceMaterial.ArtificialTurf }],
        }, new Vector3d(1, 0.11, 0), new Vector3d(0, 0, -2), new Vector3d(0, 3, 0), "ground"),
        ["along a board"] = (() => new Scene { GravityVector = new Vector3d(3, -9.81, 0), Obstacles = [s_board] }, new Vector3d(1.7, 0.11, 0), new Vector3d(0.5, 0, -7), new Vector3d(-9, 20, 4), "ground set"),
        ["in a groove"] = (() => new Scene
        {
            Obstacles = [s_board with { Shape = new PlaneShape(new Vector3d(0.5, 0, 0), new Vector3d(-1, 0.6, 0)) }, s_board with { Shape = new PlaneShape(new Vector3d(-0.5, 0, 0), new Vector3d(1, 0.8, 0)) }],
            Ground = Ground.None,
        }, new Vector3d(0, 0.6, 0), new Vector3d(0.2, 0, -5), new Vector3d(-9, 20, 4), "set"),
        ["into the net"] = (() => new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -8), Facing = new Vector3d(0, 0, 1) }] }, new Vector3d(0, 0.5, 0), new Vector3d(1, 3, -21), new Vector3d(2, 20, 4), "flight ground net"),
        ["rolls into the net"] = (() => new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -3), Facing = new Vector3d(0, 0, 1) }] }, new Vector3d(0, 0.11, 0), new Vector3d(0.3, 0, -8), new Vector3d(-40, 3, 0), "ground net"),
    };

    public static TheoryData<string, Integrator> Cases
    {
        get
        {
            var cases = new TheoryData<string, Integrator>();
            foreach (string name in s_cases.Keys)
            {
                foreach (Integrator integrator in Enum.GetValues<Integrator>())
                {
                    cases.Add(name, integrator);
                }
            }

            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void The_sum_is_the_acceleration_of_the_first_evaluation(string name, Integrator integrator)
    {
        (Func<Scene> scene, Vector3d position, Vector3d velocity, Vector3d spin, string has) = s_cases[name];
        var simulator = new Simulator(scene(), new SolverSettings { Integrator = integrator });
        BallState ball = simulator.Launch(position, velocity, spin);
        var first = new FirstPiece();
        var log = new StepLog { Observer = first };
        var seen = new SortedSet<string>(StringComparer.Ordinal);
        int unknown = 0;
        int compared = 0;
        for (int i = 0; i < 2500 && (ball.Motion != MotionState.Rest || i < 400); i++)
        {
            double dt = i % 3 == 0 ? 1.0 / 60 : 0.004;
            BallState before = ball;
            BallForces? forces = simulator.ForcesAt(in ball, dt);
            first.Begin(ball.Time);
            log.Clear();
            simulator.Step(ref ball, dt, log);
            if (forces is null)
            {
                // The step begins with an impact, or it has used impulses.
                unknown++;
                continue;
            }

            if (before.Motion == MotionState.Rest)
            {
                Assert.True(forces.Sum.Length <= 1e-9, $"at rest the sum is {forces.Sum.Length} N");
                seen.Add("rest");
                continue;
            }

            if (first.Acceleration is { } acceleration)
            {
                double mass = simulator.Scene.Ball.Mass;
                double size = Size(forces) / mass;
                Assert.True(
                    ((forces.Sum / mass) - acceleration).Length <= 1e-12 * size,
                    $"{before.Motion} at {before.Time:R}: {forces.Sum / mass} is not {acceleration}; {((forces.Sum / mass) - acceleration).Length / size:E2}");
                Assert.True((forces.Acceleration - acceleration).Length <= 1e-12 * size);
                compared++;
                seen.Add(forces.Contacts.Count >= 2 ? "set" : forces.Contacts.Count == 1 ? "ground" : "flight");
                if (before.Nets != 0)
                {
                    seen.Add("net");
                }
            }
        }

        Assert.All(has.Split(' '), part => Assert.Contains(part, seen));
        Assert.InRange(unknown, 0, compared / 2);
    }

    /// <summary>A match of a keeper's body, a pushed obstacle, boards and nets, watched in every step, has the hashes of one that nobody watches.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Watching_changes_no_bit(bool startsFromSnapshots)
    {
        List<ulong> alone = Match(watches: false, startsFromSnapshots);
        List<ulong> watched = Match(watches: true, startsFromSnapshots);
        Assert.True(alone.Distinct().Count() > 500);
        Assert.Equal(alone, watched);
    }

    [Fact]
    public void Each_force_is_that_of_its_law()
    {
        Scene scene = Scene.Default with
        {
            Forces = ForceSet.Measured with { Drag = ForceLaw.Constant, Magnus = ForceLaw.Constant, DragCoefficient = 0.2, MagnusCoefficient = 1, CustomForces = [IForce.From(_ => new Vector3d(0.25, 0, 0.5))] },
            Air = new Air { Wind = new Vector3d(2, 0, 0) },
        };
        var simulator = new Simulator(scene);
        BallState ball = simulator.Launch(new Vector3d(0, 3, 0), new Vector3d(2, 0, -20), new Vector3d(0, 40, 0));
        BallForces forces = simulator.ForcesAt(in ball)!;
        double area = Math.PI * scene.Ball.Radius * scene.Ball.Radius;

        // ½ ρ C_D A |u|², against u = (0, 0, −20).
        AssertNear(new Vector3d(0, 0, 0.5 * scene.Air.Density * 0.2 * area * 400), forces.Drag);
        AssertNear(new Vector3d(0, -scene.Ball.Mass * scene.Gravity, 0), forces.Weight);
        AssertNear(new Vector3d(0, scene.Air.Density * 4 / 3 * Math.PI * Math.Pow(scene.Ball.Radius, 3) * scene.Gravity, 0), forces.Buoyancy);
        AssertNear(new Vector3d(0.25, 0, 0.5), forces.Custom);
        Assert.Equal(Vector3d.Zero, forces.Knuckle);
        Assert.Empty(forces.Contacts);

        // ω × u = (0, 40, 0) × (0, 0, −20) points along −x.
        Assert.True(forces.Magnus.X < -0.5 && Math.Abs(forces.Magnus.Y) + Math.Abs(forces.Magnus.Z) < 1e-12, forces.Magnus.ToString());
    }

    [Fact]
    public void A_slide_has_the_friction_of_its_load_and_a_roll_less()
    {
        Scene scene = Scene.Default;
        var simulator = new Simulator(scene);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -9), Vector3d.Zero);
        BallForces slide = simulator.ForcesAt(in ball)!;
        ContactForce contact = Assert.Single(slide.Contacts);
        Assert.Equal((0, "ground", 0.0), (contact.ColliderIndex, simulator.NameOf(contact.ColliderIndex), contact.Point.Y));
        Assert.Equal(scene.Ground.Material.SlidingFriction * contact.Load.Length, contact.Friction.Length, 1e-12);
        Assert.True(contact.Friction.Z > 0);

        ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -5), new Vector3d(-5 / 0.11, 0, 0));
        BallForces roll = simulator.ForcesAt(in ball)!;
        Assert.InRange(roll.Friction.Length, 0.01 * contact.Friction.Length, 0.5 * contact.Friction.Length);
        Assert.Equal(scene.Ball.Mass * 9.81, roll.Load.Length + roll.Buoyancy.Y + roll.Magnus.Y + roll.Drag.Y, 1e-9);
    }

    [Fact]
    public void A_ball_at_rest_is_held_and_a_step_with_an_impact_has_no_forces()
    {
        var simulator = new Simulator(new Scene { Obstacles = [s_board] });
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref ball, 0.01, 2, StopAt.Rest, log);
        Assert.Equal(MotionState.Rest, ball.Motion);
        BallForces held = simulator.ForcesAt(in ball)!;
        AssertNear(-(held.Weight + held.Buoyancy), held.Load);
        Assert.Equal(Vector3d.Zero, held.Acceleration);

        BallState falls = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, -5, 0), Vector3d.Zero);
        Assert.Null(simulator.ForcesAt(in falls));
        Assert.NotNull(new Ball(simulator).GetForces());
    }

    [Fact]
    public void Bad_arguments_are_rejected()
    {
        var simulator = new Simulator();
        BallState none = default;
        Assert.Throws<ArgumentException>(() => simulator.ForcesAt(in none));
        BallState ball = simulator.Launch(Vector3d.Up, Vector3d.Zero, Vector3d.Zero);
        Assert.Throws<ArgumentOutOfRangeException>(() => simulator.ForcesAt(in ball, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => simulator.ForcesAt(in ball, double.NaN));
    }

    private static double Size(BallForces forces) =>
        forces.Weight.Length + forces.Buoyancy.Length + forces.Drag.Length + forces.Magnus.Length + forces.Knuckle.Length + forces.Custom.Length + forces.Nets.Length
        + forces.Contacts.Sum(contact => contact.Load.Length + contact.Friction.Length);

    private static void AssertNear(in Vector3d expected, in Vector3d actual) =>
        Assert.True((expected - actual).Length <= 1e-12 * (1 + expected.Length), $"{actual} is not {expected}");

    private static double[,] Hills()
    {
        var heights = new double[5, 6];
        for (int i = 0; i < 5; i++)
        {
            for (int j = 0; j < 6; j++)
            {
                heights[i, j] = 0.6 * Math.Sin((2.1 * i) + (1.7 * j));
            }
        }

        return heights;
    }

    private static List<ulong> Match(bool watches, bool startsFromSnapshots)
    {
        var bodies = new KinematicBodies();
        KinematicBody keeper = bodies.Add("keeper", BodyKind.Player);
        KinematicBody leg = bodies.Add("leg", new SphereShape(Vector3d.Zero, 0.15), SurfaceMaterial.Boot, mass: 4);
        var simulator = new Simulator(Pitch.Cage.On(new Scene
        {
            Bodies = bodies,
            Obstacles = [new Obstacle { Name = "cone", Shape = new SphereShape(new Vector3d(1, 0.3, -6), 0.3), Mass = 2 }],
        }));
        BallState ball = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(2, 3, -16), new Vector3d(5, 30, 0));
        var log = new StepLog();
        var hashes = new List<ulong>();
        byte[] bytes = new byte[Snapshot.Size];
        for (int i = 0; i < 1200; i++)
        {
            double time = ball.Time;
            keeper.MoveTo(new Vector3d(2 * Math.Sin(time), 0, -19.5), new Vector3d(2 * Math.Cos(time), 0, 0), time);
            if (i % 40 == 0)
            {
                leg.MoveTo(ball.Position + new Vector3d(0.1, 0, 0.6), new Vector3d(0, 0.5, -8), time);
            }

            if (watches)
            {
                BallForces? forces = simulator.ForcesAt(in ball);
                Assert.True(forces is null || forces.Sum.IsFinite);
                Assert.Equal(time, ball.Time);
            }

            if (startsFromSnapshots)
            {
                Snapshot.Write(in ball, bytes);
                ball = Snapshot.Read(bytes);
            }

            if (i % 200 == 150)
            {
                simulator.Kick(ref ball, new Vector3d(3 - (i % 7), 4, 12 - (i % 25)), new Vector3d(1, i % 60, 0));
            }

            log.Clear();
            simulator.Step(ref ball, 1.0 / 60, log);
            hashes.Add(Snapshot.Hash(in ball));
        }

        return hashes;
    }

    /// <summary>Keeps the acceleration at the start of the first piece of a step.</summary>
    private sealed class FirstPiece : PieceObserver
    {
        private double _time;

        public Vector3d? Acceleration { get; private set; }

        public override bool WantsEndAcceleration => true;

        public void Begin(double time)
        {
            _time = time;
            Acceleration = null;
        }

        public override bool Add(in PathSegment piece)
        {
            if (Acceleration is null && piece.Time == _time)
            {
                Acceleration = piece.StartAcceleration;
            }

            return false;
        }
    }
}
