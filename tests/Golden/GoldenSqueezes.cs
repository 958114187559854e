using FootballPhysics.Shapes;
using static FootballPhysics.Golden.GoldenObjects;

// Bodies, obstacles and engine colliders that move and press a ball: against turf, boards, posts, nets and each other.

namespace FootballPhysics.Golden;

internal static class GoldenSqueezes
{
    private static readonly Vector3d s_far = new Vector3d(0, 50, 0);

    public static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return ByPlayers().Concat(ByOthers());
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> ByPlayers()
    {
        yield return ("player-to-board", scene => Walk(scene.With(BoardAlongX(-0.9)), double.PositiveInfinity, new Vector3d(0.04, 0, 0.5), new Vector3d(0, 0, -1.5), 0.8).Ball(new Vector3d(0, Radius, -0.7)));
        yield return ("player-of-75-to-board", scene => Walk(scene.With(BoardAlongX(-0.9)), 75, new Vector3d(0.04, 0, 0.5), new Vector3d(0, 0, -1.5), 0.8).Ball(new Vector3d(0, Radius, -0.7)));
        yield return ("player-of-2-to-board", scene => Walk(scene.With(BoardAlongX(-0.9)), 2, new Vector3d(-0.1, 0, 0.5), new Vector3d(0, 0, -2.5), 0.6).Ball(new Vector3d(0, Radius, -0.7)));
        yield return ("player-to-corner", scene => Walk(scene.With(BoardAlongX(-0.5), BoardAlongZ(-0.5)), double.PositiveInfinity, new Vector3d(0.6, 0, 0.5), new Vector3d(-1.4, 0, -1.2), 0.9).Roll(-0.2, -0.15, 0, 0));
        yield return ("player-of-75-to-corner", scene => Walk(scene.With(BoardAlongX(-0.5), BoardAlongZ(-0.5)), 75, new Vector3d(0.6, 0, 0.5), new Vector3d(-2.4, 0, -2.2), 0.4).Roll(-0.2, -0.15, 0, 0));
        yield return ("player-to-post", scene => Walk(Pitch.Standard.On(scene), 75, new Vector3d(3.74, 0, -51), new Vector3d(0, 0, -2), 0.6).Roll(3.71, -51.7, 0, 0));
        yield return ("player-to-net", scene => Walk(Pitch.Standard.On(scene), double.PositiveInfinity, new Vector3d(1, 0, -52.5), new Vector3d(0, 0, -2.5), 0.8).Roll(1.05, -53.2, 0, -0.5));
        yield return ("player-drives-ball", scene => Walk(scene, double.PositiveInfinity, new Vector3d(-0.8, 0, 0), new Vector3d(3, 0, 0), 2).Roll(0, 0.03, 0, 0));
        yield return ("player-of-75-drives-ball", scene => Walk(scene, 75, new Vector3d(-0.8, 0, 0), new Vector3d(4, 0, 0.2), 2).Roll(0, 0, -3, 0));
        yield return ("player-along-board", scene => Walk(scene.With(BoardAlongX(-Radius)), double.PositiveInfinity, new Vector3d(-0.8, 0, 0.05), new Vector3d(2, 0, 0), 2).Roll(0, 0, 0.5, 0));
        yield return ("player-stands-on-ball-in-wind", scene => Walk(
            scene.InWind(-0.54, 0, 1.53).With(Thing("left", Box(-0.1, 0, -1, 0, 2, 1)), Thing("back", Box(-1, 0, -0.1, 1, 2, 0))), 75, new Vector3d(0.2567, 0, 0.1411), default, 1)
            .Ball(new Vector3d(Radius, Radius, Radius)));
        yield return ("two-pinch", scene => Pinch(scene, new Vector3d(-0.9, 0, 0.03), new Vector3d(1.5, 0, 0), new Vector3d(0.9, 0, -0.02), new Vector3d(-1.5, 0, 0), 0.45).Ball(new Vector3d(0, Radius, 0)));
        yield return ("two-pinch-in-air", scene => Pinch(scene, new Vector3d(-1.1, 0, 0), new Vector3d(5, 0, 0), new Vector3d(0.9, 0, 0.05), new Vector3d(-4, 0, 0), 0.12).Ball(new Vector3d(0, 0.9, 0), new Vector3d(0, 1, 0)));
        yield return ("two-pinch-and-part", scene => Pinch(scene, new Vector3d(-0.8, 0, 0), new Vector3d(2, 0, 0), new Vector3d(0.9, 0, 0.1), new Vector3d(-2.7, 0, 0), 0.22, 1.5).Ball(new Vector3d(0, Radius, 0)));
        yield return ("two-carry", scene => Pinch(scene, new Vector3d(-0.36, 0, 0), new Vector3d(0, 0, 1.2), new Vector3d(0.36, 0, 0), new Vector3d(0, 0, 1.2), 2).Ball(new Vector3d(0, 0.5, 0.02)));
        yield return ("crowd", Crowd);
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> ByOthers()
    {
        yield return ("lid", scene => Press(scene, Box(-0.5, 0, -0.5, 0.5, 0.3, 0.5), new Vector3d(0, 0.5, 0), new Vector3d(0, -0.6, 0), 0.6).Roll(0, 0, 0.1, 0));
        yield return ("lid-that-slides", scene => Press(scene, Box(-2, 0, -2, 2, 0.3, 2), new Vector3d(0, 0.24, 0), new Vector3d(0.6, -0.1, 0.2), 1).Roll(0, 0, 1, 0));
        yield return ("sphere-from-above", scene => Press(scene, new SphereShape(default, 0.3), new Vector3d(0.02, 0.8, 0.01), new Vector3d(0, -1, 0), 0.5).Roll(0, 0, 0, 0));
        yield return ("shut-in", scene => Press(
            scene.With(BoardAlongX(-Radius), Thing("far board", Box(-50, 0, Radius, 50, 1, 0.3)), BoardAlongZ(-Radius)), Box(0, 0, -0.1, 0.1, 1, 0.1), new Vector3d(0.4, 0, 0), new Vector3d(-0.5, 0, 0), 0.65)
            .Ball(new Vector3d(0, Radius, 0)));
        yield return ("wall-closes", scene => new GoldenPlay(
            scene.With(BoardAlongZ(-0.5), Thing("wall", Box(0.3, 0, -2, 0.5, 1, 2), SurfaceMaterial.Wood, new Vector3d(-0.7, 0, 0))), 1.2).Roll(0, 0, 0.3, 0.2));
        yield return ("wall-of-5-closes", scene => new GoldenPlay(
            scene.With(BoardAlongZ(-0.5), Thing("wall", Box(0.3, 0, -2, 0.5, 1, 2), SurfaceMaterial.Wood, new Vector3d(-1.7, 0, 0.2), default, 5)), 1.2).Roll(0, 0, 0.3, 0.2));
        yield return ("two-walls-close", scene => new GoldenPlay(
            scene.With(Thing("left", Box(-0.8, 0, -2, -0.6, 1, 2), SurfaceMaterial.Wood, new Vector3d(1, 0, 0)), Thing("right", Box(0.6, 0, -2, 0.8, 1, 2), SurfaceMaterial.Board, new Vector3d(-1.2, 0, 0))), 1)
            .Ball(new Vector3d(0, 0.4, 0), new Vector3d(0, 0, 0.5)));
        yield return ("wedge-closes", scene => new GoldenPlay(
            scene.With(Thing("left", Plane(-0.4, 0, 0, 1, -0.3, 0), SurfaceMaterial.Wood, new Vector3d(0.6, 0, 0)), Thing("right", Plane(0.4, 0, 0, -1, -0.2, 0))), 0.8).Roll(0, 0, 0, 0.5));
        yield return ("bats", scene => new GoldenPlay(
            scene.With(
                Thing("bat", Box(-0.9, 4, -1, -0.7, 6, 1), SurfaceMaterial.Boot, new Vector3d(5, 0, 0)), Thing("other bat", Box(0.7, 4, -1, 0.9, 6, 1), SurfaceMaterial.Boot, new Vector3d(-3, 0, 0))), 0.4)
            .Ball(new Vector3d(0.1, 5, 0), new Vector3d(2, 1, 0), new Vector3d(10, 20, 30)));
        yield return ("leg-swings-down", LegSwingsDown);
        yield return ("boots", Boots);
        yield return ("engine-to-board", EngineToBoard);
        yield return ("engine-pinch", EnginePinch);
        yield return ("post-into-board", scene => new GoldenPlay(
            scene.With(BoardAlongZ(-0.5), Thing("roller", new CapsuleShape(new Vector3d(0.3, 0.08, -1), new Vector3d(0.3, 0.08, 1), 0.08), SurfaceMaterial.Wood, new Vector3d(-0.6, 0, 0), new Vector3d(0, 0, 6))
                with
            { Pivot = new Vector3d(0.3, 0.08, 0) }), 0.9).Roll(-0.1, 0, 0, 0.2));
        yield return ("net-pressed", NetPressed);
        yield return ("withdrawn", Withdrawn);
    }

    /// <summary>A player who walks for some time and then stays.</summary>
    internal static GoldenPlay Walk(Scene scene, double mass, Vector3d from, Vector3d velocity, double until, double duration = 1.5)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", PlayerShape, SurfaceMaterial.Boot, mass);
        return new GoldenPlay(scene with { Bodies = bodies }, duration)
        {
            Move = time => player.MoveTo(from + (Math.Min(time, until) * velocity), time < until ? velocity : default, time),
        };
    }

    private static GoldenPlay Pinch(Scene scene, Vector3d from, Vector3d velocity, Vector3d otherFrom, Vector3d otherVelocity, double until, double duration = 1.2)
    {
        var bodies = new KinematicBodies();
        KinematicBody one = bodies.Add("one", PlayerShape, SurfaceMaterial.Boot);
        KinematicBody other = bodies.Add("other", PlayerShape, SurfaceMaterial.Boot, 75);
        return new GoldenPlay(scene with { Bodies = bodies }, duration)
        {
            // After the pinch, the first goes back at twice the speed, and the second stays.
            Move = time =>
            {
                double after = Math.Max(0, time - until - 0.3);
                one.MoveTo(from + ((Math.Min(time, until) - (2 * after)) * velocity), time < until ? velocity : after > 0 ? -2 * velocity : default, time);
                other.MoveTo(otherFrom + (Math.Min(time, until) * otherVelocity), time < until ? otherVelocity : default, time);
            },
        };
    }

    /// <summary>A body that moves for some time, stays for 0.2 s, and goes back.</summary>
    private static GoldenPlay Press(Scene scene, IShape shape, Vector3d from, Vector3d velocity, double until)
    {
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("press", shape, SurfaceMaterial.Wood);
        return new GoldenPlay(scene with { Bodies = bodies }, 1.3)
        {
            Move = time =>
            {
                double back = Math.Max(0, time - until - 0.2);
                body.MoveTo(from + ((Math.Min(time, until) - back) * velocity), time < until ? velocity : back > 0 ? -velocity : default, time);
            },
        };
    }

    private static GoldenPlay Crowd(Scene scene)
    {
        // Six legs walk to the middle and stay there.
        var from = new[]
        {
            new Vector3d(1, 0, 0), new Vector3d(0.5, 0, 0.8), new Vector3d(-0.5, 0, 0.8), new Vector3d(-1, 0, 0.1), new Vector3d(-0.5, 0, -0.8), new Vector3d(0.5, 0, -0.9),
        };
        var bodies = new KinematicBodies();
        foreach (Vector3d _ in from)
        {
            bodies.Add("leg", new CapsuleShape(new Vector3d(0, 0.08, 0), new Vector3d(0, 0.9, 0), 0.08), SurfaceMaterial.Boot, 10);
        }

        return new GoldenPlay(scene with { Bodies = bodies }, 1.5)
        {
            Move = time =>
            {
                for (int i = 0; i < from.Length; i++)
                {
                    double gone = Math.Min(time, 0.8);
                    bodies[i].MoveTo((1 - gone) * from[i], time < 0.8 ? -from[i] : default, time);
                }
            },
        }.Roll(0.05, 0.03, 0.2, 0);
    }

    private static GoldenPlay LegSwingsDown(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody leg = bodies.Add("leg", new CapsuleShape(default, new Vector3d(0.9, 0, 0), 0.07), SurfaceMaterial.Boot);
        var turn = new Vector3d(0, 0, -1.5);
        return new GoldenPlay(scene with { Bodies = bodies }, 1.2)
        {
            Move = time => leg.MoveTo(new Vector3d(-0.6, 0.5, 0), Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), 0.5 - (1.5 * Math.Min(time, 0.7))), default, time < 0.7 ? turn : default, time),
        }.Ball(new Vector3d(0, Radius, 0.01));
    }

    private static GoldenPlay Boots(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody one = bodies.Add("boot", BodyKind.Boot);
        KinematicBody other = bodies.Add("other boot", BodyKind.Boot);
        return new GoldenPlay(scene with { Bodies = bodies }, 1)
        {
            Move = time =>
            {
                double x = Math.Max(0.15, 0.6 - time);
                one.MoveTo(new Vector3d(-x, 0.1, 0.02), new Vector3d(x > 0.15 ? 1 : 0, 0, 0), time);
                other.MoveTo(new Vector3d(x, 0.12, 0), new Vector3d(x > 0.15 ? -1 : 0, 0, 0), time);
            },
        }.Roll(0.02, 0, 0, 0.1);
    }

    private static GoldenPlay EngineToBoard(Scene scene)
    {
        var engine = new GoldenEngine { MaximumSpeed = 1 };
        Engines.EngineCollider crate = engine.Add("crate", Box(-0.2, 0, -0.2, 0.2, 0.4, 0.2), SurfaceMaterial.Wood);
        return new GoldenPlay(scene.With(BoardAlongX(-0.5)) with { EngineColliders = engine }, 1.4)
        {
            Move = time =>
            {
                engine.Time = time;
                crate.MoveTo(new Vector3d(0.03, 0, 0.6 - Math.Min(time, 0.8)), Quaterniond.Identity, new Vector3d(0, 0, time < 0.8 ? -1 : 0), default);
            },
        }.Roll(0, -0.2, 0, 0);
    }

    private static GoldenPlay EnginePinch(Scene scene)
    {
        var engine = new GoldenEngine { MaximumSpeed = 2 };
        Engines.EngineCollider one = engine.Add("one", new SphereShape(default, 0.2), SurfaceMaterial.Boot, 5);
        Engines.EngineCollider other = engine.Add("other", new SphereShape(default, 0.25), SurfaceMaterial.Boot);
        return new GoldenPlay(scene with { EngineColliders = engine }, 1)
        {
            Move = time =>
            {
                double x = Math.Max(0.25, 0.8 - time);
                engine.Time = time;
                one.MoveTo(new Vector3d(-x, 0.2, 0.01), Quaterniond.Identity, new Vector3d(x > 0.25 ? 1 : 0, 0, 0), default);
                other.MoveTo(new Vector3d(x, 0.25, 0), Quaterniond.Identity, new Vector3d(x > 0.25 ? -1 : 0, 0, 0), default);
            },
        }.Roll(0, 0, 0, 0);
    }

    private static GoldenPlay NetPressed(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody plate = bodies.Add("plate", Box(-0.4, 0, -0.05, 0.4, 1, 0.05), SurfaceMaterial.Wood);
        var net = new Net { Center = new Vector3d(0, 0.5, -1), Normal = new Vector3d(0, 0, 1), Along = new Vector3d(1, 0, 0), HalfLength = 2, HalfWidth = 1 };
        return new GoldenPlay(scene with { Bodies = bodies, Nets = new[] { net } }, 1.5)
        {
            Move = time => plate.MoveTo(new Vector3d(0, 0, 0.3 - Math.Min(1.5 * time, 1.35)), new Vector3d(0, 0, time < 0.9 ? -1.5 : 0), time),
        }.Roll(0.1, 0, 0, -0.5);
    }

    private static GoldenPlay Withdrawn(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody plate = bodies.Add("plate", Box(-0.4, 0, -0.05, 0.4, 1, 0.05), SurfaceMaterial.Wood, 20);
        return new GoldenPlay(scene.InWind(0, 0, -3).With(BoardAlongX(-0.5)) with { Bodies = bodies }, 1.6)
        {
            Move = time =>
            {
                if (time is > 0.75 and < 1.15)
                {
                    plate.Withdraw();
                }
                else
                {
                    plate.MoveTo(time < 1 ? new Vector3d(0, 0, 0.2 - (0.9 * time)) : s_far, new Vector3d(0, 0, time < 1 ? -0.9 : 0), time);
                }
            },
        }.Roll(0.05, -0.3, 0, 0);
    }
}
