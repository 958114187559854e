using FootballPhysics.Shapes;
using static FootballPhysics.Golden.GoldenObjects;

// Several balls: collisions, rows, heaps, balls of different kinds, and balls that bodies press.

namespace FootballPhysics.Golden;

internal static class GoldenGroups
{
    private static readonly BallProperties[] s_kinds =
    {
        BallProperties.Tunnel,
        new BallProperties { Mass = 0.2, Radius = 0.09 },
        new BallProperties { Mass = 0.6, Radius = 0.12, InertiaFactor = 0.4 },
        new BallProperties { Mass = 3, Radius = 0.12, InertiaFactor = 0.4, Bounce = 0.8 },
    };

    public static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return Collisions().Concat(Heaps()).Concat(Pressed());
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Collisions()
    {
        yield return ("balls-meet-in-air", scene => new GoldenPlay(scene, 1.5)
            .Ball(new Vector3d(-3, 1, 0), new Vector3d(9, 3, 0), new Vector3d(0, 20, 10)).Ball(new Vector3d(3, 1.1, 0.05), new Vector3d(-9, 3, 0), new Vector3d(30, 0, 10)));
        yield return ("balls-meet-on-turf", scene => new GoldenPlay(scene, 2).Roll(-1, 0, 4, 0).Roll(1, 0.08, -3, 0).Roll(0, 1.5, 0, -3));
        yield return ("ball-hits-one-at-rest", scene => new GoldenPlay(scene, 2).Roll(-1, 0.05, 5, 0).Roll(0, 0, 0, 0));
        yield return ("row", scene => Row(new GoldenPlay(scene, 2).Roll(-1.5, 0.01, 6, 0), 4, 2 * Radius));
        yield return ("row-apart", scene => Row(new GoldenPlay(scene, 2).Roll(-1.5, 0, 6, 0.1), 4, 0.26));
        yield return ("row-at-board", scene => Row(new GoldenPlay(scene.With(Thing("board", Box(0.77, 0, -5, 1, 1, 5))), 2).Roll(-1.5, 0.01, 6, 0), 4, 2 * Radius));
        yield return ("rack", scene => Rack(new GoldenPlay(scene, 2).Roll(-1.5, 0.02, 8, 0)));
        yield return ("kinds-meet", scene => new GoldenPlay(scene, 2) { Kinds = s_kinds }
            .Ball(new Vector3d(0, 0.5, 0), new Vector3d(4, 1, 0)).Ball(new Vector3d(2, 0.4, 0), new Vector3d(-3, 2, 0)).Ball(new Vector3d(1, 0.12, 1), new Vector3d(0, 0, -3)).Ball(new Vector3d(1, 0.12, -1), new Vector3d(0, 0, 2)));
        yield return ("balls-among-posts", scene => new GoldenPlay(Pitch.Standard.On(scene), 2)
            .Ball(new Vector3d(3, 0.5, -50), new Vector3d(2, 2, -15)).Ball(new Vector3d(1, 0.5, -50), new Vector3d(6, 2, -14), new Vector3d(0, 30, 0)).Roll(3.3, -53.5, 0, 0));
        yield return ("balls-and-zones", scene => new GoldenPlay(scene with { Zones = new[] { new Zone { Name = "zone", Shape = Box(-1, 0, -1, 1, 1, 0) } } }, 1.5).Roll(0, 1, 0, -4).Roll(0.03, -0.8, 0, 3));
        yield return ("balls-on-hill", scene => new GoldenPlay(scene.OnHills((x, z) => 0.06 * ((x * x) + (z * z))), 2).Ball(new Vector3d(1.5, 0.4, 0)).Ball(new Vector3d(-1.4, 0.4, 0.1)).Ball(new Vector3d(0, 0.3, 0.9)));
        yield return ("balls-on-turntable", scene => new GoldenPlay(scene.InSpace().With(Thing("table", Box(-20, -1, -20, 20, 0, 20), SurfaceMaterial.DryTurf, default, new Vector3d(0, 1.5, 0))), 2)
            .Ball(new Vector3d(0.8, Radius, 0)).Ball(new Vector3d(0.9, Radius, 0.3), new Vector3d(-1, 0, -1)).Ball(new Vector3d(-0.5, Radius, 0), new Vector3d(2, 0, 0)));
        yield return ("balls-hit-crate", scene => new GoldenPlay(scene.With(Thing("crate", Box(-0.5, 0, -0.1, 0.5, 0.5, 0.1), SurfaceMaterial.Wood, default, default, 0.5)), 1.2)
            .Roll(-0.2, 1, 0, -12).Roll(0.25, 1.1, 0, -11).Roll(0.2, -0.4, 0, 0));
        yield return ("balls-hit-engine", BallsHitEngine);
        yield return ("thrown-back", scene => new GoldenPlay(scene.With(Thing("boot", new SphereShape(new Vector3d(0, 1, 0), 0.2), SurfaceMaterial.Boot, new Vector3d(0, 0, 5), default, 75)), 0.8)
            .Ball(new Vector3d(0.02, 1, 1.5), new Vector3d(0, 0, -9), new Vector3d(10, 20, 0)).Ball(new Vector3d(0.03, 1.02, 1.9), new Vector3d(0, 0, -20), new Vector3d(0, 0, 30)));
        yield return ("layers-of-balls", scene => new GoldenPlay(scene.With(Thing("net wall", Box(-1, 0, -1.2, 1, 1, -1)) with { Layer = 1 }), 1.2)
        {
            Kinds = new[] { BallProperties.Tunnel, BallProperties.Tunnel with { Ignores = 2 } },
        }.Ball(new Vector3d(-0.5, Radius, 0), new Vector3d(0, 0, -4)).Ball(new Vector3d(0.5, Radius, 0), new Vector3d(0, 0, -4)));
        yield return ("group-of-one", scene => new GoldenPlay(scene.InWind(-3, 0, -8).With(BoardAlongX(-0.5)), 1.5) { IsGroup = true }.Roll(0, 0, 3, -1));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Heaps()
    {
        yield return ("ball-on-ball", scene => new GoldenPlay(scene, 1.5).Ball(new Vector3d(0, Radius, 0)).Ball(new Vector3d(0.01, 0.5, 0.02), default, new Vector3d(0, 20, 0)));
        yield return ("heap-in-tube", scene => Drop(new GoldenPlay(Walled(scene, 0.12), 2), 3, 0.009));
        yield return ("heap-in-box", scene => Drop(new GoldenPlay(Walled(scene, 0.3), 2.5), 6, 0.08));
        yield return ("heap-in-corner", scene => Drop(new GoldenPlay(scene.With(BoardAlongX(-0.2), BoardAlongZ(-0.2)), 2), 4, 0.06));
        yield return ("heap-of-kinds", scene => Drop(new GoldenPlay(Walled(scene, 0.3), 2) { Kinds = s_kinds.Concat(s_kinds.Take(2)).ToArray() }, 6, 0.08));
        yield return ("heap-in-wind", scene => Drop(new GoldenPlay(Walled(scene.InWind(6, 0, 2), 0.3), 2), 4, 0.08));
        yield return ("heap-in-gutter", scene => Drop(new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0.1, 1, 0.7)), Thing("right", Plane(0, 0, 0, 0.1, 1, -0.7)), Thing("end", Plane(0.7, 0, 0, -1, 0.2, 0))), 2), 3, 0.05));
        yield return ("heap-in-net", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Roll(1, -54.2, 0, -1).Roll(1.25, -54.2, -0.2, -1).Ball(new Vector3d(1.1, 0.6, -54), new Vector3d(0, 0, -1)));
        yield return ("heap-on-roof", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Ball(new Vector3d(0.1, 2.8, -52.9)).Ball(new Vector3d(0, 3.2, -52.95)));
        yield return ("heap-on-hill", scene => Drop(new GoldenPlay(scene.OnHills((x, z) => 0.06 * ((x * x) + (z * z))), 2), 3, 0.1));
        yield return ("heap-on-belt", scene => Drop(new GoldenPlay(scene.InSpace().With(Thing("belt", Box(-20, -1, -20, 20, 0, 20), SurfaceMaterial.Wood, new Vector3d(1, 0, 0)), Thing("stop", Box(0.6, 0, -5, 1, 1, 5))), 2), 3, 0.06));
        yield return ("heap-kicked", scene => Drop(new GoldenPlay(Walled(scene, 0.3), 2.5), 4, 0.08).Kick(1.5, new Vector3d(0, 4, 0.5)).Kick(2, new Vector3d(0.5, 2, 0), new Vector3d(0, 0, 20), 1));
        yield return ("pyramid", scene => new GoldenPlay(scene, 1.5)
            .Ball(new Vector3d(0.127017, Radius, 0)).Ball(new Vector3d(-0.063508, Radius, 0.11)).Ball(new Vector3d(-0.063508, Radius, -0.11)).Ball(new Vector3d(0, 0.29, 0)));
        yield return ("pyramid-hit", scene => new GoldenPlay(scene, 1.5)
            .Ball(new Vector3d(0.127017, Radius, 0)).Ball(new Vector3d(-0.063508, Radius, 0.11)).Ball(new Vector3d(-0.063508, Radius, -0.11)).Ball(new Vector3d(0, 0.29, 0)).Roll(-1.5, 0.03, 7, 0));
        yield return ("balls-in-one-place", scene => new GoldenPlay(scene, 1).Ball(new Vector3d(0, Radius, 0)).Ball(new Vector3d(0, Radius, 0)).Ball(new Vector3d(0, Radius, 0)));
        yield return ("balls-overlap", scene => new GoldenPlay(scene, 1).Ball(new Vector3d(0, Radius, 0), new Vector3d(0.5, 0, 0)).Ball(new Vector3d(0.15, Radius, 0.02)).Ball(new Vector3d(0.1, 0.25, 0)));
        yield return ("balls-between-slopes", scene => new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, 1, 1, 0)), Thing("right", Plane(0, 0, 0, -1, 1, 0.3)), Thing("ball stop", new SphereShape(new Vector3d(0, 0.1, -0.8), 0.3))), 2)
            .Ball(new Vector3d(0.05, 0.4, 0.3)).Ball(new Vector3d(-0.05, 0.7, 0.25)));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Pressed()
    {
        yield return ("pair-to-board-in-wind", scene => new GoldenPlay(scene.InWind(1, 0, -12).With(BoardAlongX(-Radius)), 2.5).Roll(0, 0, 0, 0).Roll(0.01, 2 * Radius, 0, 0));
        yield return ("pair-slides-along-board", scene => new GoldenPlay(scene.InWind(3, 0, -14).With(BoardAlongX(-Radius)), 2).Roll(0, 0, 2, 0).Roll(0.03, 0.23, 2, -0.2));
        yield return ("pair-down-slope", scene => new GoldenPlay(scene with { Ground = new Ground { Material = scene.Ground.Material, Normal = new Vector3d(0.12, 1, 0) } }, 2)
            .Ball(new Vector3d(0.5, 0.06, 0)).Ball(new Vector3d(0.279, 0.086, 0.01), new Vector3d(0, 0, 0.01)));
        yield return ("pair-on-slope-at-board", scene => new GoldenPlay((scene with { Ground = new Ground { Material = scene.Ground.Material, Normal = new Vector3d(0, 1, -0.15) } }).With(BoardAlongX(-0.4)), 2.5)
            .Ball(new Vector3d(0, 0.15, 0)).Ball(new Vector3d(0.05, 0.2, 0.3)).Ball(new Vector3d(-0.2, 0.2, 0.2)));
        yield return ("row-in-corner-in-wind", scene => new GoldenPlay(scene.InWind(-8, 0, -6).With(BoardAlongX(-0.2), BoardAlongZ(-0.2)), 2.5).Roll(0, 0, -1, 0.3).Roll(0.25, 0.01, -0.5, 0).Roll(0.02, 0.26, 0, -2));
        yield return ("row-in-gutter", scene => new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0.08, 1, 0.8), SurfaceMaterial.Wood), Thing("right", Plane(0, 0, 0, 0.08, 1, -0.8), SurfaceMaterial.Wood), Thing("end", Plane(0.5, 0, 0, -1, 0, 0))), 2.5)
            .Ball(new Vector3d(0.2, 0.15, 0)).Ball(new Vector3d(-0.1, 0.17, 0)).Ball(new Vector3d(-0.4, 0.2, 0)));
        yield return ("two-balls-and-player", scene => GoldenSqueezes.Walk(scene.With(BoardAlongX(-0.9)), 75, new Vector3d(0.1, 0, 0.4), new Vector3d(0, 0, -1.5), 0.8).Roll(0, -0.7, 0, 0).Roll(0.26, -0.6, 0, 0));
        yield return ("player-drives-two", scene => GoldenSqueezes.Walk(scene, double.PositiveInfinity, new Vector3d(-0.8, 0, 0), new Vector3d(2.5, 0, 0), 1.5).Roll(0, 0.03, 0, 0).Roll(0.25, 0, 0, 0));
        yield return ("player-presses-row", scene => GoldenSqueezes.Walk(scene.With(BoardAlongX(-0.9)), double.PositiveInfinity, new Vector3d(0.02, 0, 0.5), new Vector3d(0, 0, -1), 1).Roll(0, -0.78, 0, 0).Roll(0.01, -0.55, 0, 0));
        yield return ("heap-pushed-to-corner", HeapPushedToCorner);
        yield return ("lid-on-two", LidOnTwo);
        yield return ("pair-leans-on-body", PairLeansOnBody);
        yield return ("pair-pinched", PairPinched);
        yield return ("balls-on-lift", BallsOnLift);
        yield return ("balls-in-slot", scene => new GoldenPlay(scene.With(BoardAlongX(-Radius), Thing("far board", Box(-50, 0, Radius, 50, 1, 0.3)), Thing("stop", Box(1, 0, -1, 1.1, 1, 1))), 2)
            .Roll(0, 0, 3, 0).Roll(-0.5, 0, 4, 0).Roll(0.6, 0, 0, 0));
    }

    private static GoldenPlay Row(GoldenPlay play, int count, double apart)
    {
        for (int i = 0; i < count; i++)
        {
            play.Roll(apart * i, 0, 0, 0);
        }

        return play;
    }

    /// <summary>Six balls in a triangle that just touch, up to rounding.</summary>
    private static GoldenPlay Rack(GoldenPlay play)
    {
        for (int row = 0; row < 3; row++)
        {
            for (int i = 0; i <= row; i++)
            {
                play.Roll(0.190526 * row, Radius * ((2 * i) - row), 0, 0);
            }
        }

        return play;
    }

    /// <summary>Balls one above the other, each a little to one side.</summary>
    private static GoldenPlay Drop(GoldenPlay play, int count, double aside)
    {
        for (int i = 0; i < count; i++)
        {
            play.Ball(new Vector3d(aside * (((i * 5) % 7) - 3) / 3, 0.2 + (0.27 * i), aside * (((i * 3) % 5) - 2) / 2));
        }

        return play;
    }

    private static Scene Walled(Scene scene, double half)
    {
        return scene.With(
            Thing("left", Plane(-half, 0, 0, 1, 0, 0)), Thing("right", Plane(half, 0, 0, -1, 0, 0)), Thing("back", Plane(0, 0, -half, 0, 0, 1)), Thing("front", Plane(0, 0, half, 0, 0, -1)));
    }

    private static GoldenPlay BallsHitEngine(Scene scene)
    {
        var engine = new GoldenEngine { MaximumSpeed = 3 };
        Engines.EngineCollider crate = engine.Add("crate", new SphereShape(default, 0.3), SurfaceMaterial.Wood, 0.5);
        return new GoldenPlay(scene with { EngineColliders = engine }, 1)
        {
            Move = time =>
            {
                engine.Time = time;
                crate.MoveTo(new Vector3d(0, 0.3, -time), Quaterniond.Identity, new Vector3d(0, 0, -1), default);
            },
        }.Roll(-0.1, 1, 0, -12).Roll(0.1, 1.4, 0, -13);
    }

    private static GoldenPlay HeapPushedToCorner(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody pusher = bodies.Add("pusher", Box(-0.1, 0, -1, 0.1, 1, 1), SurfaceMaterial.Wood);
        return new GoldenPlay(scene.With(BoardAlongX(-0.3), BoardAlongZ(-0.3)) with { Bodies = bodies }, 1.5)
        {
            Move = time => pusher.MoveTo(new Vector3d(0.9 - (0.7 * Math.Min(time, 1)), 0, 0), new Vector3d(time < 1 ? -0.7 : 0, 0, 0), time),
        }.Roll(-0.1, -0.19, 0, 0).Roll(0.13, -0.19, 0, 0).Roll(-0.1, 0.04, 0, 0).Roll(0.14, 0.05, 0, 0);
    }

    private static GoldenPlay LidOnTwo(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody lid = bodies.Add("lid", Box(-1, 0, -1, 1, 0.2, 1), SurfaceMaterial.Wood, 10);
        return new GoldenPlay(scene with { Bodies = bodies }, 1.2)
        {
            Move = time => lid.MoveTo(new Vector3d(0, 0.5 - (0.5 * Math.Min(time, 0.7)), 0), new Vector3d(0, time < 0.7 ? -0.5 : 0, 0), time),
        }.Roll(0, 0, 0, 0).Ball(new Vector3d(0.05, 0.32, 0));
    }

    private static GoldenPlay PairLeansOnBody(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody plate = bodies.Add("plate", Box(-1, 0, -0.2, 1, 1, 0), SurfaceMaterial.Wood);
        return new GoldenPlay(scene.InWind(0, 0, -18) with { Bodies = bodies }, 2.5)
        {
            Move = time => plate.MoveTo(new Vector3d(0, 0, time < 1.8 ? 0 : -3 * (time - 1.8)), new Vector3d(0, 0, time < 1.8 ? 0 : -3), time),
        }.Roll(0, 0.12, 0, 0).Roll(0.002, 0.345, 0, 0);
    }

    private static GoldenPlay PairPinched(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody one = bodies.Add("one", PlayerShape, SurfaceMaterial.Boot);
        KinematicBody other = bodies.Add("other", PlayerShape, SurfaceMaterial.Boot, 75);
        return new GoldenPlay(scene with { Bodies = bodies }, 1.2)
        {
            Move = time =>
            {
                double x = Math.Max(0.42, 1 - time);
                one.MoveTo(new Vector3d(-x, 0, 0.01), new Vector3d(x > 0.42 ? 1 : 0, 0, 0), time);
                other.MoveTo(new Vector3d(x, 0, 0), new Vector3d(x > 0.42 ? -1 : 0, 0, 0), time);
            },
        }.Roll(-0.12, 0, 0, 0).Roll(0.12, 0.01, 0, 0);
    }

    private static GoldenPlay BallsOnLift(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody lift = bodies.Add("lift", Box(-2, -0.2, -2, 2, 0, 2), SurfaceMaterial.Wood);
        return new GoldenPlay(scene.InSpace() with { Bodies = bodies }, 1.5)
        {
            Move = time => lift.MoveTo(new Vector3d(0.2 * time, 0.5 * time, 0), new Vector3d(0.2, 0.5, 0), time),
        }.Ball(new Vector3d(0, Radius, 0)).Ball(new Vector3d(0.21, 0.14, 0.02)).Ball(new Vector3d(0.1, 0.4, 0.01));
    }
}
