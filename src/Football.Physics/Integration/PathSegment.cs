namespace FootballPhysics.Prediction;

/// <summary>A piece of smooth motion between two instants without an event between them: dense, so it can be asked at any time inside.</summary>
/// <remarks>
/// With RK4 the path is the quintic Hermite interpolant of both ends' positions, velocities and accelerations (1e-8 m off a step of 40 ms); with
/// methods of lower order it is the quadratic that the method itself re-integrates.
/// </remarks>
public readonly struct PathSegment
{
    /// <summary>A fraction of a piece is known when the next correction is below this: a few hundred times the rounding of its ends.</summary>
    private const double Closeness = 1e-13;
    private const int MostEvaluations = 60;

    private readonly int _degree;

    internal PathSegment(
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
    internal static PathSegment Cubic(in BallState start, in BallState end) => new(
        start.Time, end.Time - start.Time, start.Position, start.Velocity, default, end.Position, end.Velocity, default, start.Motion, 3);

    /// <summary>Degree of its polynomial in time.</summary>
    internal int Degree => _degree;

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

    /// <summary>The motion of the ball: in the air, sliding, rolling or at rest.</summary>
    public MotionState Motion { get; }

    /// <summary>The greatest height of the centre over the piece, m.</summary>
    public double Apex
    {
        get
        {
            double ends = Math.Max(StartPosition.Y, EndPosition.Y);
            return StartVelocity.Y > 0 && EndVelocity.Y < 0 ? Math.Max(ends, PositionAt(TurningTime(new Climb(in this))).Y) : ends;
        }
    }

    /// <summary>When the centre is highest, s since the launch.</summary>
    internal double ApexTime => StartVelocity.Y > 0 && EndVelocity.Y < 0 ? TurningTime(new Climb(in this)) : StartPosition.Y > EndPosition.Y ? Time : EndTime;

    /// <summary>Where the ball is at a time of the piece, m.</summary>
    /// <param name="time">Time since the launch, s; outside the piece its curve is continued.</param>
    public Vector3d PositionAt(double time)
    {
        double t = time - Time;
        if (!(Length > 0))
        {
            return StartPosition;
        }

        if (_degree == 2)
        {
            // p₀ + v₀ τ + (p₁ − p₀ − v₀ h) s²
            double s = t / Length;
            return StartPosition + (t * StartVelocity) + (s * s * (EndPosition - StartPosition - (Length * StartVelocity)));
        }

        return _degree == 3 ? CubicCurve.PositionAt(t) : QuinticCurve.PositionAt(t);
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

        return _degree == 2 ? StartVelocity + (t / Length * (EndVelocity - StartVelocity))
            : _degree == 3 ? CubicCurve.VelocityAt(t)
            : QuinticCurve.VelocityAt(t);
    }

    /// <summary>The piece as seen by something that moves steadily and was at the origin at time 0.</summary>
    internal PathSegment SeenFrom(in Vector3d velocity) => new(
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

        // From the plane itself it does not cross it.
        if (before == 0)
        {
            return false;
        }

        double end = 1;
        if (!(before < 0 != after < 0 || after == 0))
        {
            // It may pass the plane and come back: then it turns behind it.
            var approach = new PlaneApproach(in this, in normal, before > 0);
            approach.Evaluate(0, out double atStart);
            approach.Evaluate(1, out double atEnd);
            if (!(atStart < 0 && atEnd > 0))
            {
                return false;
            }

            // Up to where it turns there is one crossing.
            end = Roots.Illinois(ref approach, 0, atStart, 1, atEnd, Closeness, MostEvaluations);
            after = Vector3d.Dot(PositionAt(Time + (end * Length)) - point, in normal);
            if (before < 0 == after < 0)
            {
                return false;
            }
        }

        // The secant is a good start for Newton on the dense path.
        var distance = new PlaneDistance(in this, in point, in normal, before > 0);
        time = Time + (Roots.Newton(ref distance, 0, end, end * before / (before - after)) * Length);
        return true;
    }

    /// <summary>When the piece comes back through a plane that it crossed, if it does.</summary>
    /// <param name="point">A point of the plane.</param>
    /// <param name="normal">Its normal; any length.</param>
    /// <param name="crossed">When it crossed it first, s since the launch.</param>
    /// <param name="time">When it comes back.</param>
    internal bool CrossesBack(in Vector3d point, in Vector3d normal, double crossed, out double time)
    {
        double before = Vector3d.Dot(StartPosition - point, in normal);
        double after = Vector3d.Dot(EndPosition - point, in normal);
        time = crossed;
        if (before < 0 != after < 0 || after == 0)
        {
            return false;
        }

        // Behind the plane it turns, and from there it comes back once.
        double low = (crossed - Time) / Length;
        var approach = new PlaneApproach(in this, in normal, before > 0);
        approach.Evaluate(low, out double atCrossing);
        approach.Evaluate(1, out double atEnd);
        double turn = atCrossing < 0 && atEnd > 0 ? Roots.Illinois(ref approach, low, atCrossing, 1, atEnd, Closeness, MostEvaluations) : low;
        var distance = new PlaneDistance(in this, in point, in normal, before < 0);

        // The secant from the turn behind the plane to the end before it, for a first guess.
        distance.Evaluate(turn, out double behind, out _);
        double start = behind > 0 ? turn + ((1 - turn) * behind / (behind + Math.Abs(after))) : turn;
        time = Time + (Roots.Newton(ref distance, turn, 1, start) * Length);
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
            double inside = TurningTime(new Recession(in this, in point));
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

    private CubicHermite3d CubicCurve => new(StartPosition, StartVelocity, EndPosition, EndVelocity, Length);

    private QuinticHermite3d QuinticCurve =>
        new(StartPosition, StartVelocity, StartAcceleration, EndPosition, EndVelocity, EndAcceleration, Length);

    /// <summary>When a rate, which is nearly linear over the piece, changes its sign; the end where it does not: a straight path turns nowhere.</summary>
    private double TurningTime<TRate>(TRate rate)
        where TRate : struct, IFunction
    {
        rate.Evaluate(0, out double atStart);
        rate.Evaluate(1, out double atEnd);
        return Time + ((atStart < 0 == atEnd < 0 ? 1 : Roots.Illinois(ref rate, 0, atStart, 1, atEnd, Closeness, MostEvaluations)) * Length);
    }

    /// <summary>Distance from a plane over fractions of a piece, positive where the piece begins.</summary>
    private readonly struct PlaneDistance : IDifferentiableFunction
    {
        private readonly PathSegment _piece;
        private readonly Vector3d _point;
        private readonly Vector3d _normal;

        public PlaneDistance(in PathSegment piece, in Vector3d point, in Vector3d normal, bool positive)
        {
            _piece = piece;
            _point = point;
            _normal = positive ? normal : -normal;
        }

        public bool Evaluate(double x, out double value, out double slope)
        {
            double time = _piece.Time + (x * _piece.Length);
            value = Vector3d.Dot(_piece.PositionAt(time) - _point, in _normal);
            slope = Vector3d.Dot(_piece.PathVelocity(time), in _normal) * _piece.Length;
            return Math.Abs(value / slope) < Closeness;
        }
    }

    /// <summary>How fast the distance from a plane grows on the side where the piece begins, over fractions of it.</summary>
    private readonly struct PlaneApproach : IFunction
    {
        private readonly PathSegment _piece;
        private readonly Vector3d _normal;

        public PlaneApproach(in PathSegment piece, in Vector3d normal, bool positive)
        {
            _piece = piece;
            _normal = positive ? normal : -normal;
        }

        public bool Evaluate(double x, out double value)
        {
            value = Vector3d.Dot(_piece.PathVelocity(_piece.Time + (x * _piece.Length)), in _normal);
            return false;
        }
    }

    /// <summary>Vertical velocity over fractions of a piece.</summary>
    private readonly struct Climb : IFunction
    {
        private readonly PathSegment _piece;

        public Climb(in PathSegment piece) => _piece = piece;

        public bool Evaluate(double x, out double value)
        {
            value = _piece.PathVelocity(_piece.Time + (x * _piece.Length)).Y;
            return false;
        }
    }

    /// <summary>Half the rate of change of the squared distance from a point, over fractions of a piece.</summary>
    private readonly struct Recession : IFunction
    {
        private readonly PathSegment _piece;
        private readonly Vector3d _point;

        public Recession(in PathSegment piece, in Vector3d point)
        {
            _piece = piece;
            _point = point;
        }

        public bool Evaluate(double x, out double value)
        {
            double time = _piece.Time + (x * _piece.Length);
            value = Vector3d.Dot(_piece.PositionAt(time) - _point, _piece.PathVelocity(time));
            return false;
        }
    }
}
