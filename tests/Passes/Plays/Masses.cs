using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>Obstacles and bodies with a mass: dummies, cones, doors, hanging targets, players, hit by one ball and by several.</summary>
internal static class Masses
{
    private const double Frame = 1.0 / 60;

    public static void Play()
    {
        var draw = new Draw(10);
        for (int i = 0; i < 60; i++)
        {
            OneBall.Kicks(draw, new Simulator(Scene.Default with { Obstacles = Things(draw) }), 2, Frame);
        }

        for (int i = 0; i < 40; i++)
        {
            Group(draw);
        }

        for (int i = 0; i < 20; i++)
        {
            Players(draw);
        }
    }

    private static Obstacle[] Things(Draw draw) =>
    [
        .. Enumerable.Range(0, 1 + draw.Below(4)).Select(i =>
        {
            Vector3d at = draw.Between(0.3, 2) * draw.Heading();
            IShape shape = draw.Below(3) switch
            {
                0 => new BoxShape(at + new Vector3d(0, 0.9, 0), new Vector3d(0.4, 0.9, 0.2)),
                1 => new CapsuleShape(at, at + new Vector3d(0, 1.5, 0), 0.1),
                _ => new SphereShape(at + new Vector3d(0, 0.3, 0), 0.3),
            };
            return new Obstacle { Name = $"dummy {i}", Shape = shape, Mass = draw.Any(0.3, 2, 40), Pivot = at, Surface = draw.Any(SurfaceMaterial.Board, SurfaceMaterial.Head), Velocity = draw.Chance(0.3) ? draw.Vector(1) : default, Spin = draw.Chance(0.3) ? draw.Vector(2) : default };
        }),
        .. draw.Chance(0.5) ? [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -1.5), new Vector3d(0, 0, 1)), Surface = SurfaceMaterial.Board }] : Array.Empty<Obstacle>(),
    ];

    private static void Group(Draw draw)
    {
        int count = 2 + draw.Below(4);
        var group = new BallGroup(new Simulator(Scene.Default with { Obstacles = Things(draw) }), count);
        BallState[] states = [.. Enumerable.Range(0, count).Select(i =>
        {
            Vector3d at = (draw.Between(1, 4) * draw.Heading()) + new Vector3d(0, 0.11 + (0.3 * i), 0);
            return group.SimulatorOf(i).Launch(at, -draw.Between(3, 15) * new Vector3d(at.X, 0, at.Z).Normalized(), draw.Vector(20));
        })];
        var log = new StepLog();
        group.Run(states, Frame, 4, StopAt.Rest, log);
        group.SimulatorOf(0).ResetObstacles();
    }

    // The game moves bodies with a mass; events report the impulses.
    private static void Players(Draw draw)
    {
        var bodies = new KinematicBodies();
        KinematicBody[] players = [.. Enumerable.Range(0, 4).Select(i => bodies.Add($"player {i}", new CapsuleShape(new Vector3d(0, 0.2, 0), new Vector3d(0, 1.6, 0), 0.2), SurfaceMaterial.Boot, draw.Any(3, 75)))];
        var group = new BallGroup(new Simulator(Scene.Default with { Bodies = bodies }), 3);
        BallState[] states = [.. Enumerable.Range(0, 3).Select(i => group.SimulatorOf(i).Launch(new Vector3d(0.3 * i, 0.11 + (0.3 * i), 0), draw.Vector(5), draw.Vector(20)))];
        Vector3d[] headings = [.. players.Select(_ => draw.Heading())];
        var log = new StepLog();
        for (int tick = 0; tick < 180; tick++)
        {
            double time = tick * Frame;
            for (int i = 0; i < players.Length; i++)
            {
                players[i].MoveTo((1.5 * Math.Cos(time * 2)) * headings[i], -3 * Math.Sin(time * 2) * headings[i], time);
            }

            group.Step(states, Frame, log);
        }
    }
}
