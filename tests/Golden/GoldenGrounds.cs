using FootballPhysics.Shapes;
using static FootballPhysics.Golden.GoldenObjects;

// Grounds that are not level, nets, and zones.

namespace FootballPhysics.Golden;

internal static class GoldenGrounds
{
    public static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return Slopes().Concat(Nets()).Concat(Zones());
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Slopes()
    {
        yield return ("slope-rest", scene => new GoldenPlay(Slope(scene, 0.03, 0.01), 2.5).Ball(new Vector3d(0, 0.2, 0), new Vector3d(-0.5, 0, 0.2)));
        yield return ("slope-down", scene => new GoldenPlay(Slope(scene, 0.2, 0.1), 2).Ball(new Vector3d(0, 0.2, 0), new Vector3d(-2, 0, 1), new Vector3d(0, 30, 0)));
        yield return ("slope-steep", scene => new GoldenPlay(Slope(scene, 2, 0), 1.2).Ball(new Vector3d(0, 0.3, 0), new Vector3d(-1, 0, 2), new Vector3d(0, 0, 20)));
        yield return ("slope-in-wind", scene => new GoldenPlay(Slope(scene, 0.05, 0).InWind(-7, 0, 3), 2.5).Ball(new Vector3d(0, 0.12, 0), new Vector3d(0, 0, 1)));
        yield return ("slope-with-stripes", scene => new GoldenPlay(scene with { Ground = new Ground { Material = scene.Ground.Material, Normal = new Vector3d(0.1, 1, 0), Pattern = new GoldenStripes() } }, 2)
            .Ball(new Vector3d(0, 0.3, 0), new Vector3d(1, 0, 0.5)));
        yield return ("raised-ground", scene => new GoldenPlay(scene with { Ground = scene.Ground with { Height = 2.5 } }, 2).Ball(new Vector3d(0, 3.5, 0), new Vector3d(4, 1, 0), new Vector3d(0, 20, 30)));
        yield return ("stripes", scene => new GoldenPlay(scene with { Ground = scene.Ground with { Pattern = new GoldenStripes() } }, 2.5).Ball(new Vector3d(0, 0.5, 0), new Vector3d(7, 0, 1), new Vector3d(0, 10, 40)));
        yield return ("hill-roll", scene => new GoldenPlay(scene.OnHills(Hill), 2.5).Ball(new Vector3d(-2.5, 0.6, 0.3), new Vector3d(3.5, 0, 0)));
        yield return ("hill-bounce", scene => new GoldenPlay(scene.OnHills(Hill), 2).Ball(new Vector3d(0.5, 2, 0.3), new Vector3d(1, 0, 2), new Vector3d(20, 10, 0)));
        yield return ("hill-in-wind", scene => new GoldenPlay(scene.OnHills(Hill).InWind(6, 0, -4), 2.5).Ball(new Vector3d(-0.8, 0.8, 0)));
        yield return ("hill-jump", scene => new GoldenPlay(scene.OnHills(Hill), 2).Ball(new Vector3d(-3, 0.5, 0), new Vector3d(9, 0, 0.2), new Vector3d(0, 0, -60)));
        yield return ("dent-rest", scene => new GoldenPlay(scene.OnHills((x, z) => 0.04 * ((x * x) + (2 * z * z))), 2.5).Ball(new Vector3d(0.3, 0.2, 0.1), new Vector3d(0, 0, 0.3)));
        yield return ("valley-slide", scene => new GoldenPlay(scene.OnHills((x, z) => 0.08 * z * z), 2).Ball(new Vector3d(-3, 0.4, 1), new Vector3d(5, 0, -1), new Vector3d(0, 40, 0)));
        yield return ("saddle", scene => new GoldenPlay(scene.OnHills((x, z) => 0.06 * ((x * x) - (z * z))), 2).Ball(new Vector3d(0.5, 0.3, 0.1), new Vector3d(-1, 0, 0)));
        yield return ("hill-and-board", scene => new GoldenPlay(scene.OnHills((x, z) => 0.06 * x * x).InWind(0, 0, -9).With(BoardAlongX(-0.2)), 2.5).Ball(new Vector3d(1.2, 0.3, -0.05), new Vector3d(-1, 0, 0)));
        yield return ("hill-and-corner", scene => new GoldenPlay(scene.OnHills((x, z) => 0.1 * (x + z)).With(BoardAlongX(-0.5), BoardAlongZ(-0.5)), 2.5).Ball(new Vector3d(0.3, 0.4, 0.2)));
        yield return ("hill-with-stripes", scene => new GoldenPlay(scene.OnHills((x, z) => 0.1 * x) is { } hills ? hills with { Ground = hills.Ground with { Pattern = new GoldenStripes() } } : scene, 2)
            .Ball(new Vector3d(2, 0.5, 0), new Vector3d(1, 0, 0.5)));
        yield return ("hill-kicked", scene => new GoldenPlay(scene.OnHills(Hill), 2.5).Ball(new Vector3d(-2.4, 0.6, 0)).Kick(0.8, new Vector3d(4, 2, 0.5), new Vector3d(0, 20, 0)));
        yield return ("mound-obstacle", scene => new GoldenPlay(scene.With(Thing("mound", Hills((x, z) => 0.3 - (0.1 * ((x * x) + (z * z)))), SurfaceMaterial.DryTurf)), 2).Roll(2.5, 0.2, -4.5, 0));
        yield return ("hill-pressed", scene => GoldenSqueezes.Walk(scene.OnHills((x, z) => 0.15 * x), double.PositiveInfinity, new Vector3d(-0.6, 0, 0), new Vector3d(1.2, 0.1, 0), 1).Ball(new Vector3d(0, 0.13, 0)));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Nets()
    {
        yield return ("net-roof-rest", scene => new GoldenPlay(Pitch.Standard.On(scene), 2.5).Ball(new Vector3d(0.5, 2.9, -52.9), new Vector3d(0.3, 0, 0)));
        yield return ("net-roof-rolled-off", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Ball(new Vector3d(3, 2.7, -52.9), new Vector3d(3, 0, 0)));
        yield return ("net-back-slow", scene => new GoldenPlay(Pitch.Standard.On(scene), 2.5).Roll(1, -53.8, 0.3, -2.5));
        yield return ("net-back-fast", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Ball(new Vector3d(-1, 1, -50), new Vector3d(-2, 2, -33), new Vector3d(20, 30, 0)));
        yield return ("net-corner", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Ball(new Vector3d(3, 0.4, -51.5), new Vector3d(4, 3, -20), new Vector3d(0, 40, 0)));
        yield return ("net-side-outside", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Ball(new Vector3d(6, 0.3, -53), new Vector3d(-9, 1, -1), new Vector3d(0, 0, 30)));
        yield return ("net-roof-below", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Ball(new Vector3d(0, 0.3, -52.7), new Vector3d(0.5, 9, -0.2)));
        yield return ("net-kicked-out", scene => new GoldenPlay(Pitch.Standard.On(scene), 2.5).Ball(new Vector3d(1, 0.5, -52), new Vector3d(0, 1, -12)).Kick(1, new Vector3d(2, 3, 6)).Kick(1.6, new Vector3d(-3, 2, -8)));
        yield return ("net-in-wind", scene => new GoldenPlay(Pitch.Standard.On(scene.InWind(2, 0, -12)), 2.5).Roll(1, -54, 0, -1));
        yield return ("net-roll-deep", scene => new GoldenPlay(Pitch.Standard.On(scene), 2).Roll(-1.2, -54.6, 0.1, 0.7));
        yield return ("net-futsal", scene => new GoldenPlay(Pitch.Futsal.On(scene with { Ball = BallProperties.Futsal }), 2).Ball(new Vector3d(0.5, 0.4, -17), new Vector3d(2, 1, -15), new Vector3d(0, 30, 0)));
        yield return ("cage", scene => new GoldenPlay(Pitch.Cage.On(scene), 2).Ball(new Vector3d(8, 0.3, -18), new Vector3d(8, 1, -9), new Vector3d(20, 20, 0)));
        yield return ("nets-crossed", scene => new GoldenPlay(
            scene with { Nets = new[] { Net("a", new Vector3d(0, 1, -1), new Vector3d(0, 0, 1), 400), Net("b", new Vector3d(0.5, 1, 0), new Vector3d(1, 0, 0), 900), Net("c", new Vector3d(0, 1, -1), new Vector3d(1, 0, 2), 200) } }, 2)
            .Ball(new Vector3d(-1, 0.8, 1), new Vector3d(6, 1, -8), new Vector3d(10, 20, 0)));
        yield return ("net-stiff", scene => new GoldenPlay(scene with { Nets = new[] { Net("stiff", new Vector3d(0, 1, -1), new Vector3d(0, 0.3, 1), 20000) } }, 1.5).Ball(new Vector3d(0, 0.5, 1), new Vector3d(0.5, 1, -12)));
        yield return ("net-hammock", scene => new GoldenPlay(
            scene.InSpace() with
            {
                Nets = new[]
                {
                    new Net { Name = "hammock", Center = new Vector3d(0, 1, 0), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), HalfLength = 2, HalfWidth = 2, Stiffness = 60, Damping = 0.5, TangentialDamping = 5 },
                },
            },
            2.5).Ball(new Vector3d(0.1, 1.8, 0), new Vector3d(0.5, 0, 0.2), new Vector3d(0, 20, 0)));
        yield return ("net-and-board", scene => new GoldenPlay(scene.InWind(0, 0, -9).With(BoardAlongX(-1.15)) with { Nets = new[] { Net("net", new Vector3d(0, 1, -1), new Vector3d(0, 0, 1), 40) } }, 2)
            .Ball(new Vector3d(0, 0.3, 0), new Vector3d(2, 1, -9)));
        yield return ("net-walked-in", scene => GoldenSqueezes.Walk(Pitch.Futsal.On(scene), 75, new Vector3d(0.24, 0, -19.4), new Vector3d(0, 0, -2), 0.9).Roll(0.25, -19.9, 0, -0.5));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Zones()
    {
        yield return ("zones-flown-through", scene => new GoldenPlay(Zoned(scene), 1.5).Ball(new Vector3d(0, 1, 2), new Vector3d(1, 4, -9), new Vector3d(20, 20, 0)));
        yield return ("zones-rolled-through", scene => new GoldenPlay(Zoned(scene), 2.5).Roll(0.2, 2, 0.3, -4));
        yield return ("zones-and-board", scene => new GoldenPlay(Zoned(scene).InWind(0, 0, -9).With(BoardAlongX(-2)), 2).Roll(-1.5, 0, 3, -3));
        yield return ("zones-bounced-through", scene => new GoldenPlay(Zoned(scene), 2).Ball(new Vector3d(0.3, 2, 0.3), new Vector3d(0.1, 0, -1), new Vector3d(0, 10, 0)));
        yield return ("zones-carried-through", scene => new GoldenPlay(Zoned(scene).InSpace().With(Thing("belt", Box(-20, -1, -20, 20, 0, 20), SurfaceMaterial.DryTurf, new Vector3d(0.2, 0, -2))), 2.5).Ball(new Vector3d(0, Radius, 1)));
        yield return ("zones-pressed-through", scene => GoldenSqueezes.Walk(Zoned(scene).With(BoardAlongX(-1.5)), 75, new Vector3d(0.04, 0, 1.2), new Vector3d(0, 0, -1.6), 1.4).Roll(0, 0.6, 0, 0));
        yield return ("zones-at-goal", scene => new GoldenPlay(
            Pitch.Standard.On(scene) with { Zones = new[] { Zone("mouth", Box(-3.7, 0, -54, 3.7, 2.5, -52.5), ZonePart.Center), Zone("low", Plane(0, 0.5, 0, 0, 1, 0), ZonePart.Ball) } }, 2)
            .Ball(new Vector3d(1, 0.4, -50), new Vector3d(0.5, 4, -14)).Kick(1.2, new Vector3d(0, 2, 7)));
        yield return ("zone-ignored", scene => new GoldenPlay(
            scene with { Ball = scene.Ball with { Ignores = 2 }, Zones = new[] { Zone("near", Box(-2, 0, -1, 2, 2, 1), ZonePart.Ball) with { Layer = 1 }, Zone("far", new SphereShape(new Vector3d(0, 0, -2), 0.5), ZonePart.Ball) } }, 1.5)
            .Roll(0, 2, 0, -5));
        yield return ("zones-on-hill", scene => new GoldenPlay(Zoned(scene).OnHills((x, z) => 0.05 * z), 2).Ball(new Vector3d(0, 0.4, 2), new Vector3d(0, 0, -3)));
    }

    private static double Hill(double x, double z)
    {
        return 0.8 / (1 + (0.4 * ((x * x) + (z * z))));
    }

    private static Scene Slope(Scene scene, double x, double z)
    {
        return scene with { Ground = new Ground { Material = scene.Ground.Material, Aerodynamics = scene.Ground.Aerodynamics, Normal = new Vector3d(x, 1, z) } };
    }

    private static Net Net(string name, Vector3d center, Vector3d normal, double stiffness)
    {
        return new Net { Name = name, Center = center, Normal = normal, Along = Vector3d.Cross(Vector3d.Up, normal), HalfLength = 2, HalfWidth = 1, Stiffness = stiffness };
    }

    private static Scene Zoned(Scene scene)
    {
        return scene with
        {
            Zones = new[]
            {
                Zone("box", Box(-2, 0, -1, 2, 2, 0), ZonePart.Ball),
                Zone("sphere", new SphereShape(new Vector3d(0, 0, -1), 0.6), ZonePart.Center),
                Zone("rod", new CapsuleShape(new Vector3d(-2, 0.2, 1), new Vector3d(2, 0.3, 0.8), 0.1), ZonePart.Ball),
                Zone("above", Plane(0, 0.6, 0, 0, -1, 0.1), ZonePart.Center),
            },
        };
    }

    private static Zone Zone(string name, IShape shape, ZonePart part)
    {
        return new Zone { Name = name, Shape = shape, Of = part };
    }
}
