using System.Globalization;
using FootballPhysics.Package.Tests;

namespace FootballPhysics.Native.Tests;

/// <summary>What tests/Native/kicks.c prints, made by the library as C# calls it.</summary>
public sealed class KickTests
{
    private const int Block = 100;
    private const int Ticks = 1200;

    private static readonly (string Name, Scene Scene, int Kicks)[] s_scenes =
        [("default", new Scene(), 3400), ("published", Scene.Published, 3300), ("pitch", Pitch.Standard.On(new Scene()), 3300)];

    [Fact]
    public void Ten_thousand_kicks_have_the_hashes_of_the_file() => Repository.AssertCurrent("tests/Native/kicks.txt", string.Concat(Lines()));

    private static IEnumerable<string> Lines()
    {
        foreach ((string name, Scene scene, int kicks) in s_scenes)
        {
            var simulator = new Simulator(scene);
            var log = new StepLog();
            ulong hash = 0;
            for (int i = 0; i < kicks; i++)
            {
                hash = Kick(simulator, log, (ulong)i, hash);
                if (i % Block == Block - 1)
                {
                    yield return string.Create(CultureInfo.InvariantCulture, $"{name} {i + 1} {hash:x16}\n");
                }
            }
        }
    }

    private static ulong Kick(Simulator simulator, StepLog log, ulong seed, ulong hash)
    {
        var position = new Vector3d((60 * Draw(ref seed)) - 30, 2 * Draw(ref seed), (90 * Draw(ref seed)) - 45);
        var velocity = new Vector3d((50 * Draw(ref seed)) - 25, (50 * Draw(ref seed)) - 25, (50 * Draw(ref seed)) - 25);
        var spin = new Vector3d((120 * Draw(ref seed)) - 60, (120 * Draw(ref seed)) - 60, (120 * Draw(ref seed)) - 60);
        BallState state = simulator.Launch(position, velocity, spin);
        for (int i = 0; i < Ticks && state.Motion != MotionState.Rest; i++)
        {
            log.Clear();
            simulator.Step(ref state, 1.0 / 60, log);
            foreach (ref readonly BallEvent e in log.Events)
            {
                hash = Mix(hash, ((ulong)(uint)e.Kind << 32) | (uint)e.ColliderIndex);
                hash = Mix(hash, BitConverter.DoubleToUInt64Bits(e.Time));
                foreach (Vector3d v in (ReadOnlySpan<Vector3d>)[e.Position, e.VelocityBefore, e.Velocity, e.SpinBefore, e.Spin, e.Normal])
                {
                    hash = Mix(Mix(Mix(hash, BitConverter.DoubleToUInt64Bits(v.X)), BitConverter.DoubleToUInt64Bits(v.Y)), BitConverter.DoubleToUInt64Bits(v.Z));
                }
            }

            hash = Mix(hash, Snapshot.Hash(in state));
        }

        return hash;
    }

    private static double Draw(ref ulong seed)
    {
        seed += 0x9E3779B97F4A7C15;
        ulong z = (seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return ((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
    }

    private static ulong Mix(ulong hash, ulong word)
    {
        hash = (hash ^ word) * 0x9E3779B97F4A7C15;
        return hash ^ (hash >> 29);
    }
}
