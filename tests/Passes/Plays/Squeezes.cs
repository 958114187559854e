using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>A ball in corners, gutters and wedges, between surfaces that press it, and on surfaces that carry and turn it.</summary>
internal static class Squeezes
{
    private const double Frame = 1.0 / 60;

    public static void Play()
    {
        var draw = new Draw(8);
        for (int i = 0; i < 220; i++)
        {
            Held(draw);
        }

        for (int i = 0; i < 160; i++)
        {
            Pressed(draw);
        }

        for (int i = 0; i < 120; i++)
        {
            Carried(draw);
        }
    }

    // Planes, boxes, posts that stand still: two to six of them around the ball.
    private static void Held(Draw draw)
    {
        int count = 1 + draw.Below(5);
        Obstacle[] around = [.. Enumerable.Range(0, count).Select(i => Wall(draw, i))];
        Scene scene = draw.Any(Scene.Default, Scene.Default, Scene.Published, Scene.Windy(new Vector3d(3, 0, 1)), Scene.Default with { Ground = Ground.Of(SurfaceMaterial.Indoor) }) with { Obstacles = around };
        if (draw.Chance(0.2))
        {
            scene = scene with { Ground = scene.Ground with { Normal = new Vector3d(draw.Between(-0.4, 0.4), 1, draw.Between(-0.4, 0.4)).Normalized() } };
        }

        var simulator = new Simulator(scene, draw.Chance(0.2) ? new SolverSettings { Integrator = draw.Any(Enum.GetValues<Integrator>()) } : null);
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, draw.Any(0.11, 0.5, 2), 0), draw.Between(0, 6) * draw.Vector(1), draw.Vector(draw.Any(0, 5, 60)));
        simulator.Run(ref ball, Frame, 12, StopAt.Rest, log);
        simulator.Kick(ref ball, draw.Between(0, 12) * draw.Heading(), draw.Vector(draw.Any(0, 30)));
        simulator.Run(ref ball, Frame, 12, StopAt.Rest, log);
    }

    private static Obstacle Wall(Draw draw, int number)
    {
        Vector3d outward = draw.Heading();
        SurfaceMaterial surface = draw.Any(SurfaceMaterial.Board, SurfaceMaterial.GoalFrame, SurfaceMaterial.Wood, SurfaceMaterial.Boot, SurfaceMaterial.Glove, SurfaceMaterial.Board with { SlidingFriction = 0, ImpactFriction = 0 });
        Vector3d at = -draw.Between(0.11, 0.5) * outward;
        IShape shape = draw.Below(5) switch
        {
            0 => new BoxShape(at - (0.5 * outward), new Vector3d(3, 2, 0.5), Quaterniond.FromAxisAngle(Vector3d.Up, Math.Atan2(outward.X, outward.Z))),
            1 => new CapsuleShape(at - (0.2 * outward), at - (0.2 * outward) + new Vector3d(0, 2, 0), 0.2),
            2 => new SphereShape(at - (0.3 * outward), 0.3),
            3 => new PlaneShape(at, (outward + new Vector3d(0, draw.Between(-0.5, 0.9), 0)).Normalized()),
            _ => new PlaneShape(at, outward),
        };
        return new Obstacle { Name = $"wall {number}", Shape = shape, Surface = surface, Velocity = draw.Chance(0.1) ? draw.Vector(0.2) : default, Spin = draw.Chance(0.1) ? draw.Vector(2) : default };
    }

    // Bodies that close in from two or three sides, from above, or that hold the ball to a wall.
    private static void Pressed(Draw draw)
    {
        var bodies = new KinematicBodies();
        int count = 1 + draw.Below(3);
        KinematicBody[] all = [.. Enumerable.Range(0, count).Select(i => bodies.Add($"body {i}", Shape(draw), draw.Any(SurfaceMaterial.Boot, SurfaceMaterial.Board, SurfaceMaterial.Head)))];
        Vector3d[] from = [.. all.Select((_, i) => i == 2 ? new Vector3d(0, 1.5, 0) : draw.Between(0.5, 1) * draw.Heading())];
        Vector3d[] speeds = [.. from.Select(place => -draw.Between(0.2, draw.Any(0.6, 4)) * place.Normalized())];
        var turn = new Vector3d(0, draw.Chance(0.3) ? draw.Between(-5, 5) : 0, 0);
        Scene scene = Scene.Default with { Bodies = bodies };
        if (draw.Chance(0.6))
        {
            scene = scene with { Obstacles = [.. Enumerable.Range(0, 1 + draw.Below(2)).Select(i => Wall(draw, i))] };
        }

        var ball = new Ball(new Simulator(scene));
        ball.Place(new Vector3d(0, draw.Any(0.11, 0.11, 0.4), 0));
        double stop = draw.Between(0.3, 1);
        double leave = stop + draw.Between(0.2, 1.5);
        while (ball.Time < 4)
        {
            double moved = Math.Min(ball.Time, stop) - Math.Max(0, ball.Time - leave);
            for (int i = 0; i < count; i++)
            {
                Vector3d velocity = ball.Time < stop ? speeds[i] : ball.Time > leave ? -speeds[i] : default;
                all[i].MoveTo(from[i] + (moved * speeds[i]), Quaterniond.FromAxisAngle(Vector3d.Up, turn.Y * ball.Time), velocity, turn, ball.Time);
            }

            ball.Step(Frame);
        }
    }

    private static IShape Shape(Draw draw) => draw.Below(4) switch
    {
        0 => new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.5, 0), 0.25),
        1 => new BoxShape(new Vector3d(0, 0.2, 0), new Vector3d(0.3, 0.2, 0.3)),
        2 => new SphereShape(new Vector3d(0, 0.15, 0), 0.15),
        _ => new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(0.05, 0.5, 1)),
    };

    // Turntables, belts, tilted discs, drums, lifts; a carrier that is taken away.
    private static void Carried(Draw draw)
    {
        var bodies = new KinematicBodies();
        IShape shape = draw.Below(3) switch
        {
            0 => new BoxShape(new Vector3d(0, -0.5, 0), new Vector3d(4, 0.5, 4)),
            1 => new CapsuleShape(new Vector3d(-4, -1, 0), new Vector3d(4, -1, 0), 1),
            _ => new SphereShape(new Vector3d(0, -2, 0), 2),
        };
        SurfaceMaterial surface = draw.Any(SurfaceMaterial.Board, SurfaceMaterial.Wood, SurfaceMaterial.DryTurf, SurfaceMaterial.Ball);
        KinematicBody carrier = bodies.Add("carrier", shape, surface);
        KinematicBody? fence = draw.Chance(0.4) ? bodies.Add("fence", new BoxShape(new Vector3d(0.6, 0.3, 0), new Vector3d(0.1, 0.3, 2)), surface) : null;
        var spin = new Vector3d(draw.Chance(0.2) ? draw.Between(-0.3, 0.3) : 0, draw.Any(0, 1, 4), draw.Chance(0.2) ? draw.Between(-0.3, 0.3) : 0);
        Vector3d velocity = draw.Any(default, new Vector3d(1, 0, 0), new Vector3d(0, 0.5, 0), new Vector3d(0, -0.5, 0.5));
        Scene scene = draw.Any(Scene.Default, Scene.Published, Scene.Vacuum) with { Bodies = bodies, Ground = draw.Any(Ground.None, new Ground { Height = -3 }) };
        var ball = new Ball(new Simulator(scene));
        Vector3d place = default;
        Quaterniond pose = Quaterniond.Identity;
        carrier.MoveTo(place, pose, velocity, spin, 0);
        fence?.MoveTo(place, pose, velocity, spin, 0);
        ball.Launch(new Vector3d(draw.Between(-0.4, 0.4), 0.11 + draw.Any(0, 0, 0.2), draw.Between(-0.4, 0.4)), velocity + (draw.Any(0, 0.5, 2) * draw.Heading()), draw.Vector(draw.Any(0, 10)));
        while (ball.Time < 4)
        {
            if (draw.Chance(0.02))
            {
                velocity += new Vector3d(draw.Between(-0.5, 0.5), 0, draw.Between(-0.5, 0.5));
            }

            carrier.MoveTo(place, pose, velocity, spin, ball.Time);
            fence?.MoveTo(place, pose, velocity, spin, ball.Time);
            if (ball.Time > 3 && !carrier.IsWithdrawn)
            {
                carrier.Withdraw();
            }

            ball.Step(Frame);
            place += Frame * velocity;
            pose = (Quaterniond.FromRotationVector(Frame * spin) * pose).Normalized();
        }
    }
}
