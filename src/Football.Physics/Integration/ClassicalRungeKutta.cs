using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Classical Runge–Kutta (thesis 3.17, with the k₁ that its k₂ lacks). Order 4.</summary>
internal readonly struct ClassicalRungeKutta : IIntegrator
{
    public int Stages => 4;

    public int Order => 4;

    public double ShareInPath => 0.5;

    public bool GainsByHops => false;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        double ux = motion.Velocity.X - wind.X;
        double uy = motion.Velocity.Y - wind.Y;
        double uz = motion.Velocity.Z - wind.Z;
        double w = motion.SpinRate;
        double nx = motion.Axis.X;
        double ny = motion.Axis.Y;
        double nz = motion.Axis.Z;

        // k1 = f(y)
        FlightRates.At(ref air, branch, nx, ny, nz, upward, ux, uy, uz, w, out double ax, out double ay, out double az, out double b);
        step.StartAcceleration = new Vector3d(ax, ay, az);
        step.StartSpinAcceleration = b;
        double sumX = ax;
        double sumY = ay;
        double sumZ = az;
        double sumB = b;

        // k2 = f(y + h/2 k1), k3 = f(y + h/2 k2), k4 = f(y + h k3)
        double along = 0.5 * h;
        for (int stage = 0; stage < 3; stage++)
        {
            double vx = ux + (along * ax);
            double vy = uy + (along * ay);
            double vz = uz + (along * az);
            double vw = w + (along * b);
            FlightRates.At(ref air, branch, nx, ny, nz, upward, vx, vy, vz, vw, out ax, out ay, out az, out b);
            if (stage == 2)
            {
                break;
            }

            sumX += ax;
            sumY += ay;
            sumZ += az;
            sumB += b;
            along = stage == 0 ? along : h;
        }

        // y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4); of the position, whose k are the stages' velocities, that is p + h (v + h/6 (a1 + a2 + a3)).
        double sixth = h / 6.0;
        double nextX = ux + (sixth * (sumX + sumX - step.StartAcceleration.X + ax));
        double nextY = uy + (sixth * (sumY + sumY - step.StartAcceleration.Y + ay));
        double nextZ = uz + (sixth * (sumZ + sumZ - step.StartAcceleration.Z + az));
        double nextW = w + (sixth * (sumB + sumB - step.StartSpinAcceleration + b));
        motion.Velocity = new Vector3d(nextX + wind.X, nextY + wind.Y, nextZ + wind.Z);
        motion.SpinRate = nextW;
        step.AirVelocity = new Vector3d(nextX, nextY, nextZ);
        step.SpinRate = nextW;
        step.Path = new Vector3d(h * (ux + (sixth * sumX)), h * (uy + (sixth * sumY)), h * (uz + (sixth * sumZ)));
        step.Turn = h * (w + (sixth * sumB));
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        double half = 0.5 * h;
        double sixth = h / 6.0;
        system.Rates(time, in from, out MotionRates k1);
        Motion second = from.After(half, in from.Velocity, in k1);
        system.Rates(time + half, in second, out MotionRates k2);
        Motion third = from.After(half, in second.Velocity, in k2);
        system.Rates(time + half, in third, out MotionRates k3);
        Motion fourth = from.After(h, in third.Velocity, in k3);
        system.Rates(time + h, in fourth, out MotionRates k4);

        Vector3d velocity = from.Velocity + (2.0 * (second.Velocity + third.Velocity)) + fourth.Velocity;
        Vector3d acceleration = k1.Acceleration + (2.0 * (k2.Acceleration + k3.Acceleration)) + k4.Acceleration;
        Vector3d spinAcceleration = k1.SpinAcceleration + (2.0 * (k2.SpinAcceleration + k3.SpinAcceleration)) + k4.SpinAcceleration;
        step.End = new Motion(
            from.Position + (sixth * velocity),
            from.Velocity + (sixth * acceleration),
            from.Spin + (sixth * spinAcceleration),
            from.AirDistance + (sixth * (k1.AirSpeed + (2.0 * (k2.AirSpeed + k3.AirSpeed)) + k4.AirSpeed)));

        step.Rotation = RotationVector.Of(in from.Spin, 0.5 * (second.Spin + third.Spin), in step.End.Spin, h);
        step.StartRates = k1;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Advance<TSystem>(ref TSystem system, double time, in FieldMotion from, double h, out FieldStep step)
        where TSystem : struct, IFieldSystem
    {
        double half = 0.5 * h;
        system.Rates(time, in from, out FieldRates k1);
        step.StartAcceleration = k1.Acceleration;
        from.After(half, from.VX, from.VY, from.VZ, in k1, out FieldMotion second);
        system.Rates(time + half, in second, out FieldRates k2);
        from.After(half, second.VX, second.VY, second.VZ, in k2, out FieldMotion third);
        system.Rates(time + half, in third, out FieldRates k3);
        from.After(h, third.VX, third.VY, third.VZ, in k3, out FieldMotion fourth);
        system.Rates(time + h, in fourth, out FieldRates k4);

        const double Sixth = 1.0 / 6.0;
        FieldRates mean;
        mean.AX = Sixth * (k1.AX + (2.0 * (k2.AX + k3.AX)) + k4.AX);
        mean.AY = Sixth * (k1.AY + (2.0 * (k2.AY + k3.AY)) + k4.AY);
        mean.AZ = Sixth * (k1.AZ + (2.0 * (k2.AZ + k3.AZ)) + k4.AZ);
        mean.SpinAcceleration = Sixth * (k1.SpinAcceleration + (2.0 * (k2.SpinAcceleration + k3.SpinAcceleration)) + k4.SpinAcceleration);
        mean.AirSpeed = Sixth * (k1.AirSpeed + (2.0 * (k2.AirSpeed + k3.AirSpeed)) + k4.AirSpeed);
        from.After(
            h,
            Sixth * (from.VX + (2.0 * (second.VX + third.VX)) + fourth.VX),
            Sixth * (from.VY + (2.0 * (second.VY + third.VY)) + fourth.VY),
            Sixth * (from.VZ + (2.0 * (second.VZ + third.VZ)) + fourth.VZ),
            in mean,
            out step.End);
        step.Turn = h * (Sixth * (from.SpinRate + (2.0 * (second.SpinRate + third.SpinRate)) + fourth.SpinRate));
    }
}
