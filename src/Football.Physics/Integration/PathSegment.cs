using System.Runtime.CompilerServices;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A segment of smooth motion between two events, with a path that can be evaluated at any time.</summary>
/// <remarks>
/// With RK4 the path is the quintic Hermite interpolant of the positions, velocities and accelerations at both ends. Its error is 1e-8 m for a step of 40 ms.
/// With lower-order methods, the path is the quadratic that the method itself integrates.
/// </remarks>
public struct PathSegment
{
    /// <summary>The correction, as a fraction of a segment, at which a search ends: a few hundred times the rounding error.</summary>
    private const double Closeness = 1e-13;

    private int _degree;
    private double _time;
    private double _length;
    private Vector3d _startPosition;
    private Vector3d _startVelocity;
    private Vector3d _startAcceleration;
    private Vector3d _endPosition;
    private Vector3d _endVelocity;
    private Vector3d _endAcceleration;
    private MotionState _motion;

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
        _time = time;
        _length = length;
        _startPosition = startPosition;
        _startVelocity = startVelocity;
        _startAcceleration = startAcceleration;
        _endPosition = endPosition;
        _endVelocity = endVelocity;
        _endAcceleration = endAcceleration;
        _motion = motion;
        _degree = degree;
    }

    /// <summary>Returns the degree of the path of a step: that of a low-order method's quadratic, otherwise that of the Hermite interpolant.</summary>
    /// <param name="order">The order of the method.</param>
    /// <param name="hasEndAcceleration">True if the acceleration at the end is known.</param>
    internal static int DegreeOf(int order, bool hasEndAcceleration) => order <= 2 ? 2 : hasEndAcceleration ? 5 : 3;

    /// <summary>Completes a segment whose acceleration at the end was not known.</summary>
    internal static void Close(ref PathSegment open, in Vector3d endAcceleration)
    {
        open._endAcceleration = endAcceleration;
    }

    /// <summary>Writes a segment of flight to its position in a buffer. A constructed segment would be copied there.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Write(
        ref PathSegment to,
        double time,
        double length,
        in Vector3d startPosition,
        in Vector3d startVelocity,
        in Vector3d startAcceleration,
        in Vector3d endPosition,
        in Vector3d endVelocity,
        int degree)
    {
        to._degree = degree;
        to._time = time;
        to._length = length;
        to._startPosition = startPosition;
        to._startVelocity = startVelocity;
        to._startAcceleration = startAcceleration;
        to._endPosition = endPosition;
        to._endVelocity = endVelocity;
        to._motion = MotionState.Airborne;
    }

    /// <summary>Writes a segment without air, with constant acceleration, to its position in a buffer.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void WriteFall(ref PathSegment to, in BallState start, double h, double end, double climb, double height, double upward, int degree)
    {
        double vx = start.Flight.Velocity.X;
        double vz = start.Flight.Velocity.Z;
        double x = start.Position.X;
        double z = start.Position.Z;
        to._degree = degree;
        to._time = start.Time;
        to._length = end - start.Time;
        to._startPosition = new Vector3d(x, start.Position.Y, z);
        to._startVelocity = new Vector3d(vx, start.Flight.Velocity.Y, vz);
        to._startAcceleration = new Vector3d(0, upward, 0);
        to._endPosition = new Vector3d(x + (h * vx), height, z + (h * vz));
        to._endVelocity = new Vector3d(vx, climb, vz);
        to._endAcceleration = new Vector3d(0, upward, 0);
        to._motion = MotionState.Airborne;
    }

    /// <summary>Returns the cubic between two positions with velocities, from time 0.</summary>
    internal static PathSegment Cubic(in Vector3d start, in Vector3d velocity, in Vector3d end, in Vector3d endVelocity, double length) =>
        new(0, length, in start, in velocity, default, in end, in endVelocity, default, MotionState.Airborne, 3);

    /// <summary>Returns the cubic between the ends of a step without events.</summary>
    internal static PathSegment Cubic(in BallState start, in BallState end) => new(
        start.Time, end.Time - start.Time, start.Position, start.Velocity, default, end.Position, end.Velocity, default, start.Motion, 3);

    /// <summary>The degree of the polynomial in time.</summary>
    internal readonly int Degree => _degree;

    /// <summary>The start time, in s since the launch.</summary>
    public readonly double Time => _time;

    /// <summary>The duration, in s.</summary>
    public readonly double Length => _length;

    /// <summary>The end time, in s since the launch.</summary>
    public readonly double EndTime => Time + Length;

    /// <summary>The position at the start, in m.</summary>
    internal readonly Vector3d StartPosition => _startPosition;

    /// <summary>The velocity at the start, in m/s.</summary>
    internal readonly Vector3d StartVelocity => _startVelocity;

    /// <summary>The acceleration at the start, in m/s².</summary>
    internal readonly Vector3d StartAcceleration => _startAcceleration;

    /// <summary>The position at the end, in m.</summary>
    internal readonly Vector3d EndPosition => _endPosition;

    /// <summary>The velocity at the end, in m/s; if the segment ends with an impact, the velocity before it.</summary>
    internal readonly Vector3d EndVelocity => _endVelocity;

    /// <summary>The acceleration at the end, in m/s².</summary>
    internal readonly Vector3d EndAcceleration => _endAcceleration;

    /// <summary>The motion of the ball: in flight, sliding, rolling, at rest or pinned.</summary>
    public readonly MotionState Motion => _motion;

    /// <summary>The greatest height of the ball's centre, in m.</summary>
    public readonly double Apex
    {
        get
        {
            double ends = Math.Max(StartPosition.Y, EndPosition.Y);
            return StartVelocity.Y > 0 && EndVelocity.Y < 0 ? Math.Max(ends, PositionAt(TurningTime(new PlaneApproach(in this, Vector3d.Up, true))).Y) : ends;
        }
    }

    /// <summary>The time at which the centre is highest, in s since the launch.</summary>
    internal readonly double ApexTime => StartVelocity.Y > 0 && EndVelocity.Y < 0 ? TurningTime(new PlaneApproach(in this, Vector3d.Up, true)) : StartPosition.Y > EndPosition.Y ? Time : EndTime;

    /// <summary>Returns the position of the ball's centre at a time, in m.</summary>
    /// <param name="time">The time since the launch, in s; outside the segment the curve is extrapolated.</param>
    public readonly Vector3d PositionAt(double time)
    {
        double t = time - Time;
        if (!(Length > 0))
        {
            return StartPosition;
        }

        // p₀, v₀ and a₀ are position, velocity and acceleration at the start; c₂ … c₅ are the coefficients of Bend.
        // p₀ + v₀ t + s² (c₂ + s c₃) or p₀ + v₀ t + a₀ t²/2 + s³ (c₃ + s (c₄ + s c₅)), s = t / length
        double s = t / Length;
        if (_degree == 5)
        {
            Bend(out Vector3d c3, out Vector3d c4, out Vector3d c5);
            return StartPosition + (t * (StartVelocity + (0.5 * t * StartAcceleration))) + (s * s * s * (c3 + (s * (c4 + (s * c5)))));
        }

        PathPolynomial c = Curve;
        return StartPosition + (t * StartVelocity) + (s * s * (c.C2 + (s * c.C3)));
    }

    /// <summary>Returns the velocity at a time, in m/s.</summary>
    /// <param name="time">The time since the launch, in s; outside the segment the curve is extrapolated.</param>
    public readonly Vector3d VelocityAt(double time)
    {
        // The velocity of a low-order method is not the derivative of its path.
        return _degree == 2 && Length > 0 ? StartVelocity + ((time - Time) / Length * (EndVelocity - StartVelocity)) : PathVelocity(time);
    }

    /// <summary>Returns the segment relative to an object with constant velocity that was at the origin at time 0.</summary>
    internal readonly PathSegment SeenFrom(in Vector3d velocity) => new(
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

    /// <summary>Finds the time at which the segment crosses a plane. False if it does not.</summary>
    /// <param name="point">A point on the plane.</param>
    /// <param name="normal">The normal of the plane; any length.</param>
    /// <param name="time">The first time on the plane, in s since the launch.</param>
    internal readonly bool Crosses(in Vector3d point, in Vector3d normal, out double time)
    {
        double before = Vector3d.Dot(StartPosition - point, in normal);
        double after = Vector3d.Dot(EndPosition - point, in normal);
        time = Time;

        // A segment that starts on the plane does not cross it.
        if (before == 0)
        {
            return false;
        }

        double end = 1;
        if (!(before < 0 != after < 0 || after == 0))
        {
            // The path may cross the plane and return, in which case it turns behind the plane.
            var approach = new PlaneApproach(in this, in normal, before > 0);
            approach.Evaluate(0, out double atStart);
            approach.Evaluate(1, out double atEnd);
            if (!(atStart < 0 && atEnd > 0))
            {
                return false;
            }

            // Before the turn, there is exactly one crossing.
            end = Roots.Illinois(ref approach, 0, atStart, 1, atEnd, Closeness, EventLocator.MostSteps);
            after = Vector3d.Dot(PositionAt(Time + (end * Length)) - point, in normal);
            if (before < 0 == after < 0)
            {
                return false;
            }
        }

        // Apply Newton's method to the path, starting from the secant estimate.
        var distance = new PlaneDistance(in this, in point, in normal, before > 0);
        time = Time + (Roots.Newton(ref distance, 0, end, end * before / (before - after)) * Length);
        return true;
    }

    /// <summary>Finds the closest approach to a point.</summary>
    /// <param name="point">The point.</param>
    /// <param name="time">The time of the closest approach, in s since the launch.</param>
    /// <returns>The squared distance.</returns>
    internal readonly double ClosestApproach(in Vector3d point, out double time)
    {
        Vector3d start = StartPosition - point;
        Vector3d end = EndPosition - point;
        double startSquared = start.LengthSquared;
        double endSquared = end.LengthSquared;
        time = startSquared <= endSquared ? Time : EndTime;
        double best = Math.Min(startSquared, endSquared);

        // At a nearest point, d|p − q|²/dt = 2 (p − q)·v changes from negative to positive.
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

    /// <summary>Returns the derivative of the path. For methods of low order it differs from the method's velocity.</summary>
    private readonly Vector3d PathVelocity(double time)
    {
        if (!(Length > 0))
        {
            return StartVelocity;
        }

        double t = time - Time;
        double s = t / Length;
        if (_degree == 5)
        {
            Bend(out Vector3d c3, out Vector3d c4, out Vector3d c5);
            return StartVelocity + (t * StartAcceleration) + (s * s / Length * ((3.0 * c3) + (s * ((4.0 * c4) + (5.0 * s * c5)))));
        }

        PathPolynomial c = Curve;
        return StartVelocity + (s / Length * ((2.0 * c.C2) + (3.0 * s * c.C3)));
    }

    /// <summary>Computes the deviation of the quintic from uniformly accelerated motion, without the rest of the <see cref="Curve"/>.</summary>
    private readonly void Bend(out Vector3d c3, out Vector3d c4, out Vector3d c5) => PathPolynomial.Bend(
        in _startPosition, in _startVelocity, in _startAcceleration, in _endPosition, in _endVelocity, in _endAcceleration, _length, out c3, out c4, out c5);

    /// <summary>The path as a polynomial in the elapsed share of the segment.</summary>
    internal readonly PathPolynomial Curve => PathPolynomial.Between(
        in _startPosition, in _startVelocity, in _startAcceleration, in _endPosition, in _endVelocity, in _endAcceleration, _length, _degree);

    /// <summary>Returns the time at which a nearly linear rate changes its sign; the end if it does not, as on a straight path.</summary>
    private readonly double TurningTime<TRate>(TRate rate)
        where TRate : struct, IFunction
    {
        rate.Evaluate(0, out double atStart);
        rate.Evaluate(1, out double atEnd);
        return Time + ((atStart < 0 == atEnd < 0 ? 1 : Roots.Illinois(ref rate, 0, atStart, 1, atEnd, Closeness, EventLocator.MostSteps)) * Length);
    }

    /// <summary>The distance from a plane over fractions of a segment, positive at the start.</summary>
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

    /// <summary>The rate of the distance from a plane, on the side of the start, over fractions of a segment.</summary>
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

    /// <summary>Half the rate of the squared distance from a point, over fractions of a segment.</summary>
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
