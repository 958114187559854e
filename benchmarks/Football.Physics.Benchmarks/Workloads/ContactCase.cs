using System.Diagnostics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Benchmarks;

/// <summary>A ball that several surfaces touch, and its steps of 10 ms.</summary>
internal sealed class ContactCase
{
    private const double Radius = 0.11;

    /// <summary>The number of steps per call: few, so that the motion still matches its name.</summary>
    private const int Steps = 24;

    /// <summary>The number of times that a step is timed from one state; the shortest time counts.</summary>
    private const int Repeats = 7;

    /// <summary>The number of steps per reading of the clock, which may be coarse.</summary>
    private const int Readings = 16;

    /// <summary>The longest time for a ball to come to rest, s.</summary>
    private const double Longest = 30;

    private readonly Simulator _simulator;
    private readonly BallState _start;
    private readonly KinematicBody? _body;
    private readonly RigidMotion _bodyStart;
    private readonly StepLog _log = new();

    private ContactCase(Scene scene, Integrator integrator, Vector3d position, Vector3d velocity, Vector3d spin, bool atRest)
        : this(scene, integrator, atRest, simulator => simulator.Launch(position, velocity, spin))
    {
    }

    private ContactCase(Scene scene, Integrator integrator, bool atRest, Func<Simulator, BallState> start)
    {
        _body = scene.Bodies is { Count: > 0 } bodies ? bodies[0] : null;
        _simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
        BallState state = start(_simulator);
        if (atRest)
        {
            _simulator.Run(ref state, ShotSets.TimeStep, Longest, StopAt.Rest, _log);
        }

        _start = state;
        _bodyStart = _body?.Motion ?? default;
        IsAtRest = state.Motion == MotionState.Rest;
    }

    /// <summary>The cases by name; each is made for a method, and moving or at rest.</summary>
    public static IReadOnlyList<(string Name, Func<Integrator, bool, ContactCase> Make)> All { get; } =
    [
        ("wind presses it along a board", (integrator, atRest) => Pressed(integrator, atRest, [Board(new Vector3d(-1, 0, 0))], new Vector3d(0, 0, -6))),
        ("wind presses it against a board", (integrator, atRest) => Pressed(integrator, atRest, [Board(new Vector3d(-1, 0, 0))], default)),
        ("wind presses it into a corner", (integrator, atRest) => Pressed(integrator, atRest, [Board(new Vector3d(-1, 0, 0)), Board(new Vector3d(0, 0, 1))], default)),
        ("in a tilted gutter", Gutter),
        ("wind presses it under a board that leans over", Wedge),
        ("between a player who stands and a board", (integrator, atRest) => WithPlayer(integrator, atRest, double.PositiveInfinity)),
        ("between a player of 75 kg who stands and a board", (integrator, atRest) => WithPlayer(integrator, atRest, 75)),
        ("kicked in the net of a goal", InNet),
    ];

    /// <summary>True if the ball is at rest when the steps begin.</summary>
    public bool IsAtRest { get; }

    /// <summary>The timed steps.</summary>
    public Workload Workload => new(Run, Steps);

    /// <summary>Returns the evaluations of the right-hand side per step: the mean, and the maximum.</summary>
    public (double Mean, long Most) Evaluations()
    {
        BallState state = Begin();
        long all = 0;
        long most = 0;
        for (int i = 0; i < Steps; i++)
        {
            _log.Clear();
            _simulator.Step(ref state, ShotSets.TimeStep, _log);
            all += _log.Evaluations;
            most = Math.Max(most, _log.Evaluations);
        }

        return ((double)all / Steps, most);
    }

    /// <summary>Returns the time of the longest step, ns: the shortest of several measurements from its state.</summary>
    public double Worst()
    {
        double worst = 0;
        BallState state = Begin();
        for (int i = 0; i < Steps; i++)
        {
            BallState before = state;
            RigidMotion motion = _body?.Motion ?? default;
            double least = double.PositiveInfinity;
            for (int k = 0; k < Repeats; k++)
            {
                long began = Stopwatch.GetTimestamp();
                for (int reading = 0; reading < Readings; reading++)
                {
                    state = before;
                    if (_body is not null)
                    {
                        _body.Motion = motion;
                    }

                    _log.Clear();
                    _simulator.Step(ref state, ShotSets.TimeStep, _log);
                }

                least = Math.Min(least, Stopwatch.GetElapsedTime(began).TotalNanoseconds / Readings);
            }

            worst = Math.Max(worst, least);
        }

        return worst;
    }

    private static Obstacle Board(in Vector3d normal) => new() { Name = "board", Shape = new PlaneShape(-Radius * normal, normal), Surface = SurfaceMaterial.Board };

    private static Scene InWind(Vector3d wind) => new() { Air = new Air { Wind = wind } };

    private static ContactCase Pressed(Integrator integrator, bool atRest, Obstacle[] boards, in Vector3d velocity)
    {
        // The wind holds the ball, and does not drive it along a board.
        Scene scene = InWind(new Vector3d(6, 0, boards.Length > 1 ? -5 : 0)) with { Obstacles = boards };
        Vector3d spin = velocity == default ? new Vector3d(0, 60, 0) : Vector3d.Cross(Vector3d.Up, velocity) / Radius;
        return new ContactCase(scene, integrator, new Vector3d(0, Radius, 0), velocity, spin, atRest);
    }

    /// <summary>Presses the ball into the wedge between the ground and a board that leans over it, along which it moves.</summary>
    private static ContactCase Wedge(Integrator integrator, bool atRest)
    {
        const double Lean = 50 * Math.PI / 180;
        Scene scene = InWind(new Vector3d(6, 0, 0)) with { Obstacles = [Board(new Vector3d(-Math.Sin(Lean), -Math.Cos(Lean), 0))] };
        return new ContactCase(scene, integrator, new Vector3d(-Radius / Math.Tan(Lean), Radius, 0), new Vector3d(0, 0, -6), new Vector3d(-6 / Radius, 0, 0), atRest);
    }

    private static ContactCase WithPlayer(Integrator integrator, bool atRest, double mass)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25), SurfaceMaterial.Boot, mass);
        Scene scene = InWind(new Vector3d(3, 0, 0)) with { Obstacles = [Board(new Vector3d(-1, 0, 0))], Bodies = bodies };

        // The upright side of the capsule is higher than the ball's centre, so its round end touches: at a distance of both radii.
        double lower = 0.25 - Radius;
        player.MoveTo(new Vector3d(-Math.Sqrt(((Radius + 0.25) * (Radius + 0.25)) - (lower * lower)), 0, 0), default, 0);
        return new ContactCase(scene, integrator, new Vector3d(0, Radius, 0), default, new Vector3d(0, 60, 0), atRest);
    }

    /// <summary>Kicks a shot back to the pitch when the net bulges most.</summary>
    private static ContactCase InNet(Integrator integrator, bool atRest)
    {
        var scene = new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) }] };
        return new ContactCase(scene, integrator, atRest, simulator =>
        {
            BallState state = simulator.Launch(new Vector3d(-1.5, Radius, -2.5), new Vector3d(0, 4, -32), default);
            var log = new StepLog();
            while (state.Time < 1 && state.Velocity.Z < -1)
            {
                simulator.Step(ref state, 0.1 * ShotSets.TimeStep, log);
            }

            simulator.Kick(ref state, new Vector3d(0, 1, 6), default);
            return state;
        });
    }

    private static ContactCase Gutter(Integrator integrator, bool atRest)
    {
        // A ball at rest needs a gutter so level that rolling friction holds it.
        double tilt = (atRest ? 1 : 8) * Math.PI / 180;
        const double Side = 35 * Math.PI / 180;
        var up = new Vector3d(0, Math.Cos(tilt), -Math.Sin(tilt));
        var along = new Vector3d(0, -Math.Sin(tilt), -Math.Cos(tilt));
        Vector3d left = (Math.Cos(Side) * up) + (Math.Sin(Side) * new Vector3d(1, 0, 0));
        Vector3d right = (Math.Cos(Side) * up) - (Math.Sin(Side) * new Vector3d(1, 0, 0));
        SurfaceMaterial turf = SurfaceMaterial.DryTurf;
        Scene scene = InWind(new Vector3d(1, 0, 0)) with
        {
            Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = -100 },
            Obstacles = [new Obstacle { Name = "left", Shape = new PlaneShape(default, left), Surface = turf }, new Obstacle { Name = "right", Shape = new PlaneShape(default, right), Surface = turf }],
        };
        double speed = atRest ? 0.3 : 3;
        return new ContactCase(
            scene, integrator, Radius / Math.Cos(Side) * up, speed * along, speed / (Radius * Math.Cos(Side)) * Vector3d.Cross(up, along), atRest);
    }

    private BallState Begin()
    {
        if (_body is not null)
        {
            _body.Motion = _bodyStart;
        }

        return _start;
    }

    private double Run()
    {
        BallState state = Begin();
        for (int i = 0; i < Steps; i++)
        {
            _log.Clear();
            _simulator.Step(ref state, ShotSets.TimeStep, _log);
        }

        return state.Position.X;
    }
}
