using Football.Tool.Commands;
namespace Football.Physics.Labs.Stress;
internal static class BytesReport { public static LabReport Run(long seed, long count, int jobs, Progress progress) => new() { Name = "stress", Seed = seed }; }
