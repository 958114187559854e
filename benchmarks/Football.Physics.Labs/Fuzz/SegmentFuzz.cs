using FootballPhysics.Game;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>Match segments: an accepted segment is replayed, and reports where it diverges.</summary>
/// <param name="simulators">The scenes; default: the scenes of <see cref="SnapshotFuzz"/>.</param>
internal sealed class SegmentFuzz(IReadOnlyList<Simulator>? simulators = null) : FuzzTarget
{
    private const int Ticks = 12;

    /// <summary>The number of bytes before the time step.</summary>
    private const int Header = 5;

    private readonly IReadOnlyList<Simulator> _simulators = simulators ?? SnapshotFuzz.Simulators;

    public override string Name => "segments";

    public override byte[] Make(SeededRandom random, int mutations)
    {
        Simulator simulator = _simulators[random.Below(_simulators.Count)];
        var runner = new FixedStepRunner(simulator, random.Any(0.01, 1.0 / 60, 0.1));
        BallState start = SnapshotFuzz.State(random, simulator);
        runner.Restore(random.Below(1000), in start);
        long first = runner.Tick;
        KickLog kicks = KickLogFuzz.Log(random, Ticks);
        for (int i = 0; i < kicks.Count; i++)
        {
            runner.Kicks.Add(new KickInput(first + kicks[i].Tick, kicks[i].Velocity, kicks[i].Spin, kicks[i].Player));
        }

        for (int i = 0; i < kicks.PlaceCount; i++)
        {
            PlaceInput place = kicks.PlaceAt(i);
            runner.Kicks.Add(new PlaceInput(first + place.Tick, place.Player, 0, place.Position, place.Velocity, place.Spin, place.Orientation));
        }

        runner.QuantizationInterval = random.Below(4);
        Recording segment = runner.Record();
        for (int i = random.Below(Ticks); i > 0; i--)
        {
            runner.Step();
        }

        byte[] bytes = segment.ToBytes();
        if (random.Chance(0.5))
        {
            return Wild(random, segment, bytes.AsSpan(0, Header), mutations);
        }

        byte[] changed = FuzzBytes.Changed(random, bytes, mutations);
        return random.Chance(0.7) ? FuzzBytes.Sealed(changed) : changed;
    }

    public override bool Try(byte[] input)
    {
        if (!IsAccepted<Recording>(() => Recording.FromBytes(input), out Recording? segment))
        {
            return true;
        }

        Must(Crc32.Holds(input), "changed bytes are accepted");
        byte[] again = segment.ToBytes();
        Must(again.AsSpan().SequenceEqual(Recording.FromBytes(again).ToBytes()), "a segment does not come back");
        foreach (Simulator simulator in _simulators)
        {
            long? diverges;
            try
            {
                diverges = segment.FirstDivergence(simulator);
            }
            catch (ArgumentOutOfRangeException e) when (e.ParamName?.StartsWith("state.", StringComparison.Ordinal) == true)
            {
                // No ball in this scene can have this state.
                continue;
            }
            catch (ArgumentException)
            {
                Must(simulator.SceneHash != segment.SceneHash || segment.Balls != 1 || segment.StartMotions.Length != simulator.World.Movers, "its own scene is refused");
                continue;
            }
            catch (InvalidOperationException)
            {
                Must(segment.HasMovingColliders, "a segment that holds every motion is refused");
                continue;
            }

            Must(diverges is null || (diverges > segment.StartTick && diverges <= segment.EndTick), "it diverges at a tick that it does not have");
            FixedStepRunner runner = segment.Replay(simulator);
            while (runner.Tick < Math.Min(segment.EndTick, segment.StartTick + Ticks))
            {
                BallState state = runner.State;
                MustBeShort(simulator, ref state, segment.TimeStep);
                runner.Step();
                MustBeFinite(runner.State);
            }
        }

        return false;
    }

    /// <summary>Writes a segment in the file format, some of its numbers extreme.</summary>
    private static byte[] Wild(SeededRandom random, Recording segment, ReadOnlySpan<byte> header, int mutations)
    {
        var writer = new ByteWriter();
        foreach (byte part in header)
        {
            writer.Bits(part, 1);
        }

        bool Is() => random.Chance(mutations / 20.0);
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : (ulong)segment.Version.Length);
        foreach (char letter in segment.Version)
        {
            writer.Bits(Is() ? (ulong)random.Below(256) : letter, 1);
        }

        writer.Bits(segment.SceneHash, 8);
        writer.Bits(BitConverter.DoubleToUInt64Bits(Is() ? FuzzNumbers.AnyBits(random) : segment.TimeStep), 8);
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : (ulong)segment.StartTick);
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : (ulong)segment.QuantizationInterval);
        writer.Bits(Is() ? 1UL : 0, 1);
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : 1UL);
        byte[] start = FuzzBytes.Sealed(SnapshotFuzz.Changed(random, segment.Start, Is() ? mutations : 0));
        foreach (byte part in start)
        {
            writer.Bits(part, 1);
        }

        // No bodies, and no moved bodies.
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : 0);
        KickLogFuzz.Write(random, ref writer, segment.Kicks, Is() ? mutations / 30.0 : 0);
        KickLogFuzz.WritePlaces(random, ref writer, segment.Kicks, Is() ? mutations / 30.0 : 0);
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : 0);
        int count = (int)(segment.EndTick - segment.StartTick);
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : (ulong)count);
        for (int i = 1; i <= count; i++)
        {
            writer.Bits(segment.HashAt(segment.StartTick + i), 8);
        }

        // Too few ticks for a keyframe.
        writer.Integer(Is() ? KickLogFuzz.Integer(random) : 0);
        return writer.ToArray();
    }
}
