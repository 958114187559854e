using System.Buffers.Binary;
using System.Globalization;
using System.IO.Compression;
using System.Text.RegularExpressions;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Labs.Stress;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Fuzz;

/// <summary>
/// Bundles: rejected with a sentence, or replayed. A fuzzer does not find a compressed text or a checksum, so these bytes may also be the two entries of the zip file: two bytes of length,
/// the text, and the recording.
/// </summary>
internal sealed partial class BundleFuzz : FuzzTarget
{
    private const int Ticks = 8;
    private const int Lengths = 2;

    public override string Name => "bundles";

    public override byte[] Make(SeededRandom random, int mutations)
    {
        Simulator simulator = HallScenes.All[random.Below(HallScenes.All.Count)];
        var runner = new FixedStepRunner(simulator, random.Any(0.01, 1.0 / 60));
        runner.QueueKick(random.Velocity(1, 25, 0, 50), 50 * random.Direction());
        Recording match = runner.Record();
        for (int i = 0; i < Ticks; i++)
        {
            runner.Step();
        }

        byte[] bundle = match.ToBundle(simulator);
        if (random.Chance(0.4))
        {
            return FuzzBytes.Changed(random, bundle, mutations);
        }

        using var zip = new ZipArchive(new MemoryStream(bundle));
        byte[] about = Unpacked(zip, "match.json");
        return FuzzBytes.Changed(random, [(byte)about.Length, (byte)(about.Length >> 8), .. about, .. Unpacked(zip, "match.segment")], mutations);
    }

    public override bool Try(byte[] input)
    {
        bool isZip = input.AsSpan().StartsWith("PK"u8) || input.Length < Lengths;
        if (isZip)
        {
            return Tried(input, out _);
        }

        int text = Math.Min(BinaryPrimitives.ReadUInt16LittleEndian(input), input.Length - Lengths);
        byte[] about = input[Lengths..(Lengths + text)];
        byte[] match = SegmentSeal.Sealed(input[(Lengths + text)..]);
        bool refused = Tried(Packed(about, match), out string sentence);
        if (OtherScene().Match(sentence) is not { Success: true } other)
        {
            return refused;
        }

        // The changed text describes another scene. Record its hash, as an attacker does.
        BinaryPrimitives.WriteUInt64LittleEndian(match.AsSpan(SegmentSeal.SceneAt(match)), ulong.Parse(other.Groups[1].ValueSpan, NumberStyles.HexNumber, CultureInfo.InvariantCulture));
        return Tried(Packed(about, FuzzBytes.Sealed(match)), out _);
    }

    private static bool Tried(byte[] bundle, out string sentence)
    {
        try
        {
            Played(MatchBundle.Read(new MemoryStream(bundle)));
            sentence = "";
            return false;
        }
        catch (RefusedException refusal)
        {
            sentence = refusal.Message;
            Must(Sentences.Is(sentence), $"a refusal is not one sentence: {sentence}");
            return true;
        }
    }

    /// <summary>Replays a bundle as the command does: to its end, and from the tick in the middle.</summary>
    private static void Played(MatchBundle bundle)
    {
        Recording match = bundle.Segment;
        Simulator simulator = bundle.NewSimulator();
        long? diverges = match.FirstDivergence(simulator);
        Must(diverges is null || (diverges > match.StartTick && diverges <= match.EndTick), "it diverges at a tick that it does not have");
        FixedStepRunner replay = match.Replay(bundle.NewSimulator());
        match.Seek(replay, match.StartTick + ((match.EndTick - match.StartTick) / 2));
        BallState state = replay.State;
        MustBeShort(simulator, ref state, match.TimeStep);
    }

    private static byte[] Packed(byte[] about, byte[] match)
    {
        using var memory = new MemoryStream();
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Create, leaveOpen: true))
        {
            foreach ((string name, byte[] bytes) in (ReadOnlySpan<(string, byte[])>)[("match.json", about), ("match.segment", match)])
            {
                using Stream entry = zip.CreateEntry(name, CompressionLevel.NoCompression).Open();
                entry.Write(bytes);
            }
        }

        return memory.ToArray();
    }

    private static byte[] Unpacked(ZipArchive zip, string name)
    {
        using var memory = new MemoryStream();
        using Stream entry = zip.GetEntry(name)!.Open();
        entry.CopyTo(memory);
        return memory.ToArray();
    }

    [GeneratedRegex("^sceneHash is ([0-9a-f]{16}); allowed: ")]
    private static partial Regex OtherScene();
}
