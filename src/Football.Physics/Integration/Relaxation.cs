namespace Football.Physics;

/// <summary>
/// A step of implicit Euler for air that is far stronger than the ball's inertia: stable at any length, it ends in the balance of
/// forces that the motion relaxes to. Without wind it never gains energy, and it never reverses a spin.
/// </summary>
/// <remarks>
/// u₁ = u₀ + h (a − D u₁ + L ω̂ × u₁) with D and L at the end, u₁ in closed form for given D and L, and |u₁| by halving. Then
/// ω₁ = ω₀ − h decay(|u₁|, ω₁), or 0. With p₁ = p₀ + h u₁ the energy changes by −½ m |u₁ − u₀|² − m h D |u₁|².
/// </remarks>
internal struct Relaxation<TAir>
    where TAir : struct, IAerodynamics
{
    /// <summary>Factors beyond this are as good as infinite, 1/s; their products stay finite.</summary>
    private const double Infinite = 1e300;

    private const double Slowest = 1e-12;
    private const double Fastest = 1e150;
    private const int Halvings = 64;

    public TAir Air;
    public double RadiusSquared;
    public int Evaluations;

    /// <summary>The air velocity after h.</summary>
    /// <param name="from">Air velocity at the start, m/s.</param>
    /// <param name="push">Acceleration that is not the air's, m/s².</param>
    /// <param name="axis">Unit axis of the spin.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="h">Length, s.</param>
    public Vector3d Velocity(in Vector3d from, in Vector3d push, in Vector3d axis, double spin, double h)
    {
        Vector3d b = from + (h * push);
        Vector3d along = Vector3d.Dot(in b, in axis) * axis;
        Vector3d across = b - along;
        double low = Slowest;
        double high = Fastest;
        for (int i = 0; i < Halvings; i++)
        {
            // The speeds reach over hundreds of orders of magnitude: halve their logarithm.
            double middle = Math.Sqrt(low) * Math.Sqrt(high);
            if (Size(At(middle, in along, in across, in axis, spin, h)) > middle)
            {
                low = middle;
            }
            else
            {
                high = middle;
            }
        }

        return At(high, in along, in across, in axis, spin, h);
    }

    /// <summary>The spin after h.</summary>
    /// <param name="from">Spin at the start, rad/s, not negative.</param>
    /// <param name="speed">Air speed, m/s.</param>
    /// <param name="h">Length, s.</param>
    public double Spin(double from, double speed, double h)
    {
        if (!Air.SpinDecays || from <= 0)
        {
            return from;
        }

        double low = 0;
        double high = from;
        for (int i = 0; i < Halvings && high > 0; i++)
        {
            double middle = 0.5 * (low + high);
            Factors(speed, middle, out _, out _, out double decay);
            if (middle + (h * decay) < from)
            {
                low = middle;
            }
            else
            {
                high = middle;
            }
        }

        return low;
    }

    private Vector3d At(double speed, in Vector3d along, in Vector3d across, in Vector3d axis, double spin, double h)
    {
        Factors(speed, spin, out double drag, out double lift, out _);

        // (1 + h D) u − h L ω̂ × u = b
        double damping = 1.0 + (h * drag);
        double turn = h * lift / damping;
        double shrink = 1.0 / (1.0 + (turn * turn)) / damping;
        return (along / damping) + (shrink * across) + (turn * shrink * Vector3d.Cross(in axis, in across));
    }

    private void Factors(double speed, double spin, out double drag, out double lift, out double decay)
    {
        double speedSquared = speed * speed;
        Air.Begin(spin, DragJump.At(speedSquared, RadiusSquared * spin * spin).Branch, out AirStep step);
        Air.Evaluate(in step, speedSquared, spin, speedSquared, out drag, out lift, out decay);
        drag = drag < Infinite ? drag : Infinite;
        lift = lift < Infinite ? (lift > -Infinite ? lift : -Infinite) : Infinite;
        decay = decay < Infinite ? decay : Infinite;
        Evaluations++;
    }

    /// <summary>The length of a vector whose square may be beyond what a double holds.</summary>
    private static double Size(in Vector3d v)
    {
        double largest = Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
        return largest is > 1e-100 and < 1e100 ? v.Length : largest > 0 ? largest * (v / largest).Length : 0;
    }
}
