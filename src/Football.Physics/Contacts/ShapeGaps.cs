using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>The gap between a ball on a path and a stationary plane: a cubic in time.</summary>
internal struct PlaneGap : ICrossedGap
{
    private readonly double _c0;
    private readonly double _c1;
    private readonly double _c2;
    private readonly double _c3;
    private readonly double _bend;

    /// <summary>Prepares the gap.</summary>
    /// <param name="path">The path.</param>
    /// <param name="normal">The normal of the plane.</param>
    /// <param name="start">The gap at the start of the path, m.</param>
    public PlaneGap(in PathCubic path, in Vector3d normal, double start)
    {
        _c0 = start;
        _c1 = Vector3d.Dot(in path.C1, in normal);
        _c2 = Vector3d.Dot(in path.C2, in normal);
        _c3 = Vector3d.Dot(in path.C3, in normal);

        // The second derivative is linear in time, so it is greatest at an end.
        _bend = Math.Max(0, -2.0 * Math.Min(_c2, _c2 + (3.0 * path.Length * _c3)));
        Crosses = false;
    }

    public bool Crosses { get; set; }

    public readonly double Earliest(double t) => t;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool IsClosed(double t, out double step)
    {
        double gap = _c0 + (t * (_c1 + (t * (_c2 + (t * _c3)))));
        double rate = _c1 + (t * ((2.0 * _c2) + ((3.0 * t) * _c3)));
        bool closes = TimeOfImpact.Closes(gap, rate);
        step = closes ? 0 : TimeOfImpact.Step(gap, rate, _bend);
        return closes;
    }
}

/// <summary>The gap between a ball on a path and a collider that may be flush with the carrier of the ball.</summary>
internal interface ICrossedGap : IGap
{
    /// <summary>True after the ball has crossed a flush seam onto the collider.</summary>
    bool Crosses { get; set; }

    /// <summary>Returns the time of the contact, up to one that was found after a step along a touched surface.</summary>
    double Earliest(double t);
}

/// <summary>The gap between a ball on a path and a collider that does not rotate, in the frame of the collider.</summary>
internal struct ShapeGap : ICrossedGap
{
    private readonly Collider _collider;
    private readonly PathCubic _path;
    private readonly SearchSpan _span;
    private readonly double _radius;
    private readonly double _near;
    private readonly double _acceleration;
    private readonly double _speed;
    private readonly double _bend;
    private readonly bool _mayRise;
    private double _open;

    /// <summary>Prepares the gap.</summary>
    /// <param name="collider">The collider.</param>
    /// <param name="path">The path in the frame of the collider.</param>
    /// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
    /// <param name="radius">Radius of the ball, m.</param>
    /// <param name="span">The span of the search.</param>
    public ShapeGap(Collider collider, in PathCubic path, double acceleration, double radius, in SearchSpan span)
    {
        _collider = collider;
        _path = path;
        _span = span;
        _radius = radius;
        _acceleration = acceleration;

        // M bounds the second derivative of the gap: the acceleration of the path, plus |v|² κ/(1 − κ d) if the surface is concave with the curvature κ
        // at the distance d. A convex surface bends away from the path.
        double hollow = collider.HollowCurvature;
        _speed = path.FastestSpeed;
        _mayRise = hollow > 0 && collider.MayBend;
        _near = TimeOfImpact.NearHollow(radius, hollow);
        _bend = acceleration + (hollow > 0 ? _speed * _speed * hollow / (1.0 - ((1.0 + _near) * radius * hollow)) : 0);
        Crosses = false;
    }

    /// <inheritdoc/>
    public bool Crosses { get; set; }

    /// <inheritdoc/>
    public double Earliest(double t)
    {
        // A step along a touched surface may end below it: halve the step.
        double first = _open;
        while (_mayRise && t - first > _span.Shortest && _collider.At(_path.At(t)).Distance < _radius - ContactTolerances.Touching)
        {
            double half = 0.5 * (first + t);
            bool closed = IsClosed(half, out _);
            first = closed ? first : half;
            t = closed ? half : t;
        }

        return t;
    }

    public bool IsClosed(double t, out double step)
    {
        ShapePoint at = _collider.At(_path.At(t));
        double gap = at.Distance - _radius;
        double rate = Vector3d.Dot(_path.VelocityAt(t), at.Normal);
        step = 0;
        if (TimeOfImpact.Closes(gap, rate))
        {
            return true;
        }

        _open = t;
        step = double.PositiveInfinity;
        if (t == 0 && gap <= ContactTolerances.Touching && rate <= ContactTolerances.Leaving && _acceleration == 0)
        {
            // On a straight path, ignore a closing contact without load. If the ball ends inside the surface, a push moves it out.
            return false;
        }

        double hollow = _collider.HollowCurvature;
        if ((t == 0 || Crosses) && hollow == 0)
        {
            // A convex shape lies behind the tangent plane at its nearest point: if the path never reaches that plane, there is no contact.
            var plane = new PlaneGap(in _path, at.Normal, gap - Vector3d.Dot(_path.At(t) - _path.Start, at.Normal));
            long evaluations = 0; // not counted: they are few and cheap
            if (!(TimeOfImpact.First(ref plane, in _span, ref evaluations, t) <= _span.Until))
            {
                return false;
            }
        }

        step = TimeOfImpact.Step(gap, rate, _bend);
        if (_mayRise && gap <= ContactTolerances.Touching)
        {
            // Along a touched surface, as along the foot of a pipe, the surface may rise a little between two evaluations: a contact is then located.
            step = Math.Max(step, TimeOfImpact.Safe(ContactTolerances.RiseAlong, Math.Min(rate, 0), _bend));
        }

        // Far from a concave surface, M is invalid: bound the closing by the speed. Near it, use M only until the ball may be far again.
        if (hollow > 0)
        {
            double bySpeed = Math.Max(gap, 0) / _speed;
            step = gap < _near * _radius ? Math.Max(bySpeed, Math.Min(step, ((_near * _radius) - gap) / _speed)) : bySpeed;
        }

        return false;
    }
}

/// <summary>The gap between a ball on a path and a rotating shape.</summary>
/// <remarks>
/// The rate and the second derivative of the gap are bounded for the path in the rotating frame, where the shape is at rest.
/// </remarks>
internal readonly struct RotatingGap : IGap
{
    /// <summary>Maximum closing speed of a slow gap, m/s.</summary>
    private const double Slow = 0.01;

    private readonly MovingShape _shape;
    private readonly PathCubic _path;
    private readonly double _hollow;
    private readonly double _near;
    private readonly double _radius;
    private readonly double _closing;
    private readonly double _whole;
    private readonly double _bend;

    /// <summary>Prepares the gap.</summary>
    /// <param name="shape">The shape, from the start of the path.</param>
    /// <param name="hollow">Its largest concave curvature, 1/m.</param>
    /// <param name="path">The path.</param>
    /// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
    /// <param name="radius">Radius of the ball, m.</param>
    public RotatingGap(in MovingShape shape, double hollow, in PathCubic path, double acceleration, double radius)
    {
        _shape = shape;
        _path = path;
        _hollow = hollow;
        _radius = radius;

        // Upper bounds of the relative speed |w|, with w = v − V, and of ρ, the ball's distance from the pivot.
        PathCubic seen = path.SeenFrom(shape.Pivot, shape.Velocity);
        Bounds3d box = seen.Bounds;
        double farthest = new Vector3d(Math.Max(-box.Min.X, box.Max.X), Math.Max(-box.Min.Y, box.Max.Y), Math.Max(-box.Min.Z, box.Max.Z)).Length;
        double speed = seen.FastestSpeed;
        double spin = shape.SpinRate;

        // The gap closes at most at |w| plus the rotation speed, either of the ball about the pivot or of the shape, whichever is smaller.
        double around = spin * farthest;
        _closing = speed + Math.Min(around, shape.Swing);

        // Seen from the shape, which turns with Ω, the ball at ρ accelerates by q̈ = a − 2 Ω × w + Ω × (Ω × ρ). A convex surface bends away from the path;
        // one with a concave curvature κ at the distance d bends towards it by |q̇|² κ/(1 − κ d).
        _whole = speed + around;
        double bend = acceleration + (spin * ((2.0 * speed) + around));
        _near = TimeOfImpact.NearHollow(radius, hollow);
        bend += hollow > 0 ? _whole * _whole * hollow / (1.0 - ((1.0 + _near) * radius * hollow)) : 0;
        _bend = bend;
    }

    public bool IsClosed(double t, out double step)
    {
        double gap = _shape.Distance(_path.At(t), _path.VelocityAt(t), t, out double rate) - _radius;
        step = 0;
        if (TimeOfImpact.Closes(gap, rate))
        {
            return true;
        }

        // Use the longer of two safe steps: by the speed bound, and by the acceleration bound. On concave surfaces, the latter only holds near the surface.
        double byBend = TimeOfImpact.Safe(Math.Max(gap, 0) + (rate > -Slow ? ContactTolerances.SlowSink : 0), rate, _bend);
        byBend = !(_hollow > 0) ? byBend : gap < _near * _radius ? Math.Min(byBend, ((_near * _radius) - gap) / _whole) : 0;
        step = Math.Max(byBend, Math.Max(gap, 0) / _closing);
        return false;
    }
}
