using System.Diagnostics;
using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "A heap": balls dropped into a box, stepped at 60 Hz until they lie still.</summary>
internal static class HeapTable
{
    private const double Radius = 0.11;
    private const double Frame = 1.0 / 60;

    /// <summary>The number of frames, eight seconds, and the time limit of a run, s.</summary>
    private const int Frames = 480;
    private const double Longest = 60;

    private static readonly (int Balls, double Half)[] s_heaps = [(60, 0.6), (10, 0.35)];

    public static IReadOnlyList<(string Name, int Balls, double Half, Integrator Integrator)> Rows { get; } =
    [
        .. from heap in s_heaps
           from method in new[] { (Integrator: Integrator.Rk4, Name: "RK4"), (Integrator: Integrator.Rk2, Name: "RK2") }
           select (string.Create(CultureInfo.InvariantCulture, $"{heap.Balls} balls in a box of {2 * heap.Half:0.0} m: {method.Name}"), heap.Balls, heap.Half, method.Integrator),
    ];

    /// <summary>Simulates and times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<(string Name, int Balls, double Half, Integrator Integrator)> rows)
    {
        print("");
        print("## A heap");
        print("");
        print("Balls dropped into a box, 8 s at 60 Hz, or as many steps as one minute allows. Targets: 5 ms per step and 50 evaluations per ball for 60 balls, and 1e-6 m.");
        print("");
        print("| | steps | µs a ball and step | mean step, ms | worst step, ms | evaluations a ball and step | most in a step, a ball | deepest, m | events | at rest |");
        print("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
        foreach ((string name, int balls, double half, Integrator integrator) in rows)
        {
            // Compile the code before the measurement.
            Play(8, 0.3, integrator, 3);
            Heap heap = Play(balls, half, integrator, Longest);
            double mean = heap.Seconds / heap.Steps;
            print(string.Create(CultureInfo.InvariantCulture, $"| {name} | {heap.Steps} | {Text.Number(1e6 * mean / balls)} | {Text.Number(1e3 * mean)} | {Text.Number(1e3 * heap.Worst)} | {Text.Number((double)heap.Evaluations / heap.Steps / balls)} | {Text.Number((double)heap.Most / balls)} | {Text.Number(heap.Deepest)} | {heap.Events} | {heap.Resting} |"));
        }
    }

    private static Heap Play(int balls, double half, Integrator integrator, double longest)
    {
        Obstacle[] walls =
        [
            .. new[] { new Vector3d(1, 0, 0), new Vector3d(-1, 0, 0), new Vector3d(0, 0, 1), new Vector3d(0, 0, -1) }
                .Select(normal => new Obstacle { Name = "wall", Shape = new PlaneShape(-half * normal, normal), Surface = SurfaceMaterial.Board }),
        ];
        var group = new BallGroup(new Simulator(new Scene { Obstacles = walls }, new SolverSettings { Integrator = integrator }), balls);
        BallState[] states = Drop(group, balls, half);
        var again = new BallState[balls];
        var log = new StepLog(mostEvents: 65_536);
        var heap = new Heap();
        while (heap.Steps < Frames && heap.Seconds < longest)
        {
            Array.Copy(states, again, balls);
            log.Clear();
            double took = Time(group, states, log);
            heap.Steps++;
            heap.Seconds += took;
            heap.Evaluations += log.Evaluations;
            heap.Most = Math.Max(heap.Most, log.Evaluations);
            heap.Events += log.Events.Count + log.Events.Dropped;

            // Time a new worst step again: another program may have delayed it.
            if (took > heap.Worst)
            {
                log.Clear();
                heap.Worst = Math.Max(heap.Worst, Math.Min(took, Time(group, again, log)));
            }

            foreach (BallState state in states)
            {
                double beyond = Math.Max(Math.Abs(state.Position.X), Math.Abs(state.Position.Z)) + Radius - half;
                heap.Deepest = Math.Max(heap.Deepest, Math.Max(beyond, Radius - state.Position.Y));
            }
        }

        heap.Resting = states.Count(state => state.Motion == MotionState.Rest);
        return heap;
    }

    private static double Time(BallGroup group, BallState[] states, StepLog log)
    {
        long began = Stopwatch.GetTimestamp();
        group.Step(states, Frame, log);
        return Stopwatch.GetElapsedTime(began).TotalSeconds;
    }

    /// <summary>Returns layers of balls, with small offsets.</summary>
    private static BallState[] Drop(BallGroup group, int balls, double half)
    {
        var random = new SeededRandom(60L);
        int side = Math.Max(1, (int)((2 * half) / 0.27));
        double gap = 2 * half / side;
        return
        [
            .. Enumerable.Range(0, balls).Select(i =>
            {
                int layer = i / (side * side);
                int inLayer = i % (side * side);
                var place = new Vector3d(
                    (((inLayer % side) + 0.5) * gap) - half + random.Uniform(-0.015, 0.015),
                    0.4 + (0.3 * layer),
                    (((inLayer / side) + 0.5) * gap) - half + random.Uniform(-0.015, 0.015));
                return group.SimulatorOf(i).Launch(place, Vector3d.Zero, Vector3d.Zero);
            }),
        ];
    }

    private sealed class Heap
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
