using System.Runtime.CompilerServices;

namespace FootballPhysics.Numerics;

/// <summary>A path of degree up to five in s, the elapsed share of its duration: c₀ + c₁ s + … + c₅ s⁵, 0 ≤ s ≤ 1.</summary>
internal readonly struct PathPolynomial
{
    /// <summary>The coefficients, in m.</summary>
    public readonly Vector3d C0;
    public readonly Vector3d C1;
    public readonly Vector3d C2;
    public readonly Vector3d C3;
    public readonly Vector3d C4;
    public readonly Vector3d C5;

    private PathPolynomial(in Vector3d c0, in Vector3d c1, in Vector3d c2, in Vector3d c3, in Vector3d c4, in Vector3d c5)
    {
        C0 = c0;
        C1 = c1;
        C2 = c2;
        C3 = c3;
        C4 = c4;
        C5 = c5;
    }

    /// <summary>Returns a straight path at constant speed.</summary>
    public static PathPolynomial Line(in Vector3d from, in Vector3d to) => new(in from, to - from, default, default, default, default);

    /// <summary>Returns the interpolant of the values at both ends.</summary>
    /// <param name="start">The position at the start, in m.</param>
    /// <param name="startVelocity">The velocity at the start, in m/s.</param>
    /// <param name="startAcceleration">The acceleration at the start, in m/s²; only the quintic uses it.</param>
    /// <param name="end">The position at the end, in m.</param>
    /// <param name="endVelocity">The velocity at the end, in m/s; the quadratic does not use it.</param>
    /// <param name="endAcceleration">The acceleration at the end, in m/s²; only the quintic uses it.</param>
    /// <param name="length">The duration, in s.</param>
    /// <param name="degree">2: the quadratic of a low-order method; 3: the cubic; 5: the quintic.</param>
    public static PathPolynomial Between(
        in Vector3d start,
        in Vector3d startVelocity,
        in Vector3d startAcceleration,
        in Vector3d end,
        in Vector3d endVelocity,
        in Vector3d endAcceleration,
        double length,
        int degree)
    {
        // The deviations from uniform motion at the end, as lengths.
        Vector3d way = length * startVelocity;
        Vector3d rise = end - start - way;
        Vector3d turn = length * (endVelocity - startVelocity);
        switch (degree)
        {
            case 2:
                return new PathPolynomial(in start, in way, in rise, default, default, default);
            case 3:
                return new PathPolynomial(in start, in way, (3.0 * rise) - turn, turn - (2.0 * rise), default, default);
            default:
                Bend(in start, in startVelocity, in startAcceleration, in end, in endVelocity, in endAcceleration, length, out Vector3d c3, out Vector3d c4, out Vector3d c5);
                return new PathPolynomial(in start, in way, 0.5 * (length * length) * startAcceleration, in c3, in c4, in c5);
        }
    }

    /// <summary>Computes the coefficients c₃ to c₅ of the quintic: its deviation from uniformly accelerated motion.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Bend(
        in Vector3d start,
        in Vector3d startVelocity,
        in Vector3d startAcceleration,
        in Vector3d end,
        in Vector3d endVelocity,
        in Vector3d endAcceleration,
        double length,
        out Vector3d c3,
        out Vector3d c4,
        out Vector3d c5)
    {
        // The deviations at the end, as lengths.
        double squared = length * length;
        Vector3d p = end - start - (length * startVelocity) - (0.5 * squared * startAcceleration);
        Vector3d v = (length * (endVelocity - startVelocity)) - (squared * startAcceleration);
        Vector3d a = squared * (endAcceleration - startAcceleration);
        c3 = (10.0 * p) - (4.0 * v) + (0.5 * a);
        c4 = (-15.0 * p) + (7.0 * v) - a;
        c5 = (6.0 * p) - (3.0 * v) + (0.5 * a);
    }

    /// <summary>A bounding box: that of the control points.</summary>
    public Bounds3d Bounds
    {
        get
        {
            Span<Vector3d> points = stackalloc Vector3d[6];
            Points(points);
            Bounds3d box = Bounds3d.Nowhere;
            foreach (ref readonly Vector3d point in points)
            {
                box = box.Union(new Bounds3d(point, point));
            }

            return box;
        }
    }

    /// <summary>An upper bound of |dp/ds|, in m.</summary>
    public double FastestSpeed
    {
        get
        {
            Span<Vector3d> points = stackalloc Vector3d[5];
            Velocities(points);
            return Longest(points);
        }
    }

    /// <summary>An upper bound of |d²p/ds²|, in m.</summary>
    public double GreatestAcceleration
    {
        get
        {
            Span<Vector3d> points = stackalloc Vector3d[4];
            Accelerations(points);
            return Longest(points);
        }
    }

    /// <summary>Returns the position, in m.</summary>
    public Vector3d At(double s) => C0 + (s * (C1 + (s * (C2 + (s * (C3 + (s * (C4 + (s * C5)))))))));

    /// <summary>Returns dp/ds, in m.</summary>
    public Vector3d RateAt(double s) => C1 + (s * ((2.0 * C2) + (s * ((3.0 * C3) + (s * ((4.0 * C4) + (5.0 * s * C5)))))));

    /// <summary>Computes the six control points of the Bézier form, b_i = Σ_j (i over j)/(n over j) c_j: the path stays in their convex hull.</summary>
    public void Points(Span<Vector3d> into)
    {
        into[0] = C0;
        into[1] = C0 + (0.2 * C1);
        into[2] = C0 + (0.4 * C1) + (0.1 * C2);
        into[3] = C0 + (0.6 * C1) + (0.3 * C2) + (0.1 * C3);
        into[4] = C0 + (0.8 * C1) + (0.6 * C2) + (0.4 * C3) + (0.2 * C4);
        into[5] = C0 + C1 + C2 + C3 + C4 + C5;
    }

    /// <summary>Computes the five control points of dp/ds = c₁ + 2 c₂ s + 3 c₃ s² + 4 c₄ s³ + 5 c₅ s⁴.</summary>
    public void Velocities(Span<Vector3d> into)
    {
        into[0] = C1;
        into[1] = C1 + (0.5 * C2);
        into[2] = C1 + C2 + (0.5 * C3);
        into[3] = C1 + (1.5 * C2) + (1.5 * C3) + C4;
        into[4] = C1 + (2.0 * C2) + (3.0 * C3) + (4.0 * C4) + (5.0 * C5);
    }

    /// <summary>Computes the four control points of d²p/ds² = 2 c₂ + 6 c₃ s + 12 c₄ s² + 20 c₅ s³.</summary>
    public void Accelerations(Span<Vector3d> into)
    {
        into[0] = 2.0 * C2;
        into[1] = into[0] + (2.0 * C3);
        into[2] = into[0] + (4.0 * C3) + (4.0 * C4);
        into[3] = into[0] + (6.0 * C3) + (12.0 * C4) + (20.0 * C5);
    }

    private static double Longest(Span<Vector3d> points)
    {
        double squared = 0;
        foreach (ref readonly Vector3d point in points)
        {
            squared = Math.Max(squared, point.LengthSquared);
        }

        return Math.Sqrt(squared);
    }
}
