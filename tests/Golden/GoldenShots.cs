using FootballPhysics.Laws;
using FootballPhysics.Netcode;

// The shots whose bits every runtime must reproduce. One file, compiled into the tests, the consumer of the package, its NativeAOT
// program and the program for Mono; golden.txt beside it holds what it must print.

using System.Globalization;

namespace FootballPhysics.Golden;

public static class GoldenShots
{
    private const double TimeStep = 0.01;
    private const int Ticks = 1200;

    /// <summary>One line a combination of shot, laws and integrator, one a combination of batch and laws; then what games get by default, and the total. After these, balls among objects, and the total of all.</summary>
    /// <param name="every">Above 1: of the kicks and of the balls among objects, only every so many, and no totals.</param>
    public static IEnumerable<string> Lines(int every = 1)
    {
        ulong total = 0;
        int number = 0;
        foreach (KeyValuePair<string, Scene> scene in Scenes())
        {
            foreach (Integrator integrator in new[] { Integrator.Euler, Integrator.SemiImplicitEuler, Integrator.Rk2, Integrator.Rk4 })
            {
                var simulator = new Simulator(scene.Value, new SolverSettings { Integrator = integrator });
                foreach (KeyValuePair<string, BallState> shot in Shots(simulator))
                {
                    if (number++ % every != 0)
                    {
                        continue;
                    }

                    ulong hash = Play(simulator, shot.Value);
                    total = Mix(total, hash);
                    yield return Line(shot.Key + " " + scene.Key + " " + integrator.ToString(), hash);
                }
            }
        }

        foreach (KeyValuePair<string, Scene> scene in Scenes())
        {
            foreach (KeyValuePair<string, ulong> batch in GoldenBatches.Hashes(scene.Value))
            {
                total = Mix(total, batch.Value);
                yield return Line(batch.Key + " " + scene.Key, batch.Value);
            }
        }

        foreach (KeyValuePair<string, ulong> line in GoldenGames.Hashes())
        {
            total = Mix(total, line.Value);
            yield return Line(line.Key, line.Value);
        }

        yield return "snapshot " + GoldenGames.SnapshotBytes();
        if (every == 1)
        {
            yield return Line("total", total);
        }

        foreach (KeyValuePair<string, ulong> line in GoldenThings.Hashes(new HashSet<string>(), every))
        {
            total = Mix(total, line.Value);
            yield return Line(line.Key, line.Value);
        }

        if (every == 1)
        {
            yield return Line("total with objects", total);
        }
    }

    private static IEnumerable<KeyValuePair<string, Scene>> Scenes()
    {
        yield return Named("published", Scene.Published);
        yield return Named("regularised", Scene.Published with { Forces = ForceSet.Regularized });
        yield return Named("constant", Scene.Published with { Forces = ForceSet.Constant });
        yield return Named("vacuum", Scene.Vacuum);
        yield return Named("windy", Scene.Published with { Air = new Air { Wind = new Vector3d(3.5, 0.5, 6) } });
        IForce gust = IForce.From(ball => new Vector3d(0.3 * ball.Position.Y, 0, 0.01 * ball.AirVelocity.Z));
        yield return Named("custom", Scene.Published with { Forces = ForceSet.Published with { CustomForces = new[] { gust } }, Ground = Ground.Presets["publishedWetTurf"] });
    }

    internal static IEnumerable<KeyValuePair<string, BallState>> Shots(Simulator simulator)
    {
        yield return Named("free-kick", Kick(simulator, 0.11, 27, new Vector3d(-0.12, 0.30, -1), -10, 55));
        yield return Named("corner", Kick(simulator, 0.11, 24, new Vector3d(-1, 0.45, -0.25), -25, -50));
        yield return Named("goal-kick", Kick(simulator, 0.11, 30, new Vector3d(0.2, 0.75, -1), -40, 5));
        yield return Named("driven-pass", Kick(simulator, 0.11, 22, new Vector3d(0.5, 0.03, -1), 15, 0));
        yield return Named("chip", Kick(simulator, 0.11, 13, new Vector3d(0, 1.1, -1), -70, 0));
        yield return Named("drop", simulator.Launch(new Vector3d(0, 3, 0), new Vector3d(0, 0, 0), new Vector3d(-60, 10, 0)));
        yield return Named("roll", simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(9, 0, -4), new Vector3d(0, 20, 0)));
    }

    private static BallState Kick(Simulator simulator, double height, double speed, Vector3d direction, double top, double side)
    {
        Vector3d velocity = (speed / direction.Length) * direction;
        return simulator.Launch(new Vector3d(0, height, 0), velocity, KickVectors.Spin(direction, top, side));
    }

    private static ulong Play(Simulator simulator, BallState start)
    {
        var runner = new FixedStepRunner(simulator, TimeStep);
        runner.Restore(0, start);

        // A second kick, so that kicking a moving ball counts too.
        runner.Kicks.Add(new KickInput(300, new Vector3d(2, 4, 9), new Vector3d(1, -20, 8)));
        ulong hash = 0;
        while (runner.Tick < Ticks)
        {
            runner.Step();
            hash = MixStep(hash, runner);
        }

        return hash;
    }

    /// <summary>State, events and what is drawn, after a step.</summary>
    internal static ulong MixStep(ulong hash, FixedStepRunner runner)
    {
        GoldenTrace.Add(runner);
        hash = Mix(hash, Snapshot.Hash(runner.State));
        for (int i = 0; i < runner.Events.Count; i++)
        {
            hash = MixEvent(hash, runner.Events[i]);
        }

        BallPose pose = runner.PoseAt(0.375);
        return Mix(Mix(hash, pose.Position), pose.Orientation.X);
    }

    private static ulong MixEvent(ulong hash, BallEvent happened)
    {
        hash = Mix(Mix(Mix(hash, (ulong)happened.Kind), happened.Time), happened.Position);
        hash = Mix(Mix(hash, happened.VelocityBefore), happened.SpinBefore);
        return Mix(Mix(hash, happened.Velocity), happened.Spin);
    }

    internal static ulong Mix(ulong hash, Vector3d vector)
    {
        return Mix(Mix(Mix(hash, vector.X), vector.Y), vector.Z);
    }

    internal static ulong Mix(ulong hash, double number)
    {
        return Mix(hash, (ulong)BitConverter.DoubleToInt64Bits(number));
    }

    internal static ulong Mix(ulong hash, ulong word)
    {
        unchecked
        {
            ulong h = ((hash << 7) | (hash >> 57)) ^ word;
            h = (h ^ (h >> 32)) * 0x9FB21C651E98DF25UL;
            return h ^ (h >> 29);
        }
    }

    internal static KeyValuePair<string, T> Named<T>(string name, T value)
    {
        return new KeyValuePair<string, T>(name, value);
    }

    private static string Line(string name, ulong hash)
    {
        return name + " " + hash.ToString("x16", CultureInfo.InvariantCulture);
    }
}
