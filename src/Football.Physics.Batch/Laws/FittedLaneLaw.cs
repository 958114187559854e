using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The laws fitted to measurements in lanes. <see cref="MixedLaws"/> defines them.</summary>
/// <remarks>
/// One polynomial in a logarithm replaces each power of speed and spin over the entire domain. The domain is |u|² from ½ m²/s² and r|ω| from 2^−12 m/s up to
/// the limits of <see cref="LaneDomain"/>. Below it the powers stay constant, which their other factors make harmless.
/// </remarks>
#if NET8_0_OR_GREATER
internal struct FittedLaneLaw<F, TFit> : ILaneLaw<F>
    where F : struct, ILane<F>
    where TFit : struct, ILaneDragFit<F>
#else
internal struct FittedLaneLaw<TLane, TFit> : ILaneLaw<TLane>
    where TFit : struct, ILaneDragFit<TLane>
#endif
{
    private const float LeastSpeedSquared = 0.5f;
    private const float LeastSurfaceSpeed = 1f / 4096f;

    // The polynomials are centred on log₂ of a typical shot, |u| = 19 m/s and r|ω| = 2 m/s, where coefficient rounding matters least.
    private const float SpeedCentre = 8.5f;
    private const float SpinCentre = 1f;

    // The law with spin holds for |u| > v_c and Sp > 0.05. The regularized form uses it slightly below, here down to half of each.
    private const double LeastSpinningSpeed = 0.5 * FittedDrag.CriticalSpeed;
    private const double LeastSpinningSurfaceSpeed = LeastSpinningSpeed * 0.5 * FittedDrag.CriticalSpin;

    private const double PlateExponent = (double)EmpiricalSpinDecay.SpeedExponent;
    private const float DragSecond = (float)(FittedDrag.D * (FittedDrag.D - 1) / 2);
    private const float LiftSecond = (float)(EmpiricalMagnus.Beta * (EmpiricalMagnus.Beta - 1) / 2);

    private float _radius;
    private float _dragScale;     // ½ ρ A / m, 1/m
    private float _liftScale;     // ½ ρ A / m · 1.15/(C_D0 − a) · r, and what is taken out of the powers
    private float _plates;        // p (p − 1)/2 · r²/4, p the plates' exponent
    private float _leastSpinning; // the smallest log₂ r|ω| at which the law with spin is evaluated
    private LanePolynomial _dragBySpin;  // c (r|ω|)^d
    private LanePolynomial _dragBySpeed; // |u|^(−d)
    private LanePolynomial _liftBySpin;  // (r|ω|)^(β−1)
    private LanePolynomial _liftBySpeed; // |u|^(1−β)
    private LanePolynomial _decay;       // the plates' torque per I without spin, over |u|²

    public readonly bool Acts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TFit).Jumps;
    }

    public readonly bool NeedsSpinAcross
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public void Prepare(Scene scene)
    {
        // At unit speed, spin parameter and coefficients, the laws return their scales; a disabled law returns 0.
        AirFlow unit = default;
        unit.Speed = 1;
        double decay = SceneLaws.SpinDecay(scene).Factor(in unit);
        unit.SpinParameter = 1;
        unit.FittedDragCoefficient = 1;
        double drag = SceneLaws.Drag(scene).Factor(in unit);
        unit.FittedDragCoefficient = FittedDrag.AtRest - 1;
        double lift = SceneLaws.Magnus(scene).Factor(in unit);

        double radius = scene.Ball.Radius;
        const double OfDrag = FittedDrag.D;
        const double OfLift = 1 - EmpiricalMagnus.Beta;
        const double OfDecay = 2 - PlateExponent;
        _radius = (float)radius;
        _dragScale = (float)drag;
        _liftScale = (float)(lift * radius * Two(OfLift * ((0.5 * SpeedCentre) - SpinCentre)));
        _plates = (float)(0.5 * PlateExponent * (PlateExponent - 1) * 0.25 * radius * radius);

        // With z = log₂ x minus its centre, x^q = 2^(q centre) 2^(q z): the first factor goes into the scale.
        double low = Log2(LeastSpeedSquared) - SpeedCentre;
        double high = Log2(LaneDomain.GreatestSpeed * LaneDomain.GreatestSpeed) - SpeedCentre;
        double spinning = Log2(LeastSpinningSpeed * LeastSpinningSpeed) - SpeedCentre;
        _dragBySpeed = LanePolynomial.OfPower(1, -0.5 * OfDrag, spinning, high, 6);
        _liftBySpeed = LanePolynomial.OfPower(1, 0.5 * OfLift, low, high, 6);
        _decay = LanePolynomial.OfPower(decay * Two(-0.5 * OfDecay * SpeedCentre), -0.5 * OfDecay, low, high, 5);

        low = Log2(LeastSurfaceSpeed) - SpinCentre;
        high = Log2(LaneDomain.GreatestSurfaceSpeed) - SpinCentre;
        spinning = Log2(LeastSpinningSurfaceSpeed) - SpinCentre;
        _leastSpinning = (float)spinning;
        _dragBySpin = LanePolynomial.OfPower(FittedDrag.C * Two(OfDrag * (SpinCentre - (0.5 * SpeedCentre))), OfDrag, spinning, high, 7);
        _liftBySpin = LanePolynomial.OfPower(1, -OfLift, low, high, 8);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Begin(F spin, out LaneSpin<F> step)
    {
        F one = F.Of(1f);
        F spins = F.Less(default, spin);
        F z = LaneMath<F>.Log2(F.AtLeast(_radius * spin, F.Of(LeastSurfaceSpeed)), SpinCentre);
        F zz = z * z;
        step.Rate = spin;
        step.PerRate = F.Select(spins, one / F.Select(spins, spin, one), default);
        step.Lift = (_liftScale * spin) * LaneMath<F>.Degree8(in _liftBySpin, z, zz, zz * zz);
        z = F.AtLeast(z, F.Of(_leastSpinning));
        zz = z * z;
        step.Drag = LaneMath<F>.Degree7(in _dragBySpin, z, zz, zz * zz);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>
    {
        F one = F.Of(1f);
        F speed = F.Sqrt(speedSquared);
        F z = LaneMath<F>.Log2(F.AtLeast(speedSquared, F.Of(LeastSpeedSquared)), SpeedCentre);
        F zz = z * z;
        F zzzz = zz * zz;

        // (1 + δ)^q to second order, because the spin hardly changes within a step.
        F delta = F.AtLeast((spin - step.Rate) * step.PerRate, F.Of(-1f));
        F squared = delta * delta;

        // C_D = c (r|ω|)^d |u|^(−d) on the branch with spin.
        F coefficient = default;
        if (!(default(TFit).Jumps && branch.NoneWithSpin))
        {
            F onDrag = F.Parabola(delta, squared, 1f, (float)FittedDrag.D, DragSecond);
            coefficient = (step.Drag * onDrag) * LaneMath<F>.Degree6(in _dragBySpeed, z, zz, zzzz);
        }

        if (!(default(TFit).Jumps && default(TBranch).AllWithSpin))
        {
            coefficient = default(TFit).Join(in branch, speed, _radius * spin, coefficient, WithoutSpin(speed));
        }

        // D = k C_D |u|,  L = k 1.15/(C_D0 − a) Sp^β |u| max(C_D0 − C_D, 0)
        F onLift = F.Parabola(delta, squared, 1f, (float)EmpiricalMagnus.Beta, LiftSecond);
        drag = (_dragScale * coefficient) * speed;
        lift = ((step.Lift * onLift) * LaneMath<F>.Degree6(in _liftBySpeed, z, zz, zzzz))
            * F.AtLeast(F.Of((float)FittedDrag.AtRest) - coefficient, default);

        // ω̇ = −k' |u|^p ((1 + x)^p + |1 − x|^p)/2, x = r|ω|/(2|u|): 1 + p (p − 1)/2 x² within 1.3 % for x up to 1
        decay = LaneMath<F>.Degree5(in _decay, z, zz, zzzz) * F.Plus(speedSquared, _plates * spin, spin);
    }

    /// <summary>C_D = a + b / (1 + exp((|u| − v_c)/v_s)).</summary>
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private static F WithoutSpin(F speed)
    {
        F x = (speed - F.Of((float)FittedDrag.CriticalSpeed)) * F.Of((float)(Elementary.Log2E / FittedDrag.SpeedScale));
        return F.Of((float)FittedDrag.A) + (F.Of((float)FittedDrag.B) / (F.Of(1f) + LaneMath<F>.Exp2(F.AtMost(x, F.Of(100f)))));
    }

    private static double Log2(double x) => Elementary.Log(x) * Elementary.Log2E;

    private static double Two(double x) => Elementary.Exp(x / Elementary.Log2E);
}
