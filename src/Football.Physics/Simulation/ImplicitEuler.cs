namespace Football.Physics;

/// <summary>
/// A step of implicit Euler for air that is far stronger than the ball's inertia: stable at any length, it ends in the balance of
/// forces that the motion relaxes to. Without wind it never gains energy, and it never reverses a spin.
/// </summary>
/// <remarks>
/// u₁ = u₀ + h (a − D u₁ + L ω̂ × u₁) with D and L at the end, u₁ in closed form for given D and L, and |u₁| by the Illinois method. Then
/// ω₁ = ω₀ − h decay(|u₁|, ω₁), or 0. With p₁ = p₀ + h u₁ the energy changes by −½ m |u₁ − u₀|² − m h D |u₁|².
/// </remarks>
internal struct ImplicitEuler
{
    /// <summary>Factors beyond this are as good as infinite, 1/s; their products stay finite.</summary>
    private const double Infinite = 1e300;

    private const double Slowest = 1e-12;

    /// <summary>A speed is known to this share.</summary>
    private const double Closeness = 1e-14;
    private const int MostEvaluations = 64;
    private const double Vanishing = 1e-300;
    private const double LogarithmOfNothing = -700;
    private const int Halvings = 64;

    public SceneAir Air;
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

        // |u| ≤ |b|, since lift does no work and drag takes: at |b| drag and lift are taken at no less than the speed that they lead to.
        double most = Size(in b);
        if (!(most > Slowest))
        {
            return At(most, in along, in across, in axis, spin, h);
        }

        // Over hundreds of orders of magnitude; and powers of the speed are straight lines in logarithms.
        var excess = new Excess { Relaxation = this, Along = along, Across = across, Axis = axis, Spin = spin, Length = h };
        double high = Elementary.Log(most);
        double low = Elementary.Log(Slowest);
        excess.Evaluate(low, out double atLow);
        if (atLow > 0)
        {
            excess.Evaluate(high, out double atHigh);
            Roots.Illinois(ref excess, low, atLow, high, atHigh, Closeness, MostEvaluations);
        }

        Evaluations = excess.Relaxation.Evaluations;
        return excess.Result;
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

        var tooMuch = new TooMuchSpin { Relaxation = this, From = from, Speed = speed, Length = h };
        double low = 0;
        double high = from;
        Roots.Bisect(ref tooMuch, ref low, ref high, Halvings);
        Evaluations = tooMuch.Relaxation.Evaluations;
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
        Air.Factors(speedSquared, spin, speedSquared, DragJump.At(speedSquared, RadiusSquared * spin * spin).Branch, out drag, out lift, out decay);
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

    /// <summary>Logarithm of the speed that drag and lift lead to, over the one at which they are taken.</summary>
    private struct Excess : IFunction
    {
        public ImplicitEuler Relaxation;
        public Vector3d Along;
        public Vector3d Across;
        public Vector3d Axis;
        public double Spin;
        public double Length;

        /// <summary>The velocity that they lead to.</summary>
        public Vector3d Result;

        public bool Evaluate(double x, out double value)
        {
            Result = Relaxation.At(Elementary.Exp(x), in Along, in Across, in Axis, Spin, Length);
            double size = Size(in Result);
            value = size > Vanishing ? Elementary.Log(size) - x : LogarithmOfNothing;
            return false;
        }
    }

    /// <summary>The spin at which the decay is taken is no less than the one that it leaves.</summary>
    private struct TooMuchSpin : ICondition
    {
        public ImplicitEuler Relaxation;
        public double From;
        public double Speed;
        public double Length;

        public bool Evaluate(double x, out bool holds)
        {
            Relaxation.Factors(Speed, x, out _, out _, out double decay);
            holds = !(x + (Length * decay) < From);
            return false;
        }
    }
}
