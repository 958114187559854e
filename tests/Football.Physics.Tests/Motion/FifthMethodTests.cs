using FootballPhysics.Integration;
using FootballPhysics.Simulation;
using FootballPhysics.State;

namespace FootballPhysics.Tests.Motion;

/// <summary>A new method of integration needs one type: it flies, slides, rolls and hits without changes elsewhere.</summary>
public sealed class FifthMethodTests
{
    private const double Duration = 0.6;

    [Theory]
    [InlineData(0, 4, 0, 1, MotionState.Rolling)]
    [InlineData(0, 14, 0, 0, MotionState.Sliding)]
    [InlineData(30, 20, 8, 1.5, MotionState.Airborne)]
    public void Its_steps_are_whole_and_of_its_own_order(double height, double speed, double climb, double rollingSpins, MotionState motion)
    {
        var scene = new Scene();
        double radius = scene.Ball.Radius;
        BallState start = new Simulator(scene).Launch(new Vector3d(0, radius + height, 0), new Vector3d(speed, climb, 0), new Vector3d(0, 3, -rollingSpins * speed / radius));
        BallState exact = Run<ClassicalRungeKutta>(scene, start, 0.0025, out _);
        BallState coarse = Run<Heun>(scene, start, 0.02, out _);
        BallState fine = Run<Heun>(scene, start, 0.01, out _);
        double error = (coarse.Position - exact.Position).Length;
        double smaller = (fine.Position - exact.Position).Length;
        Assert.InRange(error, 1e-9, 1e-3);
        Assert.InRange(error / smaller, 3.2, 5.0);
        Assert.Equal(motion, coarse.Motion);
        Run<Heun>(scene, start, 0.02, out StepLog log, 0.02);
        Assert.Equal((1, Heun.Evaluations), (log.Steps, log.Evaluations));
    }

    [Fact]
    public void It_bounces_slides_rolls_and_rests()
    {
        var scene = new Scene();
        BallState start = new Simulator(scene).Launch(new Vector3d(0, 2, 0), new Vector3d(9, 3, 1), new Vector3d(0, 40, -10));
        BallState exact = Run<ClassicalRungeKutta>(scene, start, 0.01, out _, 40);
        BallState other = Run<Heun>(scene, start, 0.01, out StepLog log, 40);
        Assert.Equal(MotionState.Rest, other.Motion);
        Assert.InRange((other.Position - exact.Position).Length, 0, 0.02);
        Assert.Contains(log.Events.Span.ToArray(), happened => happened.Kind == BallEventKind.Impact);
    }

    private static BallState Run<TMethod>(Scene scene, BallState ball, double step, out StepLog log, double duration = Duration)
        where TMethod : struct, IIntegrator
    {
        Stepper stepper = StepperFactory.Create<TMethod>(scene, new SolverSettings());
        log = new StepLog();
        for (int i = 0; i < (int)((duration / step) + 0.5); i++)
        {
            stepper.Step(ref ball, step, log);
        }

        return ball;
    }

    /// <summary>Heun's method, y' = y + h/2 (k₁ + f(y + h k₁)). Order 2.</summary>
    private readonly struct Heun : IIntegrator
    {
        public const int Evaluations = 2;

        public int Stages => Evaluations;

        public double LastStage => 1;

        public int Order => 2;

        public Tableau Tableau => new([0, 1], [0.5, 0.5]);

        public double ShareInPath => 0.5;

        public bool GainsByHops => false;

        public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
            where TAir : struct, IFlightLaws
        {
            FlightRates.Begin(ref air, in start, out SeamAxes seams);
            Vector3d u = motion.Velocity - wind;
            Vector3d n = motion.Axis;
            double w = motion.SpinRate;
            FlightRates.At(
                ref air, in start, in seams, branch, upward, 0, 0, 0, 0, 0, n.X, n.Y, n.Z, u.X, u.Y, u.Z, w, out double ax, out double ay, out double az, out double b, out double s);
            var first = new Vector3d(ax, ay, az);
            Vector3d next = u + (h * first);
            Vector3d way = h * (u + wind);
            double nextW = w + (h * b);
            SeamAxes last = seams;
            if (air.HasSide)
            {
                air.Turn(in seams, in motion.Axis, h * w, out last);
            }

            FlightRates.At(
                ref air, in start, in last, branch, upward, h, way.X, way.Y, way.Z, h * s, n.X, n.Y, n.Z, next.X, next.Y, next.Z, nextW,
                out ax, out ay, out az, out double c, out double t);
            System.Runtime.CompilerServices.Unsafe.SkipInit(out step);
            step.StartAcceleration = first;
            step.StartSpinAcceleration = b;
            step.AirDistance = air.HasSide ? 0.5 * h * (s + t) : 0;
            step.AirVelocity = u + (0.5 * h * (first + new Vector3d(ax, ay, az)));
            step.SpinRate = w + (0.5 * h * (b + c));
            step.Path = 0.5 * h * (u + next);
            step.Turn = 0.5 * h * (w + nextW);
            StepTurn.Take(ref air, in start, step.Turn, ref step);
            motion.Velocity = step.AirVelocity + wind;
            motion.SpinRate = step.SpinRate;
        }

        public void Advance<TSystem>(ref TSystem system, double time, in FootballPhysics.Motion from, in MotionRates start, double h, out MotionStep step)
            where TSystem : struct, IMotionSystem
        {
            FootballPhysics.Motion last = from.After(h, in from.Velocity, in start);
            system.Rates(time + h, in last, out MotionRates rates);
            step.StartRates = start;
            step.End = new FootballPhysics.Motion(
                from.Position + (0.5 * h * (from.Velocity + last.Velocity)),
                from.Velocity + (0.5 * h * (start.Acceleration + rates.Acceleration)),
                from.Spin + (0.5 * h * (start.SpinAcceleration + rates.SpinAcceleration)),
                from.AirDistance + (0.5 * h * (start.AirSpeed + rates.AirSpeed)));
            step.Rotation = 0.5 * h * (from.Spin + last.Spin);
        }
    }
}
