using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>Several balls: shots that collide, heaps, rows, balls of different sizes, in boxes, on slopes, in nets, among bodies, in wind.</summary>
internal static class Groups
{
    private const double Frame = 1.0 / 60;

    public static void Play()
    {
        var draw = new Draw(9);
        for (int i = 0; i < 60; i++)
        {
            Balls(draw, Scenes(draw), i % 20 == 0 ? 1 : 2 + draw.Below(9), 5);
        }

        Heap(draw, Scene.Default with { Obstacles = Box(0.35) }, 12);
        Heap(draw, Scene.Published with { Obstacles = Box(0.3) }, 6);
        Heap(draw, Scene.Default with { Ground = new Ground { Normal = new Vector3d(0.2, 1, 0).Normalized() }, Obstacles = Box(0.3) }, 6);
        for (int i = 0; i < 12; i++)
        {
            Row(draw, 2 + (i % 5));
        }

        for (int i = 0; i < 6; i++)
        {
            Pushed(draw);
        }
    }

    private static Scene Scenes(Draw draw) => draw.Below(9) switch
    {
        0 => Scene.Default,
        1 => Scene.Default with { Obstacles = Box(0.8) },
        2 => Pitch.Standard.On(),
        3 => Scene.Default with { Ground = new Ground { Normal = new Vector3d(0.3, 1, 0.1).Normalized() } },
        4 => Scene.Published with { Obstacles = Box(1) },
        5 => Scene.Windy(new Vector3d(5, 0, 2)) with { Obstacles = Box(0.6) },
        6 => Scene.Vacuum with { Gravity = 0, Ground = Ground.None },
        7 => Pitch.Cage.On(),
        _ => Scene.Default with { Ground = Slopes.Bowl() },
    };

    private static Obstacle[] Box(double half) =>
        [.. new[] { new Vector3d(1, 0, 0), new Vector3d(-1, 0, 0), new Vector3d(0, 0, 1), new Vector3d(0, 0, -1) }.Select(inward => new Obstacle { Name = "side", Shape = new PlaneShape(-half * inward, inward), Surface = SurfaceMaterial.Board })];

    private static void Balls(Draw draw, Scene scene, int count, double seconds)
    {
        BallGroup group = draw.Chance(0.4)
            ? new BallGroup(scene, [.. Enumerable.Range(0, count).Select(_ => draw.Any(BallProperties.Modern, BallProperties.Futsal, BallProperties.MedicineBall, BallProperties.BeachBall))], contact: draw.Chance(0.3) ? SurfaceMaterial.Ball with { NormalRestitution = 0.3 } : null)
            : new BallGroup(new Simulator(scene, draw.Chance(0.3) ? new SolverSettings { Integrator = draw.Any(Enum.GetValues<Integrator>()) } : null), count);
        var states = new BallState[count];
        for (int i = 0; i < count; i++)
        {
            Vector3d at = new(draw.Between(-0.5, 0.5), 0.2 + (0.3 * i), draw.Between(-0.5, 0.5));
            states[i] = group.SimulatorOf(i).Launch(at, draw.Between(0, 8) * -at.Normalized(), draw.Vector(draw.Any(0, 30)));
        }

        var log = new StepLog();
        group.Run(states, Frame, seconds, StopAt.Rest, log, draw.Chance(0.2) ? () => { } : null);
        foreach (ref readonly BallEvent happened in log.Events)
        {
            _ = happened.OtherBall;
        }

        int kicked = draw.Below(count);
        group.SimulatorOf(kicked).Kick(ref states[kicked], draw.Between(1, 20) * draw.Heading(), draw.Vector(20));
        group.Run(states, Frame, seconds, StopAt.Rest, log);
    }

    private static void Heap(Draw draw, Scene scene, int count)
    {
        var group = new BallGroup(new Simulator(scene), count);
        BallState[] states = [.. Enumerable.Range(0, count).Select(i => group.SimulatorOf(i).Launch(new Vector3d(draw.Between(-0.1, 0.1), 0.3 + (0.25 * i), draw.Between(-0.1, 0.1)), default, default))];
        group.Run(states, Frame, 10, StopAt.Rest, new StepLog());
    }

    // Balls that touch in a row along a slope, a board or level ground, and one that runs into them.
    private static void Row(Draw draw, int count)
    {
        Vector3d normal = draw.Any(Vector3d.Up, new Vector3d(0.2, 1, 0).Normalized());
        Obstacle[] stop = draw.Chance(0.6) ? [new Obstacle { Shape = new PlaneShape(new Vector3d(0.11, 0, 0), new Vector3d(-1, 0, 0)), Surface = SurfaceMaterial.Board }] : [];
        Scene scene = Scene.Default with { Ground = Ground.Of(draw.Any(SurfaceMaterial.DryTurf, SurfaceMaterial.Concrete)) with { Normal = normal }, Obstacles = stop };
        var group = new BallGroup(new Simulator(scene), count);
        Vector3d along = Vector3d.Cross(new Vector3d(0, 0, 1), normal).Normalized();
        var states = new BallState[count];
        for (int i = 0; i < count; i++)
        {
            bool runs = i == count - 1;
            states[i] = group.SimulatorOf(i).Launch((0.11 * normal) + ((0.22 + 1e-9) * i * along) + (runs ? 0.5 * along : default), runs ? -draw.Between(0.5, 6) * along : default, default);
        }

        group.Run(states, Frame, 6, StopAt.Rest, new StepLog());
    }

    // Balls that bodies push together.
    private static void Pushed(Draw draw)
    {
        var bodies = new KinematicBodies();
        KinematicBody[] boards = [.. Enumerable.Range(0, 2).Select(i => bodies.Add($"board {i}", new BoxShape(new Vector3d(0, 0.4, 0), new Vector3d(0.1, 0.4, 1)), SurfaceMaterial.Board))];
        var group = new BallGroup(new Simulator(Scene.Default with { Bodies = bodies }), 4);
        BallState[] states = [.. Enumerable.Range(0, 4).Select(i => group.SimulatorOf(i).Launch(new Vector3d((0.25 * i) - 0.4, 0.11, draw.Between(-0.1, 0.1)), default, default))];
        var log = new StepLog();
        for (int tick = 0; tick < 240; tick++)
        {
            double time = tick * Frame;
            for (int i = 0; i < 2; i++)
            {
                double side = (2 * i) - 1;
                boards[i].MoveTo(new Vector3d(side * (0.7 + (0.35 * Math.Cos(2 * time))), 0, 0), new Vector3d(-side * 0.7 * Math.Sin(2 * time), 0, 0), time);
            }

            group.Step(states, Frame, log);
        }
    }
}
