using System.Diagnostics;
using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "A heap": balls dropped into a box, or in a row, stepped at 60 Hz until they lie still.</summary>
internal static class HeapTable
{
    /// <summary>The simulated time, s.</summary>
    public const double Duration = 8;

    /// <summary>The time limit of a run, s.</summary>
    private const double Longest = 60;

    private static readonly (Integrator Integrator, string Name)[] s_methods = [(Integrator.Rk4, "RK4"), (Integrator.Rk2, "RK2")];
    private static readonly (int Balls, double Half, double Contact)[] s_boxes = [(60, 0.6, 1), (10, 0.35, 0.8), (5, 0.25, 0.8)];

    public static IReadOnlyList<HeapRow> Rows { get; } =
    [
        .. from box in s_boxes
           from method in s_methods
           select new HeapRow(
               string.Create(CultureInfo.InvariantCulture, $"{box.Balls} balls in a box of {2 * box.Half:0.0} m: {method.Name}"), method.Integrator, integrator => Heap.InBox(integrator, box.Balls, box.Half), box.Contact),
        .. from method in s_methods
           select new HeapRow($"4 balls in a row, the heavier behind: {method.Name}", method.Integrator, integrator => Heap.InRow(integrator, 4), 0.5),
    ];

    /// <summary>Simulates and times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<HeapRow> rows, double share)
    {
        print("");
        print("## A heap");
        print("");
        print("Balls dropped into a box, or rolling in a row: 8 s at 60 Hz, or as many steps as one minute allows. Targets: 5 ms per step and 50 evaluations per ball for 60 balls, and 1e-6 m. Moving, at rest: the time for a ball and step while the balls settle, and after 8 s, relative to a flight step of 10 ms of the same method.");
        print("");
        print("| | steps | µs a ball and step | mean step, ms | worst step, ms | evaluations a ball and step | most in a step, a ball | deepest, m | events | at rest | moving, flight steps | at rest, flight steps |");
        print("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
        foreach (HeapRow row in rows)
        {
            Workload flight = Workloads.Flight(new Scene(), row.Integrator, ShotSets.Fast);
            Workload[] work = [.. row.Subjects.Select(subject => subject.Make())];
            Stopwatching.WarmUp([flight, .. work]);
            Heap heap = row.Make(row.Integrator);
            Counts counts = Play(heap);
            int balls = heap.States.Length;
            double mean = counts.Seconds / counts.Steps;
            double[] units = [.. work.Select(subject => Stopwatching.Measure(subject, flight, share / work.Length).Ratio)];
            print(string.Create(CultureInfo.InvariantCulture, $"| {row.Name} | {counts.Steps} | {Text.Number(1e6 * mean / balls)} | {Text.Number(1e3 * mean)} | {Text.Number(1e3 * counts.Worst)} | {Text.Number((double)counts.Evaluations / counts.Steps / balls)} | {Text.Number((double)counts.Most / balls)} | {Text.Number(counts.Deepest)} | {counts.Events} | {counts.Resting} | {Text.Number(units[0])} | {Text.Number(units[1])} |"));
        }
    }

    private static Counts Play(Heap heap)
    {
        (BallGroup group, BallState[] states, double half) = heap;
        var again = new BallState[states.Length];
        var log = new StepLog(mostEvents: 65_536);
        var counts = new Counts();
        while (counts.Steps * Heap.Frame < Duration && counts.Seconds < Longest)
        {
            Array.Copy(states, again, states.Length);
            log.Clear();
            double took = Time(group, states, log);
            counts.Steps++;
            counts.Seconds += took;
            counts.Evaluations += log.Evaluations;
            counts.Most = Math.Max(counts.Most, log.Evaluations);
            counts.Events += log.Events.Count + log.Events.Dropped;

            // Time a new worst step again: another program may have delayed it.
            if (took > counts.Worst)
            {
                log.Clear();
                counts.Worst = Math.Max(counts.Worst, Math.Min(took, Time(group, again, log)));
            }

            foreach (BallState state in states)
            {
                double beyond = Math.Max(Math.Abs(state.Position.X), Math.Abs(state.Position.Z)) + Heap.Radius - half;
                counts.Deepest = Math.Max(counts.Deepest, Math.Max(beyond, Heap.Radius - state.Position.Y));
            }
        }

        counts.Resting = states.Count(state => state.Motion == MotionState.Rest);
        return counts;
    }

    private static double Time(BallGroup group, BallState[] states, StepLog log)
    {
        long began = Stopwatch.GetTimestamp();
        group.Step(states, Heap.Frame, log);
        return Stopwatch.GetElapsedTime(began).TotalSeconds;
    }

    private sealed class Counts
    {
        public int Steps { get; set; }

        public double Seconds { get; set; }

        public double Worst { get; set; }

        public long Evaluations { get; set; }

        public long Most { get; set; }

        public double Deepest { get; set; }

        public long Events { get; set; }

        public int Resting { get; set; }
    }
}
