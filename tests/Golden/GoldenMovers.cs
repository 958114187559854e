using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using static FootballPhysics.Golden.GoldenObjects;

// Objects that carry a ball, turn, or have a mass: turntables, belts, lifts, paddles, cones, colliders of an engine.

namespace FootballPhysics.Golden;

internal static class GoldenMovers
{
    private static readonly IShape s_slab = Box(-20, -1, -20, 20, 0, 20);

    public static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return Carriers().Concat(Turning()).Concat(Masses()).Concat(Engines());
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Carriers()
    {
        yield return ("turntable", scene => new GoldenPlay(scene.InSpace().With(Thing("table", s_slab, Rough, default, new Vector3d(0, 1, 0))), 3)
            .Ball(new Vector3d(1, Radius, 0), new Vector3d(0.5, 0, 0), new Vector3d(1 / Radius, 0, -0.5 / Radius)));
        yield return ("turntable-of-turf", scene => new GoldenPlay(scene.InSpace().With(Thing("table", s_slab, SurfaceMaterial.DryTurf, default, new Vector3d(0, 1.5, 0))), 3)
            .Ball(new Vector3d(0.3, Radius, 0), new Vector3d(0, 0, -1)));
        yield return ("turntable-body", scene => Body(scene.InSpace(), s_slab, Rough, 2.5, (body, time) =>
            body.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, -2.5 * time), default, new Vector3d(0, -2.5, 0), time)).Ball(new Vector3d(0.8, Radius, 0), new Vector3d(0.5, 0, 0)));
        yield return ("turntable-with-board", scene => Body(scene.InSpace().With(BoardAlongX(-0.6)), s_slab, SurfaceMaterial.Wood, 2.5, (body, time) =>
            body.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, 2 * time), default, new Vector3d(0, 2, 0), time)).Ball(new Vector3d(0.6, Radius, 0)));
        yield return ("belt", scene => new GoldenPlay(scene.InSpace().With(Thing("belt", s_slab, SurfaceMaterial.DryTurf, new Vector3d(2, 0, 0))), 3).Ball(new Vector3d(0, Radius, 0)));
        yield return ("belt-to-board", scene => new GoldenPlay(scene.InSpace().With(Thing("belt", s_slab, SurfaceMaterial.DryTurf, new Vector3d(1.5, 0, 0.7)), Thing("stop", Box(0.5, 0, -5, 1, 1, 5))), 2)
            .Ball(new Vector3d(0, Radius, 0)));
        yield return ("belt-to-corner", scene => new GoldenPlay(
            scene.InSpace().With(Thing("belt", s_slab, SurfaceMaterial.Wood, new Vector3d(-1.2, 0, -0.9)), BoardAlongX(-0.4), BoardAlongZ(-0.4)), 2).Ball(new Vector3d(0, Radius, 0), new Vector3d(0, 0, 1)));
        yield return ("belts-in-a-gutter", scene => new GoldenPlay(
            scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0, 1, 0.8), SurfaceMaterial.Wood, new Vector3d(1, 0, 0)), Thing("right", Plane(0, 0, 0, 0, 1, -0.8), SurfaceMaterial.DryTurf, new Vector3d(-0.6, 0, 0))), 2)
            .Ball(new Vector3d(0, 0.2, 0)));
        yield return ("gutter-on-the-move", scene => new GoldenPlay(
            scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0, 1, 0.8), SurfaceMaterial.Wood, new Vector3d(1, 0.2, 0)), Thing("right", Plane(0, 0, 0, 0, 1, -0.8), SurfaceMaterial.DryTurf, new Vector3d(1, 0.2, 0))), 2)
            .Ball(new Vector3d(0, 0.2, 0)));
        yield return ("lift", scene => Body(scene.InSpace(), s_slab, SurfaceMaterial.Wood, 2, (body, time) =>
            body.MoveTo(new Vector3d(0, 0.4 * Math.Max(0, time - 0.5), 0), new Vector3d(0, time < 0.5 ? 0 : 0.4, 0), time)).Ball(new Vector3d(0.3, Radius, 0)));
        yield return ("lift-falls", scene => Body(scene.InSpace(), s_slab, SurfaceMaterial.Wood, 1.5, (body, time) =>
            body.MoveTo(new Vector3d(0, -3 * time * time, 0), new Vector3d(0, -6 * time, 0), time)).Ball(new Vector3d(0.3, Radius, 0), new Vector3d(1, 0, 0)));
        yield return ("platform-sets-off", scene => Body(scene.InSpace(), s_slab, SurfaceMaterial.DryTurf, 2, (body, time) =>
            body.MoveTo(new Vector3d(0.5 * time * time, 0, 0), new Vector3d(time, 0, 0), time)).Ball(new Vector3d(0, Radius, 0), new Vector3d(-1, 0, 0.5), new Vector3d(0.5 / Radius, 0, 1 / Radius)));
        yield return ("platform-shakes", scene => Body(scene.InSpace(), s_slab, Rough, 1.5, (body, time) =>
            body.MoveTo(default, new Vector3d(((int)((time * 10) + 0.01) % 3) - 1, 0, ((int)((time * 10) + 0.01) % 2) * 0.5), time)).Ball(new Vector3d(0, Radius, 0)));
        yield return ("tray-tilts", scene => Body(scene.InSpace(), Box(-2, -0.2, -2, 2, 0, 2), SurfaceMaterial.Wood, 2, (body, time) =>
            body.MoveTo(default, Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), 0.2 * time), default, new Vector3d(0, 0, 0.2), time)).Ball(new Vector3d(0.5, Radius, 0)));
        yield return ("drum", scene => new GoldenPlay(scene.InSpace().With(Thing("drum", new SphereShape(new Vector3d(0, -1, 0), 1), Rough, default, new Vector3d(0.3, 0.5, 2)) with { Pivot = new Vector3d(0, -1, 0) }), 1.5)
            .Ball(new Vector3d(0.05, 0.11, 0)));
        yield return ("cart", scene => new GoldenPlay(
            scene.With(Thing("cart", Box(-0.5, 0, -0.5, 0.5, 0.3, 0.5), SurfaceMaterial.Wood, new Vector3d(1.5, 0, 0)), Thing("cart's back", Box(-0.6, 0.3, -0.5, -0.5, 0.8, 0.5), SurfaceMaterial.Wood, new Vector3d(1.5, 0, 0))), 2)
            .Ball(new Vector3d(0, 0.3 + Radius, 0)));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Turning()
    {
        yield return ("paddle", scene => new GoldenPlay(scene.With(Thing("paddle", Box(-1, 0, -0.1, 1, 1, 0.1), SurfaceMaterial.Wood, default, new Vector3d(0, 3, 0))), 1.5).Roll(0.8, 0.5, 0, -0.5));
        yield return ("paddle-pushes", scene => new GoldenPlay(scene.With(Thing("paddle", Box(-2, 0, -0.1, 2, 1, 0.1), SurfaceMaterial.Wood, default, new Vector3d(0, 0.6, 0))), 2.5).Roll(0.9, -0.4, 0, 0));
        yield return ("paddle-to-board", scene => new GoldenPlay(scene.With(Thing("paddle", Box(-2, 0, -0.1, 2, 1, 0.1), SurfaceMaterial.Wood, default, new Vector3d(0, 0.5, 0)), BoardAlongX(-0.7)), 1.6).Roll(0.9, -0.45, 0, 0));
        yield return ("hinged-door", scene => Body(scene, Box(0, 0, -0.05, 1.5, 2, 0.05), SurfaceMaterial.Wood, 1.5, (body, time) =>
            body.MoveTo(new Vector3d(-0.5, 0, 0.8), Quaterniond.FromAxisAngle(Vector3d.Up, 1.2 * time), default, new Vector3d(0, 1.2, 0), time)).Roll(0.5, 0, 0, 0));
        yield return ("swung-leg", scene => Body(scene, new CapsuleShape(default, new Vector3d(0, -0.85, 0), 0.07), SurfaceMaterial.Boot, 1.2, (body, time) =>
            body.MoveTo(new Vector3d(0.02, 1, 0.7), Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), -1 + (6 * Math.Min(time, 0.3))), default, new Vector3d(time < 0.3 ? 6 : 0, 0, 0), time)).Roll(0, 0, 0, 0.5));
        yield return ("mill", scene => new GoldenPlay(
            scene.With(Thing("arm", Box(-1.2, 0, -0.05, 1.2, 1, 0.05), SurfaceMaterial.Board, default, new Vector3d(0, 4, 0)), Thing("other arm", Box(-0.05, 0, -1.2, 0.05, 1, 1.2), SurfaceMaterial.Board, default, new Vector3d(0, 4, 0))), 1.2)
            .Roll(0.7, 0.6, -1, 0));
        yield return ("tumbling-box", scene => Body(scene, Box(-0.4, -0.2, -0.6, 0.4, 0.2, 0.6), SurfaceMaterial.Wood, 1.5, (body, time) =>
            body.MoveTo(new Vector3d(time - 1, 0.6, 0), Quaterniond.FromRotationVector(time * new Vector3d(1, 3, 2)), new Vector3d(1, 0, 0), new Vector3d(1, 3, 2), time)).Ball(new Vector3d(0, 0.8, 0), new Vector3d(-2, 1, 0)));
        yield return ("hills-that-turn", scene => Body(scene.InSpace(), Hills((x, z) => 0.04 * x * x), SurfaceMaterial.DryTurf, 1.5, (body, time) =>
            body.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, 0.8 * time), default, new Vector3d(0, 0.8, 0), time)).Ball(new Vector3d(1, 0.25, 0), new Vector3d(0, 0, 1)));
        yield return ("roller-under-ball", scene => new GoldenPlay(
            scene.With(Thing("roller", new CapsuleShape(new Vector3d(0.5, 0.02, -2), new Vector3d(0.5, 0.02, 2), 0.05), Rough, default, new Vector3d(0, 0, 8)) with { Pivot = new Vector3d(0.5, 0.02, 0) }, BoardAlongX(-Radius)), 1.5)
            .Roll(0, 0, 1, 0));
        yield return ("shell-that-turns", scene => new GoldenPlay(
            scene.InSpace().With(Thing("bowl", new GoldenBowl(new Vector3d(0, 0.6, 0), 0.6), SurfaceMaterial.Wood, default, new Vector3d(0, 0, 4)) with { Pivot = new Vector3d(0, 0.6, 0) }), 2).Ball(new Vector3d(0.1, 0.15, 0)));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Masses()
    {
        yield return ("cone-hit", scene => new GoldenPlay(scene.With(Thing("cone", BodyKind.Cone.Shape, SurfaceMaterial.Board, default, default, 0.3)), 1).Roll(0.05, 2, 0, -10));
        yield return ("crate-hit-twice", scene => new GoldenPlay(
            scene.With(Thing("crate", Box(-0.4, 0, -0.2, 0.4, 0.5, 0.2), SurfaceMaterial.Wood, default, default, 1.5), BoardAlongX(-2)), 1.5).Roll(0, 1, 0, -8).Kick(0.7, new Vector3d(0.2, 1, -9)));
        yield return ("crate-pushed", scene => new GoldenPlay(scene.With(Thing("crate", Box(-0.4, 0, -0.2, 0.4, 0.5, 0.2), SurfaceMaterial.Wood, new Vector3d(0, 0, 1), default, 1.5)), 1.2).Roll(0.1, 0.7, 0, -1));
        yield return ("crate-to-board", scene => new GoldenPlay(scene.With(Thing("crate", Box(-0.4, 0, 0.3, 0.4, 0.5, 0.5), SurfaceMaterial.Wood, new Vector3d(0, 0, -1.5), default, 3), BoardAlongX(-0.4)), 1).Roll(0.1, -0.1, 0, 0));
        yield return ("turning-crate-hit", scene => new GoldenPlay(
            scene.With(Thing("crate", Box(-0.4, 0, -0.2, 0.4, 0.5, 0.2), SurfaceMaterial.Wood, default, new Vector3d(0, 2, 0), 2)), 1.2).Roll(0.3, 1, 0, -4));
        yield return ("header", Header);
        yield return ("flag", scene => new GoldenPlay(scene.With(Thing("flag", BodyKind.CornerFlag.Shape, SurfaceMaterial.Board, default, default, 0.8)), 1).Ball(new Vector3d(0.05, 0.5, 1), new Vector3d(0, 1, -15)));
        yield return ("wall-of-players", WallOfPlayers);
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Engines()
    {
        yield return ("engine-turntable", scene => Engine(scene.InSpace(), s_slab, Rough, double.PositiveInfinity, 2, 60, (table, time) =>
            table.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, 1.2 * time), default, new Vector3d(0, 1.2, 0))).Ball(new Vector3d(0.8, Radius, 0), new Vector3d(0.5, 0, 0)));
        yield return ("engine-crate", scene => Engine(scene, Box(-0.4, 0, -0.4, 0.4, 0.6, 0.4), SurfaceMaterial.Wood, 4, 1.5, 6, (crate, time) =>
            crate.MoveTo(new Vector3d(0.1, 0, -2 + time), Quaterniond.FromAxisAngle(Vector3d.Up, time), new Vector3d(0, 0, 1), new Vector3d(0, 1, 0))).Roll(0, 0, 0, -5));
        yield return ("engine-corner", EngineCorner);
        yield return ("engine-mesh-floor", EngineMeshFloor);
        yield return ("engine-tiles", EngineTiles);
        yield return ("layers", Layers);
    }

    private static GoldenPlay Body(Scene scene, IShape shape, SurfaceMaterial surface, double duration, Action<KinematicBody, double> move)
    {
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("body", shape, surface);
        return new GoldenPlay(scene with { Bodies = bodies }, duration) { Move = time => move(body, time) };
    }

    private static GoldenPlay Engine(Scene scene, IShape shape, SurfaceMaterial surface, double mass, double duration, double fastest, Action<EngineCollider, double> move)
    {
        var engine = new GoldenEngine { MaximumSpeed = fastest };
        EngineCollider collider = engine.Add("collider", shape, surface, mass);
        return new GoldenPlay(scene with { EngineColliders = engine }, duration)
        {
            Move = time =>
            {
                engine.Time = time;
                move(collider, time);
            },
        };
    }

    private static GoldenPlay Header(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody head = bodies.Add("head", BodyKind.Head);
        return new GoldenPlay(scene with { Bodies = bodies }, 1)
        {
            Move = time => head.MoveTo(new Vector3d(0, 1.7, time), new Vector3d(0, 0, 1), time),
        }.Ball(new Vector3d(0.02, 1.6, 2), new Vector3d(0, 0.5, -12), new Vector3d(10, 0, 20));
    }

    private static GoldenPlay WallOfPlayers(Scene scene)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < 4; i++)
        {
            bodies.Add("player", BodyKind.Player);
        }

        return new GoldenPlay(scene with { Bodies = bodies }, 1.2)
        {
            Move = time =>
            {
                for (int i = 0; i < 4; i++)
                {
                    bodies[i].MoveTo(new Vector3d((0.52 * i) - 0.8, 0.2 * time, -3), new Vector3d(0, 0.2, 0), time);
                }
            },
        }.Ball(new Vector3d(0, Radius, 0), new Vector3d(0.4, 3, -22), new Vector3d(20, 30, 0));
    }

    private static GoldenPlay EngineCorner(Scene scene)
    {
        var engine = new GoldenEngine();
        engine.AddSurface("wall", new Vector3d(0, 0, -0.4), new Vector3d(0.1, 0, 1));
        engine.AddSurface("side", new Vector3d(-0.4, 0, 0), new Vector3d(1, 0.1, 0));
        return new GoldenPlay(scene.InWind(-6, 0, -5) with { EngineColliders = engine }, 2) { Move = time => engine.Time = time }.Roll(0.2, 0.2, -1, -2);
    }

    private static GoldenPlay EngineMeshFloor(Scene scene)
    {
        var engine = new GoldenEngine { MaximumSpeed = 1 };
        engine.AddSurface("mesh", default, new Vector3d(0.05, 1, 0), new Vector3d(0, 0, 0.5));
        return new GoldenPlay(scene.InSpace() with { EngineColliders = engine }, 2) { Move = time => engine.Time = time }.Ball(new Vector3d(0, 0.5, 0), new Vector3d(-2, 0, 0), new Vector3d(0, 20, 0));
    }

    private static GoldenPlay EngineTiles(Scene scene)
    {
        var engine = new GoldenEngine();
        engine.Add("tile", Box(-3, -0.2, -2, 0.4, 0, 2), SurfaceMaterial.Wood);
        engine.Add("other tile", Box(0.4, -0.2, -2, 3, 0, 2), SurfaceMaterial.DryTurf);
        return new GoldenPlay(scene.InSpace().InWind(0, 0, -7).With(BoardAlongX(-Radius)) with { EngineColliders = engine }, 1.5) { Move = time => engine.Time = time }.Roll(-1, 0, 2.5, 0);
    }

    private static GoldenPlay Layers(Scene scene)
    {
        var engine = new GoldenEngine();
        engine.Add("ghost", Box(-1, 0, -1.2, 1, 1, -1), SurfaceMaterial.Wood).Layer = 3;
        Obstacle ghost = Thing("other ghost", Box(-1, 0, -1.7, 1, 1, -1.5)) with { Layer = 2 };
        return new GoldenPlay((scene with { Ball = scene.Ball with { Ignores = (1u << 2) | (1u << 3) }, EngineColliders = engine }).With(ghost, BoardAlongX(-2.5)), 1.5)
        {
            Move = time => engine.Time = time,
        }.Roll(0, 0, 0.2, -5);
    }
}
