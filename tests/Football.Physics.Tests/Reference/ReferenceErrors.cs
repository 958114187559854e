using System.Globalization;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Reference;

/// <summary>How far a reference case is off, at its worst instant: at its end or at one of its events.</summary>
/// <param name="Position">Position and apex, m.</param>
/// <param name="Time">Time, s.</param>
/// <param name="Velocity">Velocity, relative to max(1, |expected|), before an impact too.</param>
/// <param name="Spin">Spin, likewise.</param>
/// <param name="Orientation">Orientation at the end: half the angle between both, rad.</param>
internal sealed record ReferenceErrors(double Position, double Time, double Velocity, double Spin, double Orientation)
{
    /// <summary>The names of the errors, in their order.</summary>
    public static IReadOnlyList<string> Names { get; } = ["position", "time", "velocity", "spin", "orientation"];

    /// <summary>The errors in their order.</summary>
    public IReadOnlyList<double> All => [Position, Time, Velocity, Spin, Orientation];

    /// <summary>The errors of a run whose events are those of the case.</summary>
    public static ReferenceErrors Of(ReferenceRun run)
    {
        ReferenceResult end = run.Case.Expected;
        double position = Math.Max(Vector3d.Distance(run.Position, end.Position), Math.Abs(run.Apex - end.Apex));
        double time = Math.Abs(run.Time - end.Time);
        double velocity = Differences.Relative(run.Velocity, end.Velocity);
        double spin = Differences.Relative(run.Spin, end.Spin);
        foreach ((BallEvent actual, ReferenceEvent expected) in run.Events.Zip(end.Events))
        {
            position = Math.Max(position, Vector3d.Distance(actual.Position, expected.Position));
            time = Math.Max(time, Math.Abs(actual.Time - expected.Time));
            velocity = Math.Max(velocity, Differences.Relative(actual.Velocity, expected.Velocity));
            spin = Math.Max(spin, Differences.Relative(actual.Spin, expected.Spin));
        }

        if (end is { VelocityBefore: { } velocityBefore, SpinBefore: { } spinBefore })
        {
            velocity = Math.Max(velocity, Differences.Relative(run.Events[^1].VelocityBefore, velocityBefore));
            spin = Math.Max(spin, Differences.Relative(run.Events[^1].SpinBefore, spinBefore));
        }

        return new ReferenceErrors(position, time, velocity, spin, Differences.Rotation(run.Orientation, end.Orientation));
    }

    public static ReferenceErrors operator +(ReferenceErrors a, ReferenceErrors b) =>
        new(a.Position + b.Position, a.Time + b.Time, a.Velocity + b.Velocity, a.Spin + b.Spin, a.Orientation + b.Orientation);

    public static ReferenceErrors operator *(double times, ReferenceErrors a) =>
        new(times * a.Position, times * a.Time, times * a.Velocity, times * a.Spin, times * a.Orientation);

    /// <summary>Two digits each.</summary>
    public override string ToString() => string.Join(',', All.Select(error => error.ToString("0.0e+0", CultureInfo.InvariantCulture)));

    public static ReferenceErrors Parse(IEnumerable<string> cells)
    {
        double[] all = [.. cells.Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
        return new ReferenceErrors(all[0], all[1], all[2], all[3], all[4]);
    }
}
