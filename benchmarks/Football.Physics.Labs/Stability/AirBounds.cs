namespace FootballPhysics.Labs.Stability;

/// <summary>Bounds of the air's effect on a scene's ball, from the equations of its laws.</summary>
/// <remarks>
/// With k = ½ρA/m, s = r|ω|, Sp = s/|u|: drag is −k C_D |u| u, the Magnus force k C_L |u| (ω̂ × u) or, with a constant coefficient, 2 k C_M s (ω̂ × u).
/// A force f(|u|) along û has the slope f′ and the curvature f″; one across it is turned by as much and stretches by half of |u| (f/|u|)′.
/// </remarks>
internal sealed class AirBounds(Scene scene)
{
    private const double CriticalSpeed = 12.19;

    /// <summary>C_D0, the largest coefficient without spin.</summary>
    private const double AtRest = 0.501;

    /// <summary>The maximum of (C_D0 − C_D)/(C_D0 − a): 1, plus a little for the regularised law, which mixes in a C_D with spin below a.</summary>
    private const double LargestDeficit = 1.0001;

    /// <summary>Between these speeds, m/s, the drag crisis changes the coefficients.</summary>
    private const double CrisisFrom = 8;
    private const double CrisisTo = 18;

    private readonly ForceSet _forces = scene.Forces;
    private readonly bool _regularised = scene.Forces.Coefficients == AerodynamicModel.Regularized;
    private readonly double _scale = 0.5 * scene.Air.Density * Area(scene.Ball) / scene.Ball.Mass;
    private readonly double _radius = scene.Ball.Radius;
    private readonly DragCurve _curve = scene.Ball.DragCurve;
    private readonly double _perSpeed = 2 * scene.Ball.Radius / scene.Air.KinematicViscosity; // 2r/ν, s/m

    // ω̇ = k ω / I, or (r/2) ρ A 0.0074 (2r/ν)^(−1/5) (U₊^1.8 + U₋^1.8) / I with U± ≤ |u| + s/2
    private readonly double _spinDecay = scene.Forces.SpinDecay switch
    {
        ForceLaw.None => 0,
        ForceLaw.Constant => scene.Forces.SpinDecayCoefficient / scene.Ball.MomentOfInertia,
        ForceLaw.Empirical => scene.Ball.Radius * scene.Air.Density * Area(scene.Ball) * 0.0074 * Math.Pow(2 * scene.Ball.Radius / scene.Air.KinematicViscosity, -0.2)
            / scene.Ball.MomentOfInertia,
        _ => throw new ArgumentOutOfRangeException(nameof(scene)),
    };

    /// <summary>True if the share of spin that a ball loses per time is the same at every speed and spin.</summary>
    public bool SpinDecaysEvenly => _forces.SpinDecay != ForceLaw.Empirical;

    /// <summary>Returns the highest rate of spin loss, as a share, 1/s.</summary>
    /// <param name="fast">Highest air speed, m/s.</param>
    /// <param name="slowSurface">Lowest s = r|ω|, m/s.</param>
    /// <param name="fastSurface">Highest s, m/s.</param>
    public double SpinDecay(double fast, double slowSurface, double fastSurface) =>
        SpinDecaysEvenly || !(_spinDecay > 0 && fastSurface > 0) ? _spinDecay : _spinDecay * Math.Pow(fast + (0.5 * fastSurface), 1.8) * _radius / slowSurface;

    /// <summary>Returns the maximum of |A|, m/s².</summary>
    /// <param name="speed">Highest air speed, m/s.</param>
    /// <param name="surface">Highest s, m/s.</param>
    public double Size(double speed, double surface) =>
        _forces.Coefficients == AerodynamicModel.Measured ? MeasuredSize(speed, surface) : Over(speed, speed, surface, surface).Size;

    /// <summary>Returns the maximum by the measured laws: C_D grows with the Reynolds number without limit, C_L is 0.32 at most.</summary>
    private double MeasuredSize(double speed, double surface)
    {
        double beyond = Math.Max(0, (_perSpeed * speed) - _curve.RiseFrom) * (_curve.Risen - _curve.Supercritical) / (_curve.RiseTo - _curve.RiseFrom);
        double drag = _forces.Drag switch
        {
            ForceLaw.None => 0,
            ForceLaw.Constant => _forces.DragCoefficient,
            _ => Math.Max(_curve.Subcritical, _curve.Supercritical) + beyond + 0.30,
        };
        double lift = _forces.Magnus switch
        {
            ForceLaw.None => 0,
            ForceLaw.Constant => 2 * Math.Abs(_forces.MagnusCoefficient) * surface * speed,
            _ => 0.32 * speed * speed,
        };
        return _scale * ((drag * speed * speed) + lift);
    }

    /// <summary>Returns the bounds over a range of speeds and spins.</summary>
    /// <param name="slow">Lowest air speed, m/s.</param>
    /// <param name="fast">Highest air speed, m/s.</param>
    /// <param name="slowSurface">Lowest s, m/s.</param>
    /// <param name="fastSurface">Highest s, m/s.</param>
    public AirBound Over(double slow, double fast, double slowSurface, double fastSurface) =>
        _scale > 0 ? _scale * (Drag(slow, fast, fastSurface) + Magnus(slow, fast, slowSurface, fastSurface)) : default;

    private AirBound Drag(double slow, double fast, double s)
    {
        if (_forces.Drag == ForceLaw.None)
        {
            return default;
        }

        if (_forces.Drag == ForceLaw.Constant)
        {
            // f = C_D u²
            double c = _forces.DragCoefficient;
            return new AirBound(c * fast * fast, 2 * c * fast, 2 * c * fast, 2 * c, 0);
        }

        // No spin, f = C_D(u) u²: 2 C_D + u C_D′ ≤ 2 C_D0 since C_D falls; 2 C_D + 4 u C_D′ + u² C_D″ ≤ 6.
        // Spin, f = c s^d u^(2−d) with d = 0.3056; with s^d u^(1−d) growing with u, and u^(−d) falling.
        double bySpin = 0.4127 * Math.Pow(s, 0.3056) * Math.Pow(fast, 1 - 0.3056);
        double bend = 0.4127 * Math.Pow(Share(s, slow), 0.3056);
        var law = new AirBound(
            (AtRest * fast * fast) + (bySpin * fast),
            (2 * AtRest * fast) + (1.7 * bySpin),
            (2 * AtRest * fast) + (1.7 * bySpin),
            6 + (1.2 * bend),
            0.3056 * bySpin * fast);
        if (!_regularised)
        {
            return law;
        }

        // C_D = w C₁ + (1 − w) C₀: |C₁ − C₀| u w′ with u w′ ≤ v_c/(4 · 0.25) at the critical speed and ≤ 0.05/(4 · 0.0025) at the critical spin.
        double between = (0.346 * fast) + bySpin;
        return law + new AirBound(0, 18 * between, 18 * between, 400 * (0.346 + bend), 5 * between * fast);
    }

    private AirBound Magnus(double slow, double fast, double slowSurface, double s)
    {
        if (_forces.Magnus == ForceLaw.None)
        {
            return default;
        }

        if (_forces.Magnus == ForceLaw.Constant)
        {
            // f = 2 C_M s u: it turns every velocity at the same rate.
            double rate = 2 * Math.Abs(_forces.MagnusCoefficient) * s;
            return new AirBound(rate * fast, rate, 0, 0, rate * fast);
        }

        // f = 1.15 s^0.83 u^1.17 D with the deficit D = (C_D0 − C_D)/(C_D0 − a). Without spin D is 1/(1 + exp((v_c − u)/1.309)), which grows with u. With spin, and only
        // beyond the critical speed, |u D′| = d c Sp^d/(C_D0 − a) ≤ 0.45, and u² |D″| ≤ 0.6.
        bool crisis = fast > CrisisFrom && slow < CrisisTo;
        double deficit = fast < CriticalSpeed ? Logistic((fast - CriticalSpeed) / 1.309) : LargestDeficit;
        double change = fast < CrisisFrom ? 6.2 * deficit : crisis ? 2.4 : 0.45;
        double bend = fast < CrisisFrom ? 40 * deficit : crisis ? 11 : 2.3;
        double perSpin = fast < CrisisFrom ? 0 : 0.45;
        if (_regularised)
        {
            // The share of the weight: u w′ |C₁ − C₀|/(C_D0 − a).
            deficit = Math.Min(LargestDeficit, deficit + Logistic((fast - CriticalSpeed) / 0.25));
            change += crisis ? 16 : fast < CrisisFrom ? 1e-5 : 0.4;
            bend += crisis ? 330 : fast < CrisisFrom ? 1e-3 : 3;
            perSpin += crisis ? 2.4 : fast < CrisisFrom ? 1e-5 : 0.4;
        }

        double lift = 1.15 * Math.Pow(s, 0.83) * Math.Pow(fast, 0.17);
        double atSlow = 1.15 * Math.Pow(Share(s, slow), 0.83);

        // Where C_D reaches C_D0 the lift has a kink of unbounded curvature: with spin at Sp = 1.886, and later if less of that law is mixed in.
        bool kink = fast > CrisisFrom && s > 1.8 * slow && (_regularised || slowSurface < 1.95 * fast);
        return new AirBound(
            lift * fast * deficit,
            lift * ((1.17 * deficit) + change),
            0.5 * lift * ((0.17 * deficit) + change),
            kink ? double.PositiveInfinity : atSlow * ((0.2 * deficit) + (2.34 * change) + bend),
            lift * fast * ((0.83 * deficit) + perSpin));
    }

    private static double Area(BallProperties ball) => Math.PI * ball.Radius * ball.Radius;

    /// <summary>Returns the maximum of Sp; 0 without spin, even at rest.</summary>
    private static double Share(double surface, double slow) => surface > 0 ? surface / slow : 0;

    private static double Logistic(double x) => 1 / (1 + Math.Exp(-x));
}

/// <summary>Upper bounds of the air's acceleration A(u, ω) of a ball, and of its derivatives, over a range of speeds and spins. J is ∂A/∂u.</summary>
/// <param name="Size">|A|, m/s².</param>
/// <param name="Slope">‖J‖, 1/s.</param>
/// <param name="Stretch">The symmetric part of J, 1/s: it makes a velocity longer or shorter. It is 0 for a force that only turns the velocity.</param>
/// <param name="Curvature">‖∂²A/∂u²‖, 1/m.</param>
/// <param name="BySpin">|∂A/∂ ln ω|, m/s².</param>
internal readonly record struct AirBound(double Size, double Slope, double Stretch, double Curvature, double BySpin)
{
    public static AirBound operator +(in AirBound a, in AirBound b) =>
        new(a.Size + b.Size, a.Slope + b.Slope, a.Stretch + b.Stretch, a.Curvature + b.Curvature, a.BySpin + b.BySpin);

    public static AirBound operator *(double k, in AirBound a) => new(k * a.Size, k * a.Slope, k * a.Stretch, k * a.Curvature, k * a.BySpin);
}
