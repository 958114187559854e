using FootballPhysics.Laws;
using FootballPhysics.Prediction;
using FootballPhysics.Shapes;
using static FootballPhysics.Golden.GoldenObjects;

// The rest of a step's code: integrators of order 1, the drag law's jump, states that are restored or continue in another scene, crowds, and look-aheads among objects.

namespace FootballPhysics.Golden;

internal static class GoldenRest
{
    public static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return FirstOrder().Concat(Restored()).Concat(Crowds());
    }

    /// <summary>The hashes of look-aheads among objects that move or can be pushed.</summary>
    public static IEnumerable<KeyValuePair<string, ulong>> Looks()
    {
        yield return GoldenShots.Named("look vacuum", Look(Scene.Vacuum.With(Thing("crate", Box(3, 0, -1, 3.4, 1, 1), SurfaceMaterial.Wood, default, default, 5), BoardAlongZ(-2)), StopAt.Rest, false));
        yield return GoldenShots.Named("look crate", Look(GoldenGames.Plain.With(Thing("crate", Box(3, 0, -1, 3.4, 1, 1), SurfaceMaterial.Wood, default, new Vector3d(0, 1, 0), 5), BoardAlongZ(-2)), StopAt.Rest, false));
        yield return GoldenShots.Named("look net", Look(GoldenGames.Plain with { Goals = new[] { new Goal { Center = new Vector3d(4, 0, 0), Facing = new Vector3d(-1, 0, 0) } } }, StopAt.Time, false));
        yield return GoldenShots.Named("look group", Look(GoldenGames.Plain.With(Thing("crate", Box(3, 0, -1, 3.4, 1, 1), SurfaceMaterial.Wood, default, default, 5)), StopAt.Time, true));
        yield return GoldenShots.Named("look group published", Look(Scene.Published.InWind(-5, 0, 0).With(BoardAlongZ(-0.4)), StopAt.Rest, true));
        yield return GoldenShots.Named("run", Run(GoldenGames.Plain.With(BoardAlongX(-1))));
        yield return GoldenShots.Named("run published", Run(Scene.Published.With(BoardAlongX(-1))));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> FirstOrder()
    {
        yield return ("euler-board", scene => Low(new GoldenPlay(scene.InWind(0, 0, -9).With(BoardAlongX(-0.3)), 2), Integrator.Euler).Ball(new Vector3d(0, 0.3, 0), new Vector3d(4, 1, -2), new Vector3d(0, 30, 0)));
        yield return ("semi-board", scene => Low(new GoldenPlay(scene.InWind(0, 0, -9).With(BoardAlongX(-0.3)), 2), Integrator.SemiImplicitEuler).Ball(new Vector3d(0, 0.3, 0), new Vector3d(4, 1, -2), new Vector3d(0, 30, 0)));
        yield return ("euler-gutter", scene => Low(new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0.1, 1, 0.8)), Thing("right", Plane(0, 0, 0, 0.1, 1, -0.8))), 2), Integrator.Euler).Ball(new Vector3d(0, 0.17, 0)));
        yield return ("semi-gutter", scene => Low(new GoldenPlay(scene.InSpace().With(Thing("left", Plane(0, 0, 0, 0.1, 1, 0.8)), Thing("right", Plane(0, 0, 0, 0.1, 1, -0.8))), 2), Integrator.SemiImplicitEuler).Ball(new Vector3d(0, 0.17, 0)));
        yield return ("euler-heap", scene => Low(new GoldenPlay(scene.InWind(0, 0, -8).With(BoardAlongX(-0.15)), 2), Integrator.Euler).Roll(0, 0, 0, 0).Roll(0.02, 0.23, 0, -1).Ball(new Vector3d(0, 0.4, 0.1)));
        yield return ("semi-heap", scene => Low(new GoldenPlay(scene.InWind(0, 0, -8).With(BoardAlongX(-0.15)), 2), Integrator.SemiImplicitEuler).Roll(0, 0, 0, 0).Roll(0.02, 0.23, 0, -1).Ball(new Vector3d(0, 0.4, 0.1)));
        yield return ("euler-hill", scene => Low(new GoldenPlay(scene.OnHills((x, z) => 0.05 * ((x * x) + (z * z))), 2), Integrator.Euler).Ball(new Vector3d(1.2, 0.6, 0), new Vector3d(0, 0, 1)));
        yield return ("euler-net", scene => Low(new GoldenPlay(Pitch.Standard.On(scene), 2), Integrator.Euler).Ball(new Vector3d(1, 0.5, -52), new Vector3d(0.5, 1, -12), new Vector3d(0, 20, 0)));
        yield return ("euler-bounces", scene => Low(new GoldenPlay(scene with { Ground = Ground.Of(SurfaceMaterial.Concrete with { NormalRestitution = 0.95 }) }, 2), Integrator.Euler).Ball(new Vector3d(0, 0.16, 0), new Vector3d(1, 0, 0)));

        // A force holds the ball at the speed at which the published drag jumps.
        yield return ("jump-held", _ => new GoldenPlay(Pushed(0.9, 0), 2).Ball(new Vector3d(0, 3, 0), new Vector3d(11.5, 0, 0), new Vector3d(0, 20, 0)));
        yield return ("jump-held-and-turned", _ => new GoldenPlay(Pushed(0.7, 0.6), 2).Ball(new Vector3d(0, 3, 0), new Vector3d(12.6, 0, 1), new Vector3d(3, 10, 0)));
        yield return ("jump-crossed-in-slide", _ => new GoldenPlay(Scene.Published, 1.5).Ball(new Vector3d(0, Radius, 0), new Vector3d(0, 0, 12.19209997778575), new Vector3d(-5.4196, 27.4258, -4.1341)));
        yield return ("jump-crossed-on-board", _ => new GoldenPlay(Scene.Published.InSpace().With(Thing("board", Box(-50, -1, -50, 50, 0, 50), SurfaceMaterial.PublishedTurf)), 1.5)
            .Ball(new Vector3d(0, Radius, 0), new Vector3d(0, 0, 12.3), new Vector3d(8, 20, -7)));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Restored()
    {
        yield return ("restored-in-flight", scene => new GoldenPlay(Pitch.Standard.On(scene), 1.5) { Restores = true }.Ball(new Vector3d(1, Radius, -35), new Vector3d(1, 5, -20), new Vector3d(0, 30, 0)));
        yield return ("restored-in-net", scene => new GoldenPlay(Pitch.Standard.On(scene), 2) { Restores = true }.Ball(new Vector3d(1, 1, -51), new Vector3d(1, 2, -15), new Vector3d(0, 30, 0)));
        yield return ("restored-in-corner", scene => new GoldenPlay(scene.InWind(-8, 0, -6).With(BoardAlongX(-0.4), BoardAlongZ(-0.4)), 1.5) { Restores = true }.Roll(0, 0, -1, -1));
        yield return ("restored-on-belt", scene => new GoldenPlay(scene.InSpace().With(Thing("belt", Box(-20, -1, -20, 20, 0, 20), SurfaceMaterial.DryTurf, new Vector3d(1, 0, 0))), 2) { Restores = true }.Ball(new Vector3d(0, Radius, 0)));
        yield return ("restored-heap", scene => new GoldenPlay(scene.InWind(0, 0, -6).With(BoardAlongX(-0.2)), 1.5) { Restores = true }.Roll(0, 0, 0, 0).Roll(0.03, 0.24, 0, -1).Ball(new Vector3d(0, 0.4, 0.1)));
        yield return ("restored-with-player", RestoredWithPlayer);
        yield return ("scene-changes-in-net", scene => new GoldenPlay(Pitch.Standard.On(scene), 2) { Then = Pitch.Standard.On(scene.InWind(0, 0, -15)) }.Ball(new Vector3d(1, 1, -51), new Vector3d(1, 1, -9)));
        yield return ("scene-changes-at-rest", scene => new GoldenPlay(scene.With(BoardAlongX(-0.3)), 2) { Then = scene.InWind(0, 0, 9) }.Roll(0, 0, 0.4, 0));
        yield return ("scene-changes-on-roof", scene => new GoldenPlay(Pitch.Standard.On(scene), 2.5) { Then = Pitch.Standard.On(scene.InWind(1, 0, 0)) }.Ball(new Vector3d(0.5, 2.62, -52.9)));
        yield return ("scene-changes-at-board", scene => new GoldenPlay(scene.InWind(0, 0, -9).With(BoardAlongX(-0.3)), 2) { Then = scene.InWind(2, 0, -3).With(BoardAlongX(-0.35), BoardAlongZ(1)) }.Roll(0, 0, 1, -0.5));
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Crowds()
    {
        yield return ("crowd-of-ten", scene => Crowd(scene, 10, 0.5));
        yield return ("crowd-of-eighteen", scene => Crowd(scene, 18, 0.3));
        yield return ("cage-of-rods", CageOfRods);
        yield return ("support-withdrawn", SupportWithdrawn);
        yield return ("engine-rotor-stops", EngineRotorStops);
        yield return ("pile-over-line", scene => new GoldenPlay(scene with { Goals = new[] { new Goal { Center = new Vector3d(0, 0, -2), Facing = new Vector3d(0, 0, 1) } } }, 2).Roll(-Radius, -1, 0, -4).Roll(Radius, -1, 0, -4));
        yield return ("own-force-alone", scene => new GoldenPlay(
            (scene with { Forces = scene.Forces with { CustomForces = new[] { IForce.From(ball => new Vector3d(-1, 0, -1.2 * ball.Position.Z)) } } }).With(BoardAlongX(-0.4), BoardAlongZ(-0.4)), 1.5)
        { IsGroup = true }
            .Roll(0, 0.3, 0, 0));
        yield return ("own-force-pair", scene => new GoldenPlay(
            (scene with { Forces = scene.Forces with { CustomForces = new[] { IForce.From(ball => new Vector3d(-2 * ball.Position.X, 0, -2 * ball.Position.Z)) } } }).With(BoardAlongX(-0.4)), 2)
            .Roll(0, 0.5, 0, 0).Roll(0.5, -0.1, 0, 0));
        yield return ("net-floor", scene => new GoldenPlay(
            scene with { Nets = new[] { new Net { Name = "carpet", Center = new Vector3d(0, 0.05, 0), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), HalfLength = 2, HalfWidth = 2, Stiffness = 100 } } }, 2)
            .Ball(new Vector3d(0, 0.6, 0), new Vector3d(1, 0, 0.3)));
        yield return ("heap-on-net-floor", scene => new GoldenPlay(
            scene with { Nets = new[] { new Net { Name = "carpet", Center = new Vector3d(0, 0.4, 0), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), HalfLength = 2, HalfWidth = 2, Stiffness = 100 } } }, 2)
            .Ball(new Vector3d(0, 0.6, 0)).Ball(new Vector3d(0.1, 0.9, 0.02)).Ball(new Vector3d(-0.15, 0.7, 0.1)));
    }

    private static GoldenPlay Low(GoldenPlay play, Integrator integrator)
    {
        play.Integrator = integrator;
        return play;
    }

    // No weight; the force is across and along the way of the ball.
    private static Scene Pushed(double along, double across)
    {
        IForce push = IForce.From(ball => new Vector3d(along, 0, across));
        return Scene.Published with { Gravity = 0, Forces = ForceSet.Published with { CustomForces = new[] { push } } };
    }

    // Directions with rational components, about evenly around the vertical axis.
    private static Vector3d Around(int i, int count)
    {
        double turn = 4.0 * i / count;
        double t = turn - Math.Floor(turn);
        double x = (1 - (t * t)) / (1 + (t * t));
        double z = 2 * t / (1 + (t * t));
        int quarter = (int)Math.Floor(turn);
        return quarter == 0 ? new Vector3d(x, 0, z) : quarter == 1 ? new Vector3d(-z, 0, x) : quarter == 2 ? new Vector3d(-x, 0, -z) : new Vector3d(z, 0, -x);
    }

    private static GoldenPlay Crowd(Scene scene, int count, double until)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < count; i++)
        {
            bodies.Add("leg", new CapsuleShape(new Vector3d(0, 0.04, 0), new Vector3d(0, 0.9, 0), 0.04), SurfaceMaterial.Boot, i % 3 == 0 ? 20 : double.PositiveInfinity);
        }

        return new GoldenPlay(scene with { Bodies = bodies }, 1)
        {
            // They stand still about the ball at 0.16 m.
            Move = time =>
            {
                for (int i = 0; i < count; i++)
                {
                    Vector3d way = Around(i, count);
                    double far = 0.16 + (0.5 * Math.Max(0, until - time));
                    bodies[i].MoveTo(far * way, time < until ? -0.5 * way : default, time);
                }
            },
        }.Roll(0.01, 0.005, 0.05, 0);
    }

    private static ulong Look(Scene scene, StopAt stopAt, bool isGroup)
    {
        var request = new LookAheadRequest { Duration = 2.5, TimeStep = GoldenGames.Frame, StopAt = stopAt };
        var simulator = new Simulator(scene);
        var states = new[] { simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(7, 2, 0.2), new Vector3d(0, 20, 0)), simulator.Launch(new Vector3d(-0.5, Radius, 0.3), new Vector3d(3, 0, -0.4), default) };
        var paths = new[] { new Trajectory(), new Trajectory() };
        if (isGroup)
        {
            new BallGroup(simulator, 2).LookAhead(states, request, paths);
        }
        else
        {
            simulator.LookAhead(states[0], request, paths[0]);
            simulator.LookAhead(states[1], request, paths[1]);
        }

        ulong hash = 0;
        foreach (Trajectory path in paths)
        {
            for (int i = 0; i <= 25; i++)
            {
                Vector3d point = path.PositionAt(0.1 * i);
                GoldenTrace.Add(point);
                hash = GoldenShots.Mix(hash, point);
            }

            hash = GoldenShots.Mix(GoldenShots.Mix(hash, path.Final.Velocity), (ulong)path.Events.Count);
        }

        return hash;
    }

    private static ulong Run(Scene scene)
    {
        var simulator = new Simulator(scene);
        var group = new BallGroup(simulator, 2);
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(3, 2, -2), new Vector3d(0, 20, 0));
        BallState[] balls = { ball, simulator.Launch(new Vector3d(0.3, Radius, -0.5), default, default) };
        ulong hash = 0;
        foreach (StopAt stopAt in new[] { StopAt.Impact, StopAt.Impact, StopAt.Rest })
        {
            simulator.Run(ref ball, GoldenGames.Frame, 2, stopAt, log);
            group.Run(balls, GoldenGames.Frame, 2, stopAt, log);
            foreach (BallState state in new[] { ball, balls[0], balls[1] })
            {
                GoldenTrace.Add(state.Position);
                hash = GoldenShots.Mix(GoldenShots.Mix(hash, state.Position), state.Velocity);
            }
        }

        return hash;
    }

    private static GoldenPlay RestoredWithPlayer(Scene scene)
    {
        GoldenPlay play = GoldenSqueezes.Walk(scene.With(BoardAlongX(-0.9)), 75, new Vector3d(0.04, 0, 0.5), new Vector3d(0, 0, -1.5), 0.8);
        play.Restores = true;
        return play.Ball(new Vector3d(0, Radius, -0.7));
    }

    private static GoldenPlay CageOfRods(Scene scene)
    {
        // Nine rods that the ball touches at once.
        var rods = new Obstacle[9];
        for (int i = 0; i < 9; i++)
        {
            Vector3d way = Around(i, 9);
            rods[i] = Thing("rod", new CapsuleShape(0.14 * way, (0.14 * way) + new Vector3d(0, 1, 0), 0.03));
        }

        return new GoldenPlay(scene.InWind(3, 0, 1).With(rods), 1).Ball(new Vector3d(0, 0.6, 0), default, new Vector3d(0, 20, 0));
    }

    private static GoldenPlay SupportWithdrawn(Scene scene)
    {
        var bodies = new KinematicBodies();
        KinematicBody plate = bodies.Add("plate", Box(-1, 0, -1, 1, 0.2, 1), SurfaceMaterial.Wood);
        return new GoldenPlay(scene with { Bodies = bodies }, 1.5)
        {
            Move = time =>
            {
                plate.MoveTo(default, default, time);
                if (time > 0.7)
                {
                    plate.Withdraw();
                }
            },
        }.Ball(new Vector3d(0, 0.2 + Radius, 0), new Vector3d(0.1, 0, 0));
    }

    private static GoldenPlay EngineRotorStops(Scene scene)
    {
        var engine = new GoldenEngine { MaximumSpeed = 1 };
        Engines.EngineCollider rotor = engine.Add("rotor", Box(-1, 0, -0.05, 1, 1, 0.05), SurfaceMaterial.Wood);
        return new GoldenPlay(scene with { EngineColliders = engine }, 2)
        {
            Move = time =>
            {
                engine.Time = time;
                rotor.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, 3 * Math.Min(time, 0.8)), default, new Vector3d(0, time < 0.8 ? 3 : 0, 0));
            },
        }.Roll(0.7, 0.6, 0, -0.8);
    }
}
