using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Labs.Stress;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Fuzz;

/// <summary>One kind of input.</summary>
/// <param name="Name">The name of the kind: that of its folder in corpus.</param>
/// <param name="Target">The target of the laboratory that makes, tries and judges the inputs.</param>
/// <param name="Sealed">Writes the checksums that belong to the bytes. A fuzzer does not find them.</param>
internal sealed record Inputs(string Name, FuzzTarget Target, Func<byte[], byte[]> Sealed)
{
    /// <summary>Bytes of memory that an input may cost.</summary>
    private const long MostMemory = 64L << 20;

    public static IReadOnlyList<Inputs> All { get; } =
    [
        new("snapshots", new StateBytes(isMemory: false), bytes => FuzzBytes.Sealed(First(bytes, Snapshot.Size))),
        new("kicks", new KickBytesPlayed(), FuzzBytes.Sealed),
        new("segments", new SegmentFuzz(HallScenes.All), SegmentSeal.Sealed),
        new("bundles", new BundleFuzz(), bytes => bytes),
        new("wire", new WireBytes(), bytes => First(bytes, Snapshot.QuantizedSize)),
        new("scenarios", new ScenarioFuzz(), bytes => bytes),
        new("tracks", new TrackFuzz(), bytes => bytes),
        new("calls", new CallFuzz(), bytes => bytes),
    ];

    public static Inputs Of(string name) => All.Single(kind => kind.Name == name);

    /// <summary>A reader of a state ignores the bytes after it.</summary>
    private static byte[] First(byte[] bytes, int size) => bytes[..Math.Min(bytes.Length, size)];

    /// <summary>An input to start from.</summary>
    public byte[] Seed(SeededRandom random, int mutations) => Target.Make(random, mutations);

    /// <summary>Tries an input; throws if it leads to what must not be.</summary>
    /// <returns>True if the input is refused.</returns>
    public bool Try(byte[] input)
    {
        byte[] whole = Sealed(input);
        long before = GC.GetAllocatedBytesForCurrentThread();
        bool refused = Target.Try(whole);
        return GC.GetAllocatedBytesForCurrentThread() - before <= MostMemory ? refused : throw new FuzzException($"memory: more than {MostMemory >> 20} MiB");
    }
}
