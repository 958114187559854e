using System.Runtime.CompilerServices;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "What a step cannot avoid": parts of a step, timed alone, in which each operation waits for the one before.</summary>
internal static class FloorTable
{
    private const double H = ShotSets.TimeStep;
    private const int Operations = 8192;
    private static readonly Scene s_constant = Scene.Published with { Forces = ForceSet.Constant };

    public static IReadOnlyList<FloorRow> Rows { get; } =
    [
        new("a call that adds to a clock in memory", "a stopped ball", Clock),
        new("the same, and a fall: position and velocity in memory", "vacuum, no air", Fall),
        new("RK2 of constant coefficients alone, without clock, position, events and guards", "constant coefficients, RK2", () => Fly<ConstantAir, MidpointRungeKutta>(new ConstantAir(s_constant))),
        new("RK2 of the published laws alone", "flight step, RK2", () => Fly<TableAir<PublishedLaw>, MidpointRungeKutta>(new TableAir<PublishedLaw>(Scene.Published))),
        new("RK2 of the measured laws alone", "flight step, RK2", () => Fly<TableAir<MeasuredLaw>, MidpointRungeKutta>(new TableAir<MeasuredLaw>(new Scene()))),
        new("RK4 of the published laws alone", "flight step, RK4", () => Fly<TableAir<PublishedLaw>, ClassicalRungeKutta>(new TableAir<PublishedLaw>(Scene.Published))),
        new("RK4 of the measured laws alone", "flight step, RK4", () => Fly<TableAir<MeasuredLaw>, ClassicalRungeKutta>(new TableAir<MeasuredLaw>(new Scene()))),
    ];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<FloorRow> rows, double share)
    {
        Workload plain = Workloads.Plain(PlainLawKind.Published, Integrator.Rk2, ShotSets.Fast);
        Workload[] work = [.. rows.Select(row => row.Subject())];
        Stopwatching.WarmUp([plain, .. work]);
        print("");
        print("## What a step cannot avoid");
        print("");
        print("Parts of a step, timed alone: each operation waits for the one before. The last column names the rows above that contain the part. By the latencies of such processors (an estimate), a stage of the published laws takes about 64 clock cycles: 12 for |u|², 4 for the argument, 12 for the index and the load, 12 for the cubic, 24 for drag, lift, acceleration and the next velocity.");
        print("");
        print("| | ns | plain RK2, ns | ratio | part of |");
        print("|---|--:|--:|--:|---|");
        for (int i = 0; i < rows.Count; i++)
        {
            Timing time = Stopwatching.Measure(work[i], plain, share);
            print($"| {rows[i].Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {rows[i].PartOf} |");
        }
    }

    private static Workload Clock() => new(
        () =>
        {
            double clock = 0;
            for (int i = 0; i < Operations; i++)
            {
                Advance(ref clock, H);
            }

            return clock;
        },
        Operations);

    private static Workload Fall() => new(
        () =>
        {
            var s = new Falling { VelocityX = 20, VelocityZ = -10, SpinRate = 25 };
            for (int i = 0; i < Operations; i++)
            {
                Advance(ref s, H);
            }

            return s.Y;
        },
        Operations);

    private static Workload Fly<TAir, TIntegrator>(TAir air)
        where TAir : struct, IFlightAir
        where TIntegrator : struct, IIntegrator
    {
        TIntegrator method = default;
        Shot[] shots = [.. ShotSets.Fast];
        int next = 0;
        return new Workload(
            () =>
            {
                // As long as a timed flight, from the next of the shots.
                BallState ball = default;
                FlightMotion motion;
                motion.Velocity = shots[next].Velocity;
                motion.SpinRate = shots[next].Spin.Length;
                motion.Axis = shots[next].Spin / motion.SpinRate;
                next = (next + 1) % shots.Length;
                for (int i = 0; i < ShotSets.Steps; i++)
                {
                    method.Fly(ref air, in ball, ref motion, Vector3d.Zero, DragBranch.Spinning, -9.81, H, out _);
                }

                return motion.Velocity.X;
            },
            ShotSets.Steps);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Advance(ref double clock, double h) => clock += h;

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Advance(ref Falling s, double h)
    {
        double gained = -9.81 * h;
        s.X += h * s.VelocityX;
        s.Y += h * (s.VelocityY + (0.5 * gained));
        s.Z += h * s.VelocityZ;
        s.VelocityY += gained;
        s.Angle += h * s.SpinRate;
        s.Time += h;
        s.Steps++;
    }

    private struct Falling
    {
        public double Time;
        public double X;
        public double Y;
        public double Z;
        public double VelocityX;
        public double VelocityY;
        public double VelocityZ;
        public double Angle;
        public double SpinRate;
        public long Steps;
    }
}
