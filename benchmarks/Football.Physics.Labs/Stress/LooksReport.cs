using Football.Tool.Commands;
namespace Football.Physics.Labs.Stress;
internal static class LooksReport { public static LabReport Run(long seed, long matches, double seconds, long late, int jobs, Progress progress) => new() { Name = "stress", Seed = seed }; }
