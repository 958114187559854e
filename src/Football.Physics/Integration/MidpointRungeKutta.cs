using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>Midpoint Runge–Kutta, y' = y + h f(y + h/2 f(y)) (thesis 3.15). Order 2.</summary>
internal readonly struct MidpointRungeKutta : IIntegrator
{
    public int Stages => 2;

    public double LastStage => 0.5;

    public int Order => 2;

    public Tableau Tableau => new([0, 0.5], [0, 1]);

    public double ShareInPath => 0.5;

    public bool GainsByHops => false;

    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        FlightRates.Begin(ref air, in start, out SeamAxes seams);
        double ux = motion.Velocity.X - wind.X;
        double uy = motion.Velocity.Y - wind.Y;
        double uz = motion.Velocity.Z - wind.Z;
        double w = motion.SpinRate;
        double nx = motion.Axis.X;
        double ny = motion.Axis.Y;
        double nz = motion.Axis.Z;

        double half = 0.5 * h;

        // y is the state, f its rate, h the step, and k1 and k2 are the rates of the stages.
        // k1 = f(y)
        FlightRates.At(
            ref air, in start, in seams, branch, upward, 0, 0, 0, 0, 0, nx, ny, nz, ux, uy, uz, w, out double ax, out double ay, out double az, out double b, out double s);
        Unsafe.SkipInit(out step);
        step.StartAcceleration = new Vector3d(ax, ay, az);
        step.StartSpinAcceleration = b;

        // k2 = f(y + h/2 k1)
        double mx = ux + (half * ax);
        double my = uy + (half * ay);
        double mz = uz + (half * az);
        double mw = w + (half * b);
        step.Turn = h * mw;
        Unsafe.SkipInit(out SeamAxes turned);
        ref readonly SeamAxes middle = ref seams;
        if (air.HasSide && w != 0)
        {
            // Half the turn of the step is that of the stage: h/2 |ω| differs from it by a term that order 2 leaves open.
            air.Turn(in seams, in start, half * mw, out turned, out step.Orientation);
            middle = ref turned;
        }
        else if (air.HasSide)
        {
            step.Orientation = start.BaseOrientation;
        }

        FlightRates.At(
            ref air, in start, in middle, branch, upward, half, half * (ux + wind.X), half * (uy + wind.Y), half * (uz + wind.Z), half * s, nx, ny, nz, mx, my, mz, mw,
            out ax, out ay, out az, out b, out s);

        // y' = y + h k2
        double ex = ux + (h * ax);
        double ey = uy + (h * ay);
        double ez = uz + (h * az);
        double ew = w + (h * b);
        motion.Velocity = new Vector3d(ex + wind.X, ey + wind.Y, ez + wind.Z);
        motion.SpinRate = ew;
        step.AirVelocity = new Vector3d(ex, ey, ez);
        step.SpinRate = ew;
        step.Path = new Vector3d(h * mx, h * my, h * mz);
        step.AirDistance = air.HasSide ? h * s : 0;
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        double half = 0.5 * h;

        // Take half a step with the rates at the start, then the full step with the rates in the middle.
        step.StartRates = start;
        Motion middle = from.After(half, in from.Velocity, in step.StartRates);
        system.Rates(time + half, in middle, out MotionRates k2);
        step.End = from.After(h, in middle.Velocity, in k2);
        step.Rotation = RotationVector.OfMean(in middle.Spin, in from.Spin, in step.End.Spin, h);
    }
}
