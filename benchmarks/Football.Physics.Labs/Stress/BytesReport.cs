using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stress;

/// <summary>Tries changed bytes of every format: they are rejected, or the steps that follow are finite and short.</summary>
internal static class BytesReport
{
    /// <summary>The formats.</summary>
    public static IReadOnlyList<FuzzTarget> Formats { get; } = [new StateBytes(isMemory: false), new StateBytes(isMemory: true), new WireBytes(), new KickBytesPlayed(), new SegmentFuzz(HallScenes.All)];

    public static LabReport Run(long seed, long count, int jobs, Progress progress) => FuzzLab.Run("stress", seed, count, jobs, Formats, progress);
}
