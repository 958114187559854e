using FootballPhysics.Shapes;
using static FootballPhysics.Golden.GoldenObjects;

// Contact sets of objects that do not move: boards, corners, gutters, wedges, rails, kerbs, tiles.

namespace FootballPhysics.Golden;

internal static class GoldenContacts
{
    public static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return AtBoards().Concat(InGutters()).Concat(OverEdges());
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> AtBoards()
    {
        yield return ("board-touched", scene => new GoldenPlay(scene.With(BoardAlongX(-Radius)), 2).Roll(0, 0, 4, 0));
        yield return ("board-in-wind", scene => new GoldenPlay(scene.InWind(3, 0, -9).With(BoardAlongX(-Radius)), 2).Roll(0, 0, 4, 0));
        yield return ("board-slid-along", scene => new GoldenPlay(scene.InWind(0, 0, -14).With(BoardAlongX(-Radius)), 2)
            .Ball(new Vector3d(0, Radius, 0), new Vector3d(14, 0, 0), new Vector3d(40, 30, 20)));
        yield return ("board-end", scene => new GoldenPlay(scene.InWind(0, 0, -9).With(BoardAlongX(-Radius, -5, 1.5)), 2).Roll(0, 0, 2.5, 0));
        yield return ("board-met-in-roll", scene => new GoldenPlay(scene.InWind(0, 0, -12).With(BoardAlongX(-1)), 2.5).Roll(0, 0, 2, -0.8));
        yield return ("board-of-glass", scene => new GoldenPlay(scene.InWind(-2, 0, -10).With(Thing("board", Box(-50, 0, -1, 50, 1, -Radius), Smooth)), 2).Roll(0, 0, 3, 0));
        yield return ("corner", scene => new GoldenPlay(scene.InWind(-8, 0, -7).With(BoardAlongX(-0.5), BoardAlongZ(-0.5)), 2.5).Roll(-0.1, 0, -0.4, -1.2));
        yield return ("corner-hit", scene => new GoldenPlay(scene.With(BoardAlongX(-1), BoardAlongZ(-1)), 2)
            .Ball(new Vector3d(0.4, 0.3, 0.6), new Vector3d(-9, 1, -8), new Vector3d(10, -40, 25)));
        yield return ("corner-spin", scene => new GoldenPlay(scene.InWind(-9, 0, -9).With(BoardAlongX(-Radius), BoardAlongZ(-Radius)), 2.5)
            .Ball(new Vector3d(0, Radius, 0), default, new Vector3d(0, 60, 0)));
        yield return ("corner-kicked", scene => new GoldenPlay(scene.InWind(-6, 0, -6).With(BoardAlongX(-Radius), BoardAlongZ(-Radius)), 2)
            .Ball(new Vector3d(0, Radius, 0)).Kick(0.5, new Vector3d(-3, 0.5, -2), new Vector3d(0, 30, 0)).Kick(1.2, new Vector3d(1, 0, -1)));
        yield return ("corner-sharp", scene => new GoldenPlay(scene.InWind(-9, 0, 0).With(BoardAlongX(-0.3), Thing("leaning board", Plane(-0.5, 0, -0.3, 1, 0, 2))), 2.5).Roll(0.6, 0, -1.5, -0.6));
        yield return ("corner-beach-ball", scene => new GoldenPlay((scene with { Ball = BallProperties.BeachBall }).InWind(-5, 0, -4).With(BoardAlongX(-0.6), BoardAlongZ(-0.6)), 2).Roll(0, 0, -1, -2));
        yield return ("slot", scene => new GoldenPlay(scene.With(BoardAlongX(-Radius), Thing("far board", Box(-50, 0, Radius, 50, 1, 0.3))), 2).Roll(0, 0, 3, 0));
        yield return ("slot-spin", scene => new GoldenPlay(scene.InWind(5, 0, 2).With(BoardAlongX(-Radius), Thing("far board", Box(-50, 0, Radius, 50, 1, 0.3))), 2)
            .Ball(new Vector3d(0, Radius, 0), new Vector3d(6, 0, 0), new Vector3d(0, 50, 30)));
        yield return ("slot-narrowing", scene => new GoldenPlay(scene.With(Thing("left", Plane(0, 0, -0.2, 0.05, 0, 1)), Thing("right", Plane(0, 0, 0.2, 0.05, 0, -1))), 2).Roll(1.5, 0.1, -5, 0));
        yield return ("nook", scene => new GoldenPlay(
            scene.InWind(4, 0, -9).With(BoardAlongX(-Radius), Thing("post", new CapsuleShape(new Vector3d(1, 0, -0.1), new Vector3d(1, 2, -0.1), 0.06))), 2).Roll(0, 0, 2, 0));
        yield return ("between-posts", scene => new GoldenPlay(
            scene.InWind(9, 0, 0).With(
                Thing("post", new CapsuleShape(new Vector3d(1, 0, -0.15), new Vector3d(1, 2, -0.15), 0.06)),
                Thing("other post", new CapsuleShape(new Vector3d(1, 0, 0.15), new Vector3d(1, 2, 0.15), 0.06))),
            2.5).Roll(0, 0.02, 2, 0));
        yield return ("ceiling", scene => new GoldenPlay(scene.With(Thing("ceiling", Box(-5, 0.26, -5, 5, 0.5, 5))), 1.5)
            .Ball(new Vector3d(0, 0.13, 0), new Vector3d(3, 4, 1), new Vector3d(0, 20, 40)));
        yield return ("bumpers", scene => new GoldenPlay(
            scene.With(Thing("bumper", Box(-50, 0, -1, 50, 1, -0.4), SurfaceMaterial.Board with { MinimumExitSpeed = 3 }), BoardAlongZ(-0.4), Thing("far board", Box(-50, 0, 0.4, 50, 1, 1))), 2)
            .Roll(0, 0, -1, -2));
        yield return ("tilted-board", scene => new GoldenPlay(
            (scene with { Ground = new Ground { Material = scene.Ground.Material, Aerodynamics = scene.Ground.Aerodynamics, Normal = new Vector3d(0.03, 1, -0.12) } })
                .With(BoardAlongX(-1), Thing("stop", Box(2, 0, -2, 2.2, 1, 2))),
            3).Ball(new Vector3d(0, 0.2, 0), new Vector3d(1, 0, 0)));
        yield return ("pattern-board", scene => new GoldenPlay(
            (scene with { Ground = scene.Ground with { Pattern = new GoldenStripes() } }).InWind(0, 0, -8).With(BoardAlongX(-0.3)), 2).Roll(0, 0, 6, -0.5));
        yield return ("heuristic-board", scene => new GoldenPlay(scene.InWind(0, 0, -9).With(BoardAlongX(-0.4)), 2)
        {
            Settings = new SolverSettings { CollisionTiming = CollisionTiming.Bisection, RollingTransition = RollingTransition.Heuristic },
        }.Ball(new Vector3d(0, 0.5, 0), new Vector3d(5, 1, -3), new Vector3d(0, 20, 0)));
    }

    // Two planes that meet along x, or along a line that falls; no ground.
    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> InGutters()
    {
        yield return ("gutter-rough", scene => Gutter(scene, Rough, 0.1, 1).Ball(new Vector3d(0, 0.17, 0)));
        yield return ("gutter-slip", scene => Gutter(scene, SurfaceMaterial.GoalFrame with { SlidingFriction = 0.08 }, 0.3, 1).Ball(new Vector3d(0, 0.17, 0), new Vector3d(1, 0, 0), new Vector3d(20, 30, -30)));
        yield return ("gutter-smooth", scene => Gutter(scene, Smooth, 0.2, 1).Ball(new Vector3d(0, 0.2, 0.03), new Vector3d(1, 0, 0.3), new Vector3d(0, 20, 0)));
        yield return ("gutter-level", scene => Gutter(scene, SurfaceMaterial.Wood, 0, 1).Ball(new Vector3d(0, 0.16, 0), new Vector3d(3, 0, 0.4)));
        yield return ("gutter-flat", scene => Gutter(scene, SurfaceMaterial.Wood, 0.05, 0.3).Ball(new Vector3d(0, 0.16, 0.2), new Vector3d(2, 0, -0.5)));
        yield return ("gutter-wind", scene => Gutter(scene.InWind(6, 0, 7), SurfaceMaterial.Board, 0, 0.7).Ball(new Vector3d(0, 0.15, 0), new Vector3d(-2, 0, 0)));
        yield return ("gutter-medicine-ball", scene => Gutter(scene with { Ball = BallProperties.MedicineBall }, SurfaceMaterial.Wood, 0.1, 0.8).Ball(new Vector3d(0, 0.2, 0), new Vector3d(2, 0, 0), new Vector3d(0, 0, 30)));
        yield return ("gutter-uneven", scene => new GoldenPlay(
            scene.InSpace().With(Thing("steep", Plane(0, 0, 0, -0.1, 1, 2), SurfaceMaterial.GoalFrame), Thing("flat", Plane(0, 0, 0, -0.1, 1, -0.4), SurfaceMaterial.DryTurf)), 2)
            .Ball(new Vector3d(0, 0.17, 0), new Vector3d(2, 0, 0)));
        yield return ("gutter-bend", scene => new GoldenPlay(
            scene.InSpace().With(Thing("floor", Plane(0, 0, 0, -0.2, 1, 0), SurfaceMaterial.Wood), Thing("wall", Plane(0, 0, -0.2, 0, 0, 1)), Thing("turn", Plane(1.5, 0, 0, -1, 0, 0.8))), 2.5)
            .Ball(new Vector3d(0, 0.13, 0), new Vector3d(-1, 0, -0.5)));
        yield return ("trough", scene => new GoldenPlay(
            scene.InSpace().With(
                Thing("left", Plane(0, 0, 0, -0.15, 1, 1), SurfaceMaterial.Wood),
                Thing("right", Plane(0, 0, 0, -0.15, 1, -1), SurfaceMaterial.Wood),
                Thing("end", Plane(-0.7, 0, 0, 1, 0.2, 0))),
            2.5).Ball(new Vector3d(0, 0.2, 0), new Vector3d(0.5, 0, 0)));
        yield return ("wedge", scene => new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0, 0.4, 1), Rough), Thing("right", Plane(0, 0, 0, 0, 0.4, -1), Rough)), 1.5)
            .Ball(new Vector3d(0, 0.6, 0.02), new Vector3d(0.5, -1, 0), new Vector3d(0, 5, 10)));
        yield return ("wedge-rest", scene => new GoldenPlay(
            scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0, 0.5, 1), SurfaceMaterial.DryTurf), Thing("right", Plane(0, 0, 0, 0, 0.8, -1), SurfaceMaterial.Glove)), 1.5)
            .Ball(new Vector3d(0, 0.25, 0.01)));
        yield return ("funnel", scene => new GoldenPlay(
            scene.InSpace().With(
                Thing("a", Plane(0, 0, 0, 1, 1, 0)), Thing("b", Plane(0, 0, 0, -1, 1, 0.2)), Thing("c", Plane(0, 0, 0, 0, 1, 1)), Thing("d", Plane(0, 0, 0, 0.1, 1, -1))), 2.5)
            .Ball(new Vector3d(0.1, 0.4, -0.1), new Vector3d(0.3, 0, 0.5), new Vector3d(0, 30, 0)));
        yield return ("funnel-of-six", scene => new GoldenPlay(
            scene.InSpace().With(
                Thing("a", Plane(0, 0, 0, 1, 1, 0)), Thing("b", Plane(0, 0, 0, -1, 1, 0)), Thing("c", Plane(0, 0, 0, 0.5, 1, 0.75)),
                Thing("d", Plane(0, 0, 0, -0.5, 1, 0.75)), Thing("e", Plane(0, 0, 0, 0.5, 1, -0.75)), Thing("f", Plane(0, 0, 0, -0.5, 1, -0.75))), 2)
            .Ball(new Vector3d(0.05, 0.3, -0.02), new Vector3d(0.2, 0, 0.1), new Vector3d(0, 20, 0)));
        yield return ("three-spheres", scene => new GoldenPlay(
            scene.InSpace().With(
                Thing("a", new SphereShape(new Vector3d(0.2, 0, 0), 0.15)), Thing("b", new SphereShape(new Vector3d(-0.1, 0, 0.17), 0.15)), Thing("c", new SphereShape(new Vector3d(-0.1, 0, -0.17), 0.15))), 2)
            .Ball(new Vector3d(0.01, 0.4, 0.02), default, new Vector3d(5, 20, 0)));
        yield return ("rails", scene => new GoldenPlay(
            scene.With(
                Thing("rail", new CapsuleShape(new Vector3d(-2, 0.2, -0.08), new Vector3d(1, 0.2, -0.08), 0.02), SurfaceMaterial.GoalFrame),
                Thing("other rail", new CapsuleShape(new Vector3d(-2, 0.2, 0.08), new Vector3d(1, 0.2, 0.08), 0.02), SurfaceMaterial.GoalFrame)), 2)
            .Ball(new Vector3d(-1, 0.32, 0.01), new Vector3d(2.5, 0, 0)));
        yield return ("rails-uphill", scene => new GoldenPlay(
            scene.With(
                Thing("rail", new CapsuleShape(new Vector3d(-2, 0.1, -0.09), new Vector3d(3, 0.5, -0.05), 0.02), SurfaceMaterial.GoalFrame),
                Thing("other rail", new CapsuleShape(new Vector3d(-2, 0.1, 0.09), new Vector3d(3, 0.5, 0.05), 0.02), SurfaceMaterial.GoalFrame)), 2.5)
            .Ball(new Vector3d(-1, 0.29, 0), new Vector3d(2, 0, 0), new Vector3d(0, 0, -25)));
        yield return ("pipe", scene => new GoldenPlay(scene.InSpace().With(Thing("pipe", new GoldenPipe(new Vector3d(0, 0.6, 0), 0.6), SurfaceMaterial.Wood)), 2)
            .Ball(new Vector3d(0, 0.12, 0.05), new Vector3d(2, 0, 2)));
        yield return ("pipe-end", scene => new GoldenPlay(
            scene.InSpace().InWind(7, 0, 0).With(Thing("pipe", new GoldenPipe(new Vector3d(0, 0.5, 0), 0.5)), Thing("end", Plane(1, 0, 0, -1, 0, 0.1))), 2.5)
            .Ball(new Vector3d(0, 0.12, 0.05), new Vector3d(1, 0, 0.5)));
        yield return ("bowl", scene => new GoldenPlay(scene.InSpace().With(Thing("bowl", new GoldenBowl(new Vector3d(0, 0.8, 0), 0.8), SurfaceMaterial.Wood)), 2.5)
            .Ball(new Vector3d(0.2, 0.2, 0), new Vector3d(0, 0, 1.5), new Vector3d(0, 10, 0)));
        yield return ("bowl-and-floor", scene => new GoldenPlay(scene.With(Thing("bowl", new GoldenBowl(new Vector3d(0, 0.5, 0), 0.6), SurfaceMaterial.Wood)), 2.5)
            .Ball(new Vector3d(0.1, 0.2, 0), new Vector3d(0, 0, 2.5), new Vector3d(0, -20, 0)));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> OverEdges()
    {
        yield return ("kerb-down", scene => new GoldenPlay(scene.With(Thing("kerb", Box(-5, 0, -5, 0.5, 0.12, 5), SurfaceMaterial.Concrete)), 2)
            .Ball(new Vector3d(0, 0.12 + Radius, 0), new Vector3d(0.8, 0, 0.2), new Vector3d(2, 0, -7)));
        yield return ("kerb-down-slowly", scene => new GoldenPlay(scene.With(Thing("kerb", Box(-5, 0, -5, 0.1, 0.3, 5), SurfaceMaterial.Concrete)), 1.5)
            .Ball(new Vector3d(0, 0.3 + Radius, 0), new Vector3d(0.35, 0, 0), new Vector3d(0, 0, -3)));
        yield return ("kerb-up", scene => new GoldenPlay(scene.With(Thing("kerb", Box(0.5, 0, -5, 5, 0.03, 5), SurfaceMaterial.Concrete)), 2).Roll(0, 0, 4, 0.5));
        yield return ("kerb-along", scene => new GoldenPlay(scene.InWind(0, 0, -12).With(Thing("kerb", Box(-5, 0, -1, 5, 0.05, -0.2), SurfaceMaterial.Concrete)), 2).Roll(0, 0, 2, -0.6));
        yield return ("tiles", scene => new GoldenPlay(
            scene.InSpace().With(Thing("tile", Box(-2, -0.1, -2, 0.3, 0, 2), SurfaceMaterial.Wood), Thing("wet tile", Box(0.3, -0.1, -2, 3, 0, 2), SurfaceMaterial.WetTurf)), 2)
            .Ball(new Vector3d(-1, Radius, 0), new Vector3d(3, 0, 0.5), new Vector3d(0, 20, 0)));
        yield return ("tiles-and-board", scene => new GoldenPlay(
            scene.InSpace().InWind(0, 0, -9).With(
                Thing("tile", Box(-2, -0.1, -2, 0.3, 0, 2), SurfaceMaterial.Wood), Thing("wet tile", Box(0.3, -0.1, -2, 3, 0, 2), SurfaceMaterial.WetTurf), BoardAlongX(-Radius)), 2)
            .Roll(-1, 0, 2, 0));
        yield return ("tile-on-turf", scene => new GoldenPlay(scene.With(Thing("tile", Box(0, -0.1, -2, 1, 0, 2), SurfaceMaterial.Concrete)), 2).Roll(-0.5, 0, 3, 0));
        yield return ("seam-run-along", scene => new GoldenPlay(
            scene.InSpace().With(Thing("tile", Box(-5, -0.1, -2, 5, 0, 0), SurfaceMaterial.Wood), Thing("other tile", Box(-5, -0.1, 0, 5, 0, 2), SurfaceMaterial.Concrete)), 2)
            .Ball(new Vector3d(-1, Radius, 0), new Vector3d(2, 0, 0)));
        yield return ("ball-on-sphere", scene => new GoldenPlay(scene.With(Thing("dome", new SphereShape(new Vector3d(0, -0.5, 0), 1), SurfaceMaterial.Concrete)), 2)
            .Ball(new Vector3d(0.02, 0.62, 0.01), new Vector3d(0.1, 0, 0)));
        yield return ("capsule-and-turf", scene => new GoldenPlay(
            scene.InWind(-12, 0, 0).With(Thing("log", new CapsuleShape(new Vector3d(-0.5, 0.03, -3), new Vector3d(-0.5, 0.03, 3), 0.06), SurfaceMaterial.Wood)), 2).Roll(0, 0, -1, 1));
        yield return ("post-run-into", scene => new GoldenPlay(Pitch.Standard.On(scene), 1.5).Roll(3.7, -51, 0.1, -5));
        yield return ("crossbar-top", scene => new GoldenPlay(Pitch.Standard.On(scene), 1.5).Ball(new Vector3d(0, 2.7, -52.45), new Vector3d(0, -1, -0.3), new Vector3d(3, 0, 0)));
        yield return ("rotated-box", scene => new GoldenPlay(
            scene.InWind(-6, 0, -3).With(Thing("crate", new BoxShape(new Vector3d(-0.7, 0.3, 0), new Vector3d(0.4, 0.5, 1), new Quaterniond(0.1, 0.3, 0.2, 0.9)))), 2).Roll(0.3, 0, -1.5, 0.2));
    }

    private static GoldenPlay Gutter(Scene scene, SurfaceMaterial surface, double fall, double steepness)
    {
        return new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, fall, 1, steepness), surface), Thing("right", Plane(0, 0, 0, fall, 1, -steepness), surface)), 2);
    }
}
