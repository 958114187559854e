using FootballPhysics.Netcode;
using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>Numbers from the ends of their ranges and beyond: scenes, states, steps, bytes.</summary>
internal static class Hostile
{
    public static void Play()
    {
        var draw = new Draw(16);
        for (int i = 0; i < 250; i++)
        {
            Attempt(() => Extreme(draw));
        }

        for (int i = 0; i < 400; i++)
        {
            Attempt(() => Invalid(draw));
        }

        for (int i = 0; i < 300; i++)
        {
            Attempt(() => Bytes(draw));
        }

        for (int i = 0; i < 40; i++)
        {
            Attempt(() => Breaking(draw));
        }
    }

    private static double Number(Draw draw, double low, double high) =>
        draw.Below(4) switch { 0 => low, 1 => high, 2 => low * Math.Pow(high / low, draw.Between(0, 1)), _ => draw.Between(low, high) };

    private static void Extreme(Draw draw)
    {
        SurfaceMaterial material = new()
        {
            NormalRestitution = Number(draw, 0.001, 1),
            RestitutionSpeedScale = draw.Any(0.01, 20, 1e9),
            GrazingRestitutionGain = Number(draw, 0.001, 1),
            TangentialRestitution = draw.Between(-1, 1),
            ImpactFriction = Number(draw, 1e-6, 100),
            SlidingFriction = Number(draw, 1e-6, 100),
            RollingResistance = Number(draw, 1e-6, 1),
            SpinDamping = Number(draw, 1e-9, 1),
            MinimumExitSpeed = draw.Any(0, 0, 3),
            TorsionalPatchRadius = Number(draw, 1e-6, 0.1),
        };
        var scene = new Scene
        {
            Ball = new BallProperties { Mass = Number(draw, 0.01, 100), Radius = Number(draw, 0.01, 5), InertiaFactor = Number(draw, 0.05, 2.0 / 3), Bounce = Number(draw, 0.1, 1) },
            Gravity = Number(draw, 1e-3, 100),
            Air = new Air { Density = draw.Any(0, 1.2, 100), Wind = draw.Any(default, draw.Vector(60)) },
            Ground = new Ground { Material = material, Normal = draw.Any(Vector3d.Up, (Vector3d.Up + draw.Vector(0.9)).Normalized()) },
            Obstacles = draw.Chance(0.5) ? [new Obstacle { Shape = new PlaneShape(new Vector3d(6, 0, 0), new Vector3d(-1, draw.Between(-0.5, 0.5), 0).Normalized()), Surface = material }, new Obstacle { Shape = new SphereShape(new Vector3d(-8, 0, 0), 2), Surface = material, Spin = draw.Vector(50), Mass = draw.Any(1e-3, double.PositiveInfinity) }] : [],
        };
        var simulator = new Simulator(scene, draw.Chance(0.3) ? new SolverSettings { Integrator = draw.Any(Enum.GetValues<Integrator>()) } : null);
        var log = new StepLog(4, 32);
        BallState ball = simulator.Launch(draw.Any(new Vector3d(0, 1, 0), new Vector3d(0, 9e5, 0), draw.Vector(3)), Number(draw, 1e-9, 500) * draw.Vector(1), Number(draw, 1e-9, 5000) * draw.Vector(1));
        double step = draw.Any(1e-6, 1e-3, 1.0 / 60, 0.5);
        for (int i = 0; i < 60; i++)
        {
            simulator.Step(ref ball, step, log);
        }
    }

    private static double Wrong(Draw draw) => draw.Any(double.NaN, -1, double.PositiveInfinity, 1e300, -1e300, 0, double.NegativeInfinity);

    private static void Invalid(Draw draw)
    {
        double wrong = Wrong(draw);
        var vector = new Vector3d(wrong, 1, 0);
        switch (draw.Below(12))
        {
            case 0:
                _ = new Simulator(new Scene { Ball = new BallProperties { Mass = wrong } });
                break;
            case 1:
                _ = new Simulator(new Scene { Gravity = wrong, Air = new Air { Density = wrong } });
                break;
            case 2:
                _ = new Simulator(new Scene { Ground = new Ground { Normal = vector } });
                break;
            case 3:
                _ = new Simulator().Launch(vector, default, default);
                break;
            case 4:
                _ = new Simulator().Launch(default, vector, vector, new Quaterniond(wrong, 0, 0, 0));
                break;
            case 5:
                new Ball().Step(wrong);
                break;
            case 6:
                new Ball().Kick(wrong, vector, wrong, wrong);
                break;
            case 7:
                _ = new Simulator(new Scene { Obstacles = [new Obstacle { Shape = new SphereShape(vector, wrong) }] });
                break;
            case 8:
                _ = new Simulator(new Scene { Goals = [new Goal { Center = vector, Facing = vector }], Nets = [new Net { Center = vector, Normal = vector, Along = vector, HalfLength = 1, HalfWidth = wrong }] });
                break;
            case 9:
                _ = new Aiming.Aimer().Find(new Aiming.AimRequest { Target = vector, Speed = wrong });
                break;
            case 10:
                _ = new FixedStepRunner(wrong);
                break;
            default:
                _ = new Simulator(new Scene { Ground = Ground.Of(new SurfaceMaterial { SlidingFriction = wrong, RollingResistance = wrong }) });
                break;
        }
    }

    // A force of the game that throws, or returns no number, in a step, in a group and in a look-ahead; and bodies that do not exist.
    private static void Breaking(Draw draw)
    {
        double limit = draw.Between(0.1, 1);
        bool isNumber = draw.Chance(0.5);
        Laws.IForce breaks = Laws.IForce.From(ball => ball.Position.X < limit ? default : isNumber ? throw new InvalidOperationException() : new Vector3d(double.NaN, 0, 0));
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("board", new BoxShape(new Vector3d(0, 0.5, 2), new Vector3d(1, 0.5, 0.1)));
        var scene = new Scene { Forces = ForceSet.Measured with { CustomForces = [breaks] }, Bodies = bodies };
        var simulator = new Simulator(scene);
        BallState ball = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(5, 1, draw.Between(-5, 5)), default);
        Attempt(() => simulator.LookAhead(in ball, new Prediction.LookAheadRequest { Duration = 3 }, new Prediction.Trajectory()));
        Attempt(() => new Prediction.LookAheadRun(simulator).Start(in ball, new Prediction.LookAheadRequest { Duration = 3 }));
        var group = new BallGroup(simulator, 1 + draw.Below(3));
        Attempt(() => group.Run([.. Enumerable.Range(0, group.Count).Select(i => simulator.Launch(new Vector3d(0, 1 + (0.3 * i), 0), new Vector3d(5, 0, 0), default))], 0.01, 2, StopAt.Time, new StepLog()));
        Attempt(() => _ = bodies[3]);
        Attempt(() =>
        {
            body.MoveTo(default, default, 0);
            simulator.Run(ref ball, 0.01, 2, StopAt.Time, new StepLog());
        });
        Attempt(() => body.MoveTo(default, default, -1));
        Attempt(() => simulator.Step(ref ball, 0.01, new StepLog()));
        Attempt(() => _ = body.Position + body.Spin + new Vector3d(bodies.Count(at => at.Mass > 1), 0, 0));
        Attempt(() => _ = new Simulator(new Scene(), new SolverSettings { Integrator = (Integrator)9 }));
        Attempt(() => simulator.Validate(default));
    }

    private static void Bytes(Draw draw)
    {
        var runner = new FixedStepRunner(new Simulator(), 0.01);
        Recording recording = runner.Record();
        runner.QueueKick(new Vector3d(3, 3, 3), default);
        for (int i = 0; i < 5; i++)
        {
            runner.Step();
        }

        byte[] bytes = draw.Below(3) switch { 0 => recording.ToBytes(), 1 => recording.Kicks.ToBytes(), _ => new byte[Snapshot.Size] };
        if (bytes.Length == Snapshot.Size)
        {
            Snapshot.Write(runner.State, bytes);
        }

        for (int i = 0; i < 1 + draw.Below(4); i++)
        {
            bytes[draw.Below(bytes.Length)] = (byte)draw.Below(256);
        }

        bytes = draw.Chance(0.3) ? bytes[..draw.Below(bytes.Length)] : bytes;
        _ = bytes.Length == Snapshot.Size ? Snapshot.Read(bytes).Time : draw.Chance(0.5) ? Recording.FromBytes(bytes).EndTick : KickLog.FromBytes(bytes).Count;
    }

    private static void Attempt(Action action)
    {
        try
        {
            action();
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException or FormatException or InvalidDataException)
        {
        }
    }
}
