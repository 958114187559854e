using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>Classical Runge–Kutta, order 4 (thesis 3.17, whose k₂ lacks its k₁).</summary>
internal readonly struct ClassicalRungeKutta : IIntegrator
{
    public int Stages => 4;

    public double LastStage => 1;

    public int Order => 4;

    public Tableau Tableau => new([0, 0.5, 0.5, 1], [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0]);

    public double ShareInPath => 0.5;

    public bool GainsByHops => false;

    // In the comments, y is the state, f its rate, h the step, k1 … k4 are the rates of the stages, and θ is the angle by which the ball has turned.
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

        // k1 = f(y)
        FlightRates.At(
            ref air, in start, in seams, branch, upward, 0, 0, 0, 0, 0, nx, ny, nz, ux, uy, uz, w, out double ax, out double ay, out double az, out double b, out double s);
        Unsafe.SkipInit(out step);
        step.StartAcceleration = new Vector3d(ax, ay, az);
        step.StartSpinAcceleration = b;
        (double sumX, double sumY, double sumZ) = (ax, ay, az);
        double sumB = b;
        double sumS = s;
        double startS = s;

        // k2 = f(y + h/2 k1), k3 = f(y + h/2 k2), k4 = f(y + h k3)
        double along = 0.5 * h;
        double sixth = h / 6.0;
        (double vx, double vy, double vz, double vw) = (ux, uy, uz, w);
        Unsafe.SkipInit(out SeamAxes turned);
        ref readonly SeamAxes stageSeams = ref seams;
        for (int stage = 0; stage < 3; stage++)
        {
            double px = along * (vx + wind.X);
            double py = along * (vy + wind.Y);
            double pz = along * (vz + wind.Z);
            vx = ux + (along * ax);
            vy = uy + (along * ay);
            vz = uz + (along * az);
            if (air.HasSide && stage != 1 && w != 0)
            {
                // θ̇ = |ω|. Both middle stages take the mean of their angles, h/2 |ω| and h/2 |ω₂|: their sum, and so the order, stays.
                air.Turn(in seams, in motion.Axis, along * (stage == 0 ? w + (0.5 * along * b) : vw), out turned);
                stageSeams = ref turned;
            }

            vw = w + (along * b);
            if (stage == 2)
            {
                step.Turn = h * (w + (sixth * sumB));
                StepTurn.Take(ref air, in start, step.Turn, ref step);
            }

            FlightRates.At(
                ref air, in start, in stageSeams, branch, upward, along, px, py, pz, along * s, nx, ny, nz, vx, vy, vz, vw, out ax, out ay, out az, out b, out s);
            if (stage == 2)
            {
                break;
            }

            sumX += ax;
            sumY += ay;
            sumZ += az;
            sumB += b;
            sumS += s;
            along = stage == 0 ? along : h;
        }

        // y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4). For the position, each k is the velocity of a stage, which gives p + h (v + h/6 (a1 + a2 + a3)).
        double nextX = ux + (sixth * (sumX + sumX - step.StartAcceleration.X + ax));
        double nextY = uy + (sixth * (sumY + sumY - step.StartAcceleration.Y + ay));
        double nextZ = uz + (sixth * (sumZ + sumZ - step.StartAcceleration.Z + az));
        double nextW = w + (sixth * (sumB + sumB - step.StartSpinAcceleration + b));
        motion.Velocity = new Vector3d(nextX + wind.X, nextY + wind.Y, nextZ + wind.Z);
        motion.SpinRate = nextW;
        step.AirVelocity = new Vector3d(nextX, nextY, nextZ);
        step.SpinRate = nextW;
        step.Path = new Vector3d(h * (ux + (sixth * sumX)), h * (uy + (sixth * sumY)), h * (uz + (sixth * sumZ)));
        step.AirDistance = air.HasSide ? sixth * (sumS + sumS - startS + s) : 0;
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        double half = 0.5 * h;

        // The rates at the start, twice in the middle, and at the end. For the position, they are the velocities of the stages.
        Motion second = from.After(half, in from.Velocity, in start);
        system.Rates(time + half, in second, out MotionRates k2);
        Motion third = from.After(half, in second.Velocity, in k2);
        system.Rates(time + half, in third, out MotionRates k3);
        Motion fourth = from.After(h, in third.Velocity, in k3);
        system.Rates(time + h, in fourth, out MotionRates k4);

        step.End = new Motion(
            from.Position + Sum(h, in from.Velocity, in second.Velocity, in third.Velocity, in fourth.Velocity),
            from.Velocity + Sum(h, in start.Acceleration, in k2.Acceleration, in k3.Acceleration, in k4.Acceleration),
            from.Spin + Sum(h, in start.SpinAcceleration, in k2.SpinAcceleration, in k3.SpinAcceleration, in k4.SpinAcceleration),
            from.AirDistance + Sum(h, start.AirSpeed, k2.AirSpeed, k3.AirSpeed, k4.AirSpeed),
            from.Turn + Sum(h, in start.Turning, in k2.Turning, in k3.Turning, in k4.Turning));

        // The axis may turn within the step: combine the spins at the start, the middle and the end.
        step.Rotation = RotationVector.Of(in from.Spin, 0.5 * (second.Spin + third.Spin), in step.End.Spin, h);
        step.StartRates = start;
    }

    /// <summary>Returns h/6 (k₁ + 2 k₂ + 2 k₃ + k₄).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Sum(double h, double k1, double k2, double k3, double k4) => h / 6.0 * (k1 + (2.0 * (k2 + k3)) + k4);

    /// <summary>Returns h/6 (k₁ + 2 k₂ + 2 k₃ + k₄).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3d Sum(double h, in Vector3d k1, in Vector3d k2, in Vector3d k3, in Vector3d k4) => h / 6.0 * (k1 + (2.0 * (k2 + k3)) + k4);
}
