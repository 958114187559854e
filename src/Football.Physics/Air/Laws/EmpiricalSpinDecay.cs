using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Spin decay by skin friction on two plates (Tuplin; thesis 2.11 to 2.15, with |U±|).</summary>
internal struct EmpiricalSpinDecay : IAirLaw
{
    private static readonly PowerTable Power18 = new(1.8);

    private double _k; // (r/2) ρ π r² 0.0074 (2r/ν)^(−1/5) / I
    private double _halfRadius;

    public readonly bool Acts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly bool NeedsFit
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool NeedsSpeed
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    // Near zero spin the torque does not fade: what it could reverse is caught where it happens. Fast spins decay at a rate below 1.8 k U^0.8.
    public readonly RateBound Bound => new(_k * _halfRadius, _k * _halfRadius, 0);

    /// <summary>Angular deceleration by one plate at 1 m/s, rad/s².</summary>
    public readonly double Plate => _k;

    /// <summary>|u|^1.8.</summary>
    public static double OfSpeed(double speed) => Power18.Of(speed);

    /// <summary>Both plates over that, (1 + Sp/2)^1.8 + |1 − Sp/2|^1.8.</summary>
    public static double OfSpin(double spinParameter)
    {
        double plate = 0.5 * spinParameter;
        return Power18.Of(1.0 + plate) + Power18.Of(Math.Abs(1.0 - plate));
    }

    public void Prepare(Scene scene)
    {
        double r = scene.Ball.Radius;
        _halfRadius = 0.5 * r;
        _k = 0.5 * r * scene.Air.Density * Math.PI * r * r * 0.0074
            * Elementary.Pow(2.0 * r / scene.Air.KinematicViscosity, -0.2) / scene.Ball.MomentOfInertia;
    }

    // T_D = (r/2) ρ π r² (U₊² C₊ + U₋² C₋), U± = abs(|u| ± r|ω|/2), C± = 0.0074 (U± 2r/ν)^(−1/5), so U² C ∝ U^1.8
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double Factor(in AirFlow flow)
    {
        double plate = _halfRadius * flow.SpinRate;
        return _k * (Power18.Of(flow.Speed + plate) + Power18.Of(Math.Abs(flow.Speed - plate)));
    }
}
