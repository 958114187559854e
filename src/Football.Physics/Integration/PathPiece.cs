namespace Football.Physics;

/// <summary>A piece of smooth motion between two instants without an event between them: dense, so it can be asked at any time inside.</summary>
/// <remarks>
/// With RK4 the path is the quintic Hermite interpolant of both ends' positions, velocities and accelerations (1e-8 m off a step of 40 ms); with
/// methods of lower order it is the quadratic that the method itself re-integrates.
/// </remarks>
public readonly struct PathPiece
{
    private readonly int _degree;

    internal PathPiece(
        double time,
        double length,
        in Vector3d startPosition,
        in Vector3d startVelocity,
        in Vector3d startAcceleration,
        in Vector3d endPosition,
        in Vector3d endVelocity,
        in Vector3d endAcceleration,
        MotionState motion,
        int degree)
    {
        Time = time;
        Length = length;
        StartPosition = startPosition;
        StartVelocity = startVelocity;
        StartAcceleration = startAcceleration;
        EndPosition = endPosition;
        EndVelocity = endVelocity;
        EndAcceleration = endAcceleration;
        Motion = motion;
        _degree = degree;
    }

    /// <summary>The degree of the path of a step: the quadratic that a method of low order itself re-integrates; else that of the Hermite interpolant.</summary>
    /// <param name="order">Order of the method.</param>
    /// <param name="hasEndAcceleration">Whether the acceleration at the end is known.</param>
    internal static int DegreeOf(int order, bool hasEndAcceleration) => order <= 2 ? 2 : hasEndAcceleration ? 5 : 3;

    /// <summary>The cubic between the ends of a step without an event in it.</summary>
    internal static PathPiece Cubic(in BallState start, in BallState end) => new(
        start.Time, end.Time - start.Time, start.Position, start.Velocity, default, end.Position, end.Velocity, default, start.Motion, 3);

    /// <summary>When it starts, s since the launch.</summary>
    public double Time { get; }

    /// <summary>How long it lasts, s.</summary>
    public double Length { get; }

    /// <summary>When it ends, s since the launch.</summary>
    public double EndTime => Time + Length;

    /// <summary>Position at the start, m.</summary>
    public Vector3d StartPosition { get; }

    /// <summary>Velocity at the start, m/s.</summary>
    public Vector3d StartVelocity { get; }

    /// <summary>Acceleration at the start, m/s².</summary>
    public Vector3d StartAcceleration { get; }

    /// <summary>Position at the end, m.</summary>
    public Vector3d EndPosition { get; }

    /// <summary>Velocity at the end, before the impact that may follow, m/s.</summary>
    public Vector3d EndVelocity { get; }

    /// <summary>Acceleration at the end, m/s².</summary>
    public Vector3d EndAcceleration { get; }

    /// <summary>What the ball is doing.</summary>
    public MotionState Motion { get; }

    /// <summary>The greatest height of the centre over the piece, m.</summary>
    public double Apex
    {
        get
        {
            double ends = Math.Max(StartPosition.Y, EndPosition.Y);
            return StartVelocity.Y > 0 && EndVelocity.Y < 0 ? Math.Max(ends, PositionAt(Time + (TurningPoint(Vector3d.Up, default) * Length)).Y) : ends;
        }
    }

    /// <summary>Where the ball is at a time of the piece, m.</summary>
    /// <param name="time">Time since the launch, s; outside the piece its curve is continued.</param>
    public Vector3d PositionAt(double time)
    {
        double t = time - Time;
        if (!(Length > 0))
        {
            return StartPosition;
        }

        double h = Length;
        double s = t / h;
        Vector3d miss = EndPosition - StartPosition - (h * StartVelocity);
        if (_degree == 2)
        {
            // p₀ + v₀ τ + (p₁ − p₀ − v₀ h) s²
            return StartPosition + (t * StartVelocity) + (s * s * miss);
        }

        if (_degree == 3)
        {
            // Cubic Hermite
            Vector3d turn = h * (EndVelocity - StartVelocity);
            return StartPosition + (t * StartVelocity) + (s * s * ((3.0 * miss) - turn + (s * (turn - (2.0 * miss)))));
        }

        // Quintic Hermite: p₀ + v₀ τ + a₀ τ²/2 + s³ (c₃ + s (c₄ + s c₅))
        QuinticTail(out Vector3d c3, out Vector3d c4, out Vector3d c5);
        return StartPosition + (t * (StartVelocity + (0.5 * t * StartAcceleration))) + (s * s * s * (c3 + (s * (c4 + (s * c5)))));
    }

    /// <summary>The velocity at a time of the piece, m/s.</summary>
    /// <param name="time">Time since the launch, s; outside the piece its curve is continued.</param>
    public Vector3d VelocityAt(double time)
    {
        double t = time - Time;
        if (!(Length > 0))
        {
            return StartVelocity;
        }

        double s = t / Length;
        if (_degree == 2)
        {
            return StartVelocity + (s * (EndVelocity - StartVelocity));
        }

        if (_degree == 3)
        {
            Vector3d miss = EndPosition - StartPosition - (Length * StartVelocity);
            Vector3d turn = Length * (EndVelocity - StartVelocity);
            return StartVelocity + (s / Length * ((6.0 * miss) - (2.0 * turn) + (3.0 * s * (turn - (2.0 * miss)))));
        }

        QuinticTail(out Vector3d c3, out Vector3d c4, out Vector3d c5);
        return StartVelocity + (t * StartAcceleration) + (s * s / Length * ((3.0 * c3) + (s * ((4.0 * c4) + (5.0 * s * c5)))));
    }

    /// <summary>The piece as seen by something that moves steadily and was at the origin at time 0.</summary>
    internal PathPiece SeenFrom(in Vector3d velocity) => new(
        Time,
        Length,
        StartPosition - (Time * velocity),
        StartVelocity - velocity,
        StartAcceleration,
        EndPosition - (EndTime * velocity),
        EndVelocity - velocity,
        EndAcceleration,
        Motion,
        _degree);

    /// <summary>When the piece passes a plane, if it does.</summary>
    /// <param name="point">A point of the plane.</param>
    /// <param name="normal">Its normal; any length.</param>
    /// <param name="time">The first time on the plane, s since the launch.</param>
    internal bool Crosses(in Vector3d point, in Vector3d normal, out double time)
    {
        double before = Vector3d.Dot(StartPosition - point, in normal);
        double after = Vector3d.Dot(EndPosition - point, in normal);
        time = Time;
        if (before == 0 || !(before < 0 != after < 0 || after == 0))
        {
            return false;
        }

        // Newton on the dense path, kept inside its bracket; the secant is a good start.
        double low = 0;
        double high = 1;
        double s = before / (before - after);
        for (int i = 0; i < 60; i++)
        {
            time = Time + (s * Length);
            double f = Vector3d.Dot(PositionAt(time) - point, in normal);
            double slope = Vector3d.Dot(PathVelocity(time), in normal) * Length;
            if (f < 0 == before < 0)
            {
                low = s;
            }
            else
            {
                high = s;
            }

            double next = s - (f / slope);
            if (!(next >= low && next <= high))
            {
                next = 0.5 * (low + high);
            }

            if (Math.Abs(next - s) < 1e-15)
            {
                break;
            }

            s = next;
        }

        return true;
    }

    /// <summary>The closest approach to a point over the piece.</summary>
    /// <param name="point">The point.</param>
    /// <param name="time">When, s since the launch.</param>
    /// <returns>The square of the distance.</returns>
    internal double ClosestApproach(in Vector3d point, out double time)
    {
        Vector3d start = StartPosition - point;
        Vector3d end = EndPosition - point;
        double startSquared = start.LengthSquared;
        double endSquared = end.LengthSquared;
        time = startSquared <= endSquared ? Time : EndTime;
        double best = Math.Min(startSquared, endSquared);

        // d|p − q|²/dt = 2 (p − q)·v changes sign from minus to plus at a nearest point.
        if (Vector3d.Dot(in start, PathVelocity(Time)) < 0 && Vector3d.Dot(in end, PathVelocity(EndTime)) > 0)
        {
            double inside = Time + (TurningPoint(default, in point) * Length);
            double squared = (PositionAt(inside) - point).LengthSquared;
            if (squared < best)
            {
                best = squared;
                time = inside;
            }
        }

        return best;
    }

    /// <summary>The velocity as the derivative of the dense path, which for methods of low order differs from the method's velocity.</summary>
    private Vector3d PathVelocity(double time)
    {
        if (_degree > 2 || !(Length > 0))
        {
            return VelocityAt(time);
        }

        double s = (time - Time) / Length;
        return StartVelocity + (2.0 * s / Length * (EndPosition - StartPosition - (Length * StartVelocity)));
    }

    /// <summary>Where in 0 … 1 the velocity along a direction, or the distance from a point when the direction is zero, turns.</summary>
    private double TurningPoint(in Vector3d direction, in Vector3d point)
    {
        bool distance = direction == Vector3d.Zero;
        double low = 0;
        double high = 1;
        double start = Turning(0, in direction, in point, distance);
        double atLow = start;
        double atHigh = Turning(1, in direction, in point, distance);
        if (start < 0 == atHigh < 0)
        {
            // A straight path, like Euler's, turns nowhere.
            return 1;
        }

        double s = 0.5;
        for (int i = 0; i < 60 && high - low > 1e-15; i++)
        {
            // Regula falsi with a bisection now and then: the function is nearly linear.
            s = i % 4 == 3 ? 0.5 * (low + high) : low + ((high - low) * atLow / (atLow - atHigh));
            double f = Turning(s, in direction, in point, distance);
            if (f == 0)
            {
                break;
            }

            if (f < 0 == start < 0)
            {
                if (s - low < 1e-15)
                {
                    break;
                }

                low = s;
                atLow = f;
            }
            else
            {
                if (high - s < 1e-15)
                {
                    break;
                }

                high = s;
                atHigh = f;
            }
        }

        return s;
    }

    private double Turning(double s, in Vector3d direction, in Vector3d point, bool distance)
    {
        double time = Time + (s * Length);
        Vector3d velocity = PathVelocity(time);
        return distance ? Vector3d.Dot(PositionAt(time) - point, in velocity) : Vector3d.Dot(in direction, in velocity);
    }

    private void QuinticTail(out Vector3d c3, out Vector3d c4, out Vector3d c5)
    {
        double h = Length;
        double hh = h * h;

        // What is left of the ends' position, velocity and acceleration after the quadratic part, in units of the step.
        Vector3d p = EndPosition - StartPosition - (h * StartVelocity) - (0.5 * hh * StartAcceleration);
        Vector3d v = (h * (EndVelocity - StartVelocity)) - (hh * StartAcceleration);
        Vector3d a = hh * (EndAcceleration - StartAcceleration);
        c3 = (10.0 * p) - (4.0 * v) + (0.5 * a);
        c4 = (-15.0 * p) + (7.0 * v) - a;
        c5 = (6.0 * p) - (3.0 * v) + (0.5 * a);
    }
}
