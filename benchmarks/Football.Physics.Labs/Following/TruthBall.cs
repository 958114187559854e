namespace FootballPhysics.Labs.Following;

/// <summary>The motion of a ball in the lab, stepped without the library: the measured laws on level turf, written from their equations.</summary>
/// <remarks>Fourth-order steps of half a millisecond; impacts and the ends of slides are located within a step by a secant.</remarks>
internal sealed class TruthBall
{
    private const double Step = 5e-4;
    private const double Gravity = 9.81;
    private const double Mass = 0.43;
    public const double Radius = 0.11;
    private const double Inertia = 2.0 / 3;
    private const double Density = 1.2;
    private const double Viscosity = 1.5e-5;
    private const double Area = Math.PI * Radius * Radius;
    private const double Buoyancy = 4.0 / 3 * Math.PI * Radius * Radius * Radius * Density * Gravity;

    // The modern ball.
    private const double Slow = 0.49;
    private const double Crisis = 94950.45175823745;
    private const double Width = 13968.255908606072;
    private const double Fast = 0.15992;
    private const double Risen = 0.18992;
    private const double RiseFrom = 117738.56018021444;
    private const double RiseTo = 508609;

    // The match turf.
    private const double Restitution = 0.67;
    private const double RestitutionSpeed = 20;
    private const double Rise = 0.45;
    private const double Tangential = -0.15;
    private const double ImpactFriction = 0.42;
    private const double Sliding = 0.45;
    private const double Rolling = 0.064;
    private const double RollingBySpeed = 0.003;
    private const double Drilling = 0.02;
    private const double LeastBounce = 0.2;
    private const double RestEnergy = 1e-4;

    /// <summary>Position, velocity and spin.</summary>
    public Vector3d Position { get; private set; }

    public Vector3d Velocity { get; private set; }

    public Vector3d Spin { get; private set; }

    public double Time { get; private set; }

    public MotionState Motion { get; private set; }

    public void Launch(double time, Vector3d position, Vector3d velocity, Vector3d spin)
    {
        (Time, Position, Velocity, Spin, Motion) = (time, position, velocity, spin, MotionState.Airborne);
        if (position.Y <= Radius + 1e-9 && Math.Abs(velocity.Y) < LeastBounce)
        {
            Land();
        }
    }

    /// <summary>Moves the ball to a time.</summary>
    public void Run(double time)
    {
        while (Time < time - 1e-12)
        {
            Take(Math.Min(Step, time - Time));
        }
    }

    private void Take(double dt)
    {
        (Vector3d p, Vector3d v, Vector3d w) = (Position, Velocity, Spin);
        if (Motion == MotionState.Rest)
        {
            Time += dt;
            return;
        }

        (Vector3d p1, Vector3d v1, Vector3d w1) = Integrate(p, v, w, dt);
        if (Motion == MotionState.Airborne)
        {
            if (p1.Y < Radius && v1.Y < 0)
            {
                double at = p.Y <= Radius ? 0 : dt * (p.Y - Radius) / (p.Y - p1.Y);
                for (int i = 0; i < 3 && at > 0; i++)
                {
                    (p1, v1, w1) = Integrate(p, v, w, at);
                    at += (p1.Y - Radius) / -v1.Y;
                }

                (Position, Velocity, Spin) = at > 0 ? Integrate(p, v, w, at) : (p, v, w);
                Time += Math.Max(0, at);
                Impact();
                return;
            }
        }
        else if (Motion == MotionState.Sliding)
        {
            // A slip that ends within the step is an impulse of friction.
            Vector3d slip = Slip(v, w);
            double stop = (1 + (1 / Inertia)) * Sliding * Gravity * dt;
            if (slip.Length <= stop)
            {
                Velocity -= Inertia / (1 + Inertia) * slip;
                Motion = MotionState.Rolling;
                Roll();
                (p1, v1, w1) = Integrate(p, Velocity, Spin, dt);
            }
        }

        (Position, Velocity, Spin) = (p1, v1, w1);
        Time += dt;
        if (Motion == MotionState.Rolling)
        {
            Roll();
            double spinUp = Spin.Y;
            if ((0.5 * (1 + Inertia) * Mass * Velocity.LengthSquared) + (0.5 * Inertia * Mass * Radius * Radius * spinUp * spinUp) < RestEnergy)
            {
                (Velocity, Spin, Motion) = (Vector3d.Zero, Vector3d.Zero, MotionState.Rest);
            }
        }
    }

    private void Roll() => Spin = new Vector3d(Velocity.Z / Radius, Spin.Y, -Velocity.X / Radius);

    private void Land()
    {
        Position = new Vector3d(Position.X, Radius, Position.Z);
        Velocity = Velocity.Horizontal;
        Motion = Slip(Velocity, Spin).Length < 1e-9 ? MotionState.Rolling : MotionState.Sliding;
        if (Velocity.Length < 1e-9 && Spin.Length < 1e-9)
        {
            Motion = MotionState.Rest;
        }
    }

    /// <summary>The velocity of the lowest point: v + r ŷ × ω.</summary>
    private static Vector3d Slip(Vector3d v, Vector3d w) => v.Horizontal + (Radius * new Vector3d(w.Z, 0, -w.X));

    private void Impact()
    {
        double down = -Velocity.Y;
        double e0 = Restitution * Math.Sqrt(1 + (6 / RestitutionSpeed * (6 / RestitutionSpeed)));
        double e = e0 / Math.Sqrt(1 + (down / RestitutionSpeed * (down / RestitutionSpeed)));
        double c = Velocity.Horizontal.Length / down;
        double c4 = c * c * c * c;
        e += double.IsFinite(c4) ? Rise * (1 - e) * c4 / (c4 + (2.8 * 2.8 * 2.8 * 2.8)) : Rise * (1 - e);
        double normal = Mass * (1 + e) * down;
        Vector3d slip = Slip(Velocity, Spin);
        double tangent = Math.Min(ImpactFriction * normal, Mass * Inertia / (1 + Inertia) * (1 + Tangential) * slip.Length);
        Vector3d direction = slip.Length > 0 ? slip / slip.Length : Vector3d.Zero;
        double moment = Inertia * Mass * Radius * Radius;
        Velocity += ((normal * Vector3d.Up) - (tangent * direction)) / Mass;
        Vector3d spin = Spin + (Radius * tangent / moment * Vector3d.Cross(Vector3d.Up, direction));
        double drill = Math.Min(Math.Abs(spin.Y), Drilling * Sliding * normal / moment);
        Spin = spin - (Math.Sign(spin.Y) * drill * Vector3d.Up);
        Position = new Vector3d(Position.X, Radius, Position.Z);
        if (Velocity.Y < LeastBounce)
        {
            Land();
        }
    }

    private (Vector3d P, Vector3d V, Vector3d W) Integrate(Vector3d p, Vector3d v, Vector3d w, double dt)
    {
        (Vector3d a1, Vector3d b1) = (Acceleration(v, w, out Vector3d s1), s1);
        (Vector3d v2, Vector3d w2) = (v + (0.5 * dt * a1), w + (0.5 * dt * b1));
        (Vector3d a2, Vector3d b2) = (Acceleration(v2, w2, out Vector3d s2), s2);
        (Vector3d v3, Vector3d w3) = (v + (0.5 * dt * a2), w + (0.5 * dt * b2));
        (Vector3d a3, Vector3d b3) = (Acceleration(v3, w3, out Vector3d s3), s3);
        (Vector3d v4, Vector3d w4) = (v + (dt * a3), w + (dt * b3));
        (Vector3d a4, Vector3d b4) = (Acceleration(v4, w4, out Vector3d s4), s4);
        double sixth = dt / 6;
        return (
            p + (sixth * (v + (2 * v2) + (2 * v3) + v4)), v + (sixth * (a1 + (2 * a2) + (2 * a3) + a4)), w + (sixth * (b1 + (2 * b2) + (2 * b3) + b4)));
    }

    /// <summary>The accelerations of velocity and spin.</summary>
    private Vector3d Acceleration(Vector3d v, Vector3d w, out Vector3d turn)
    {
        Vector3d air = Air(v, w);
        double speed = v.Length;
        double decay = (0.0096 * Math.PI * Density * Radius * Radius / (Inertia * Mass) * speed) + (0.004 * Density / 1.2);
        Vector3d torque = -decay * w;
        if (Motion == MotionState.Airborne)
        {
            turn = torque;
            return ((air + (Buoyancy * Vector3d.Up)) / Mass) - (Gravity * Vector3d.Up);
        }

        double load = Math.Max(0, Gravity - ((Buoyancy + air.Y) / Mass));
        Vector3d side = air.Horizontal / Mass;
        double drill = w.Y == 0 ? 0 : -Math.Sign(w.Y) * Drilling * Sliding * load / (Inertia * Radius * Radius);
        if (Math.Abs(w.Y) < Math.Abs(drill) * Step)
        {
            drill = -w.Y / Step;
        }

        if (Motion == MotionState.Sliding)
        {
            Vector3d slip = Slip(v, w);
            slip = slip.Length > 0 ? slip / slip.Length : slip;
            Vector3d friction = Sliding * load / (Inertia * Radius) * Vector3d.Cross(Vector3d.Up, slip);
            turn = new Vector3d(torque.X + friction.X, torque.Y + drill, torque.Z + friction.Z);
            return side - (Sliding * load * slip);
        }

        // Rolling: the torque of the air, divided by m r, acts along ŷ reversed.
        turn = new Vector3d(0, torque.Y + drill, 0);
        Vector3d push = Inertia * Radius * Vector3d.Cross(torque, Vector3d.Up);
        Vector3d brake = speed > 0 ? (Rolling + (RollingBySpeed * speed)) * load / speed * v.Horizontal : Vector3d.Zero;
        return ((side + push.Horizontal) / (1 + Inertia)) - brake;
    }

    /// <summary>Drag and lift.</summary>
    private static Vector3d Air(Vector3d u, Vector3d w)
    {
        double speed = u.Length;
        if (speed < 1e-9)
        {
            return Vector3d.Zero;
        }

        Vector3d across = w - (Vector3d.Dot(w, u) / (speed * speed) * u);
        double s = Radius * across.Length / speed;
        double re = 2 * Radius * speed / Viscosity;
        double q = Logistic((re - Crisis) / Width);
        double drag = ((Slow - Fast) * q) + Fast + ((re - RiseFrom) * Logistic(-(re - RiseFrom) / Width) * (Risen - Fast) / (RiseTo - RiseFrom))
            + (0.30 * s / Math.Sqrt((s * s) + (0.577 * 0.577)) * (1 - (0.5 * q)));
        double lift = 0.32 * (1 - (0.6 * q)) * Radius * speed / Math.Sqrt((Radius * Radius * across.LengthSquared) + (0.14 * 0.14 * speed * speed));
        return 0.5 * Density * Area * ((-drag * speed * u) + (lift * Vector3d.Cross(w, u)));
    }

    private static double Logistic(double x) => 0.5 * (1 - Math.Tanh(0.5 * x));
}
