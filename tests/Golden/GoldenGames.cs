using FootballPhysics.Aiming;
using FootballPhysics.Laws;
using FootballPhysics.Netcode;
using FootballPhysics.Shapes;

// What a game gets without asking for anything: the default scene, on its weather, its pitch and among its players.

using System.Globalization;

namespace FootballPhysics.Golden;

public static class GoldenGames
{
    public const double Frame = 1.0 / 60.0;
    private const int Ticks = 600;

    /// <summary>The scene that everybody has.</summary>
    public static Scene Plain { get; } = new Scene();

    /// <summary>Shots on bare ground, by scene and method; then those at goals, boards and players.</summary>
    public static IEnumerable<KeyValuePair<string, ulong>> Hashes()
    {
        foreach (KeyValuePair<string, Scene> scene in Grounds())
        {
            foreach (Simulator simulator in Simulators(scene.Value))
            {
                foreach (KeyValuePair<string, BallState> shot in GoldenShots.Shots(simulator))
                {
                    string name = shot.Key + " " + scene.Key + " " + simulator.Settings.Integrator.ToString();
                    yield return GoldenShots.Named(name, Play(simulator, shot.Value, new List<string>()));
                }
            }
        }

        foreach (KeyValuePair<string, ulong> line in Among(new List<string>()))
        {
            yield return line;
        }

        foreach (KeyValuePair<string, ulong> batch in GoldenBatches.Hashes(Plain))
        {
            yield return GoldenShots.Named(batch.Key + " default", batch.Value);
        }

        foreach (KeyValuePair<string, ulong> aim in Aims())
        {
            yield return aim;
        }
    }

    /// <summary>Shots at goals, boards and players.</summary>
    /// <param name="met">Gets the name of everything that a ball touched.</param>
    public static IEnumerable<KeyValuePair<string, ulong>> Among(List<string> met)
    {
        foreach (Simulator simulator in Simulators(Pitch.Standard.On(Plain)))
        {
            foreach (KeyValuePair<string, BallState> shot in ShotsAtGoal(simulator))
            {
                yield return GoldenShots.Named(shot.Key + " pitch " + simulator.Settings.Integrator.ToString(), Play(simulator, shot.Value, met));
            }
        }

        foreach (Simulator simulator in Simulators(Pitch.Stadium.On(Plain)))
        {
            foreach (KeyValuePair<string, BallState> shot in ShotsAtBoards(simulator))
            {
                yield return GoldenShots.Named(shot.Key + " stadium " + simulator.Settings.Integrator.ToString(), Play(simulator, shot.Value, met));
            }
        }

        foreach (Integrator integrator in Methods())
        {
            // Bodies belong to one match: every shot has a scene of its own.
            foreach (string name in new[] { "roll", "volley" })
            {
                var bodies = new KinematicBodies();
                bodies.Add("leg", new CapsuleShape(new Vector3d(0, 0.15, 0), new Vector3d(0, 0.9, 0), 0.1));
                var simulator = new Simulator(Plain with { Bodies = bodies }, new SolverSettings { Integrator = integrator });
                double height = name == "roll" ? simulator.ContactHeight : 0.7;
                BallState start = simulator.Launch(new Vector3d(0, height, 0), new Vector3d(0.2, 0, -6), new Vector3d(-30, 5, 0));
                yield return GoldenShots.Named(name + " body " + integrator.ToString(), Play(simulator, start, met));
            }
        }
    }

    /// <summary>The bytes of one state: a ball in the net of a goal, a second after it was kicked there.</summary>
    public static string SnapshotBytes()
    {
        var ball = new Ball(new Simulator(Pitch.Standard.On(Plain)));
        ball.Place(new Vector3d(1, 0.11, -46));
        ball.Kick(new Vector3d(1, 4, -24), new Vector3d(20, 30, -10));
        for (int i = 0; i < 30; i++)
        {
            ball.Step(Frame);
        }

        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(ball.State, bytes);
        return string.Concat(bytes.Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
    }

    private static IEnumerable<Integrator> Methods()
    {
        yield return Integrator.Rk2;
        yield return Integrator.Rk4;
    }

    private static IEnumerable<Simulator> Simulators(Scene scene)
    {
        return Methods().Select(integrator => new Simulator(scene, new SolverSettings { Integrator = integrator }));
    }

    private static IEnumerable<KeyValuePair<string, Scene>> Grounds()
    {
        yield return GoldenShots.Named("default", Plain);
        yield return GoldenShots.Named("wet", Plain with { Ground = Ground.Presets["publishedWetTurf"] });
        var wind = new WindByHeight(7, 0.6, -0.8, gusts: new Gusts { Seed = 11 });
        yield return GoldenShots.Named("gusts", Plain with { Air = new Air { WindField = wind }, Forces = ForceSet.Measured with { KnuckleSeed = 5 } });
        yield return GoldenShots.Named("slope", Plain with { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(0.05, 1, 0.02) } });
    }

    // The line of the goal is at z = -52.5, its posts at x = -3.72 and 3.72, its bar at y = 2.5.
    private static IEnumerable<KeyValuePair<string, BallState>> ShotsAtGoal(Simulator simulator)
    {
        yield return Shot("post", new Vector3d(3.65, 1.2, -49), new Vector3d(0, 1, -28), new Vector3d(0, 5, 20));
        yield return Shot("bar", new Vector3d(0, 2.4, -49), new Vector3d(2, 1, -25), new Vector3d(0, 0, 30));
        yield return Shot("net", new Vector3d(1, 1.1, -45), new Vector3d(1, 1, -26), new Vector3d(30, 20, 0));
        yield return Shot("side", new Vector3d(2.6, 0.6, -52), new Vector3d(9, 2, -7), new Vector3d(0, -20, 0));
        yield return Shot("slow", new Vector3d(-0.5, simulator.ContactHeight, -49), new Vector3d(0.3, 0, -9), new Vector3d(-60, 0, 0));
        yield return Shot("foot", new Vector3d(-3.75, simulator.ContactHeight, -50), new Vector3d(0, 0, -8), new Vector3d(0, 10, 0));

        KeyValuePair<string, BallState> Shot(string name, Vector3d from, Vector3d velocity, Vector3d spin)
        {
            return GoldenShots.Named(name, simulator.Launch(from, velocity, spin));
        }
    }

    // Boards 1 m high stand 38 m to the sides.
    private static IEnumerable<KeyValuePair<string, BallState>> ShotsAtBoards(Simulator simulator)
    {
        yield return GoldenShots.Named("boards", simulator.Launch(new Vector3d(33, 0.5, 0), new Vector3d(16, 2, 5), new Vector3d(0, 0, -30)));
        yield return GoldenShots.Named("edge", simulator.Launch(new Vector3d(35, 0.95, 0), new Vector3d(15, 1.4, 3), new Vector3d(0, 25, 0)));
        yield return GoldenShots.Named("pass", simulator.Launch(new Vector3d(36, simulator.ContactHeight, 5), new Vector3d(5, 0, 1), Vector3d.Zero));
    }

    private static ulong Play(Simulator simulator, BallState start, List<string> met)
    {
        var runner = new FixedStepRunner(simulator, Frame);
        runner.Restore(0, start);
        ulong hash = 0;
        while (runner.Tick < Ticks)
        {
            if (simulator.Scene.Bodies is { } bodies)
            {
                // The leg comes towards the ball, and steps back after every second.
                double time = runner.Time - Math.Floor(runner.Time);
                bodies[0].MoveTo(new Vector3d(0.05, 0, -5 + (3 * time)), new Vector3d(0, 0, 3), runner.Time);
            }

            runner.Step();
            hash = GoldenShots.MixStep(hash, runner);
            for (int i = 0; i < runner.Events.Count; i++)
            {
                met.Add(simulator.NameOf(runner.Events[i].ColliderIndex) ?? "ground");
            }
        }

        return hash;
    }

    /// <summary>What a game asks an aimer for: at a target, through a point, at one that runs, slowest, in time, from speed on arrival.</summary>
    private static IEnumerable<KeyValuePair<string, ulong>> Aims()
    {
        var aimer = new Aimer(Plain);
        var free = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(2.5, 1.9, -22), Speed = 26, TopSpin = -5, SideSpin = 30 };
        yield return GoldenShots.Named("aim at", Mix(aimer.Find(free)));
        yield return GoldenShots.Named("aim through", Mix(aimer.Find(free with { Waypoint = new Vector3d(1.6, 2.3, -10) })));
        yield return GoldenShots.Named("aim leading", Mix(aimer.Find(free with { TargetVelocity = new Vector3d(-3, 0, 2) })));
        yield return GoldenShots.Named("aim high", Mix(aimer.Find(free with { Arc = AimArc.High, MaximumElevationDegrees = 80 })));
        yield return GoldenShots.Named("aim slowest", Mix(aimer.FindSlowest(free)));
        yield return GoldenShots.Named("aim in time", Mix(aimer.FindAtTime(free, 1.25)));
        AimRequest pass = free with { Target = new Vector3d(4, 0.11, -25), Speed = 15, TopSpin = 0, SideSpin = 0 };
        yield return GoldenShots.Named("aim pass", Mix(aimer.Find(pass)));
        yield return GoldenShots.Named("aim arriving", Mix(aimer.FindAtSpeed(pass, 6)));
    }

    private static ulong Mix(AimResult aim)
    {
        GoldenTrace.Add(aim.Velocity);
        ulong hash = GoldenShots.Mix(GoldenShots.Mix(0, (ulong)aim.Status), aim.Time);
        return GoldenShots.Mix(GoldenShots.Mix(GoldenShots.Mix(hash, aim.Velocity), aim.Spin), aim.Miss);
    }
}
