using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>Shots at goals, into nets of all kinds, past posts, and through zones.</summary>
internal static class NetsAndGoals
{
    public static void Play()
    {
        var draw = new Draw(12);
        Zone[] zones =
        [
            new Zone { Name = "box", Shape = new BoxShape(new Vector3d(0, 1, -48), new Vector3d(8, 1, 5)) },
            new Zone { Name = "beam", Shape = new CapsuleShape(new Vector3d(-5, 0.5, -45), new Vector3d(5, 0.5, -45), 0.05), Of = ZonePart.Center },
            new Zone { Name = "line", Shape = new PlaneShape(default, new Vector3d(0, 0, 1)), Of = ZonePart.Center },
            new Zone { Name = "half", Shape = new PlaneShape(default, new Vector3d(0, 0, 1)), Of = ZonePart.Center },
            new Zone { Name = "ring", Shape = new SphereShape(new Vector3d(2, 1, -50), 0.5), Layer = 2 },
        ];
        Scene[] scenes =
        [
            Pitch.Standard.On(), Pitch.Futsal.On(), Pitch.Standard.On() with { Zones = zones }, Pitch.Standard.On(Scene.Published),
            Pitch.Standard.On(Scene.Windy(new Vector3d(6, 0, 0))),
            Scene.Default with { Goals = [new Goal { Center = new Vector3d(0, 0, -50), Facing = new Vector3d(0.3, 0, 1).Normalized(), HasNet = false }] },
            Pitch.Standard.On() with { Nets = [new Net { Center = new Vector3d(0, 1, -46), Normal = new Vector3d(0, 0.4, 1).Normalized(), Along = new Vector3d(1, 0, 0), HalfLength = 3, HalfWidth = 1, Stiffness = 60 }, new Net { Center = new Vector3d(0, 0.8, -42), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), HalfLength = 2, HalfWidth = 2, Damping = 1 }] },
        ];
        foreach (Scene scene in scenes)
        {
            foreach (Integrator integrator in new[] { Integrator.Rk4, Integrator.Rk2 })
            {
                Shots(draw, new Simulator(scene, new SolverSettings { Integrator = integrator }), 45);
            }
        }

        Stopping(draw);
    }

    private static void Shots(Draw draw, Simulator simulator, int count)
    {
        double line = simulator.Scene.Goals.Count > 0 ? simulator.Scene.Goals.Min(goal => goal.Center.Z) : -50;
        var log = new StepLog();
        for (int i = 0; i < count; i++)
        {
            Vector3d from = new(draw.Between(-4, 4), draw.Any(0.11, 0.11, 1, 2.5), line + draw.Between(-2.5, 9));
            Vector3d at = new(draw.Between(-4, 4), draw.Between(0, 2.6), line + draw.Between(-2, 0));
            Vector3d way = (at - from).Length > 0.01 ? (at - from).Normalized() : Vector3d.Up;
            BallState ball = simulator.Launch(from, draw.Between(1, 30) * way, draw.Vector(draw.Any(0, 60)));
            simulator.Run(ref ball, 1.0 / 60, 8, StopAt.Rest, log);
            _ = simulator.Scene.Zones.Count(zone => zone.Holds(ball.Position, 0.11));
            simulator.Kick(ref ball, draw.Between(0.2, 10) * draw.Heading(), default);
            simulator.Run(ref ball, 1.0 / 60, 8, StopAt.Rest, log);
            log.Clear();
        }
    }

    // Dead balls on sheets that lie flat, hang, or cross a board.
    private static void Stopping(Draw draw)
    {
        for (int i = 0; i < 40; i++)
        {
            Net[] nets = [.. Enumerable.Range(0, 1 + draw.Below(3)).Select(_ => new Net
            {
                Center = new Vector3d(draw.Between(-0.5, 0.5), draw.Between(0.3, 1), draw.Between(-0.5, 0.5)),
                Normal = (Vector3d.Up + draw.Vector(1)).Normalized(),
                Along = Vector3d.Cross((Vector3d.Up + draw.Vector(0.1)).Normalized(), draw.Heading()).Normalized(),
                HalfLength = 1.5,
                HalfWidth = 1.5,
                Stiffness = draw.Any(10, 100, 1000),
                Damping = draw.Any(0.5, 3),
            })];
            Scene scene;
            Simulator simulator;
            try
            {
                scene = Scene.Default with { Nets = nets, Obstacles = [new Obstacle { Shape = new PlaneShape(new Vector3d(0.8, 0, 0), new Vector3d(-1, 0, 0)) }] };
                simulator = new Simulator(scene);
            }
            catch (ArgumentOutOfRangeException)
            {
                continue;
            }

            var log = new StepLog();
            BallState ball = simulator.Launch(new Vector3d(0, 2, 0), draw.Vector(4), draw.Vector(10));
            simulator.Run(ref ball, 1.0 / 60, 10, StopAt.Rest, log);
        }
    }
}
