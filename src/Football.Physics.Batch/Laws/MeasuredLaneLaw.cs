using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The measured laws in lanes, by their own equations. <see cref="MeasuredLaw"/> defines them.</summary>
/// <remarks>They are <see cref="ReynoldsDrag"/>, <see cref="SpinDrag"/>, <see cref="SaturatingLift"/> and <see cref="ProportionalSpinDecay"/>.</remarks>
#if NET8_0_OR_GREATER
internal struct MeasuredLaneLaw<F> : ILaneLaw<F>
    where F : struct, ILane<F>
#else
internal struct MeasuredLaneLaw<TLane> : ILaneLaw<TLane>
#endif
{
    /// <summary>The |u|², in m²/s², below which the spin parameter stays constant: there is almost no force.</summary>
    private const float LeastSpeedSquared = 1e-6f;

    /// <summary>The exponent, as 2^±this, at which a share of the flow is clamped, so that neither it nor its inverse overflows.</summary>
    private const float Beyond = 100f;

    private float _dragScale; // ½ ρ A / m, 1/m
    private float _spinDrag; // ½ ρ A / m D, 1/m
    private float _lift; // ½ ρ A / m r L
    private float _radiusSquared; // r², m²
    private float _perSpeed; // 2r/ν log₂e/Re_s, s/m
    private float _crisis; // Re_c log₂e/Re_s
    private float _riseFrom; // Re₀ log₂e/Re_s
    private float _shift; // 2^((Re₀ − Re_c) log₂e/Re_s)
    private float _subcritical; // a − b₀
    private float _supercritical; // b₀
    private float _slope; // (b₁ − b₀)/(Re₁ − Re₀) Re_s/log₂e
    private float _decayPerMetre; // β π ρ r⁴ / I, 1/m
    private float _decayAtRest; // ε ρ/1.2, 1/s

    public readonly bool Acts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public readonly bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public readonly bool NeedsSpinAcross
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public void Prepare(Scene scene)
    {
        DragCurve curve = scene.Ball.DragCurve;
        double radius = scene.Ball.Radius;
        double perReynolds = Elementary.Log2E / curve.Width;
        double scale = AirScale.DynamicArea(scene);
        double drag = scene.Forces.Drag == ForceLaw.None ? 0 : scale;
        _dragScale = (float)drag;
        _spinDrag = (float)(drag * SpinDrag.Limit);
        _lift = scene.Forces.Magnus == ForceLaw.None ? 0 : (float)(scale * radius * SaturatingLift.Limit);
        _radiusSquared = (float)(radius * radius);
        _perSpeed = (float)(2.0 * radius / scene.Air.KinematicViscosity * perReynolds);
        _crisis = (float)(curve.CriticalReynolds * perReynolds);
        _riseFrom = (float)(curve.RiseFrom * perReynolds);
        _shift = (float)Elementary.Exp((curve.RiseFrom - curve.CriticalReynolds) / curve.Width);
        _subcritical = (float)(curve.Subcritical - curve.Supercritical);
        _supercritical = (float)curve.Supercritical;
        _slope = (float)((curve.Risen - curve.Supercritical) / (curve.RiseTo - curve.RiseFrom) / perReynolds);
        if (scene.Forces.SpinDecay != ForceLaw.None)
        {
            ProportionalSpinDecay decay = default;
            decay.Prepare(scene);
            _decayAtRest = (float)decay.PerSpin(0);
            _decayPerMetre = (float)(decay.PerSpin(1) - decay.PerSpin(0));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Begin(F spin, out LaneSpin<F> step) => step = default;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>
    {
        F one = F.Of(1f);
        F speed = F.Sqrt(speedSquared);
        F reynolds = _perSpeed * speed;

        // q = σ((Re − Re_c)/Re_s) = 1/(1 + x),  σ(−(Re − Re₀)/Re_s) = x/(x + 2^shift)
        F x = LaneMath<F>.Exp2(F.AtLeast(F.AtMost(reynolds - F.Of(_crisis), F.Of(Beyond)), F.Of(-Beyond)));
        F share = one / (one + x);
        F rise = ((_slope * (reynolds - F.Of(_riseFrom))) * x) / (x + F.Of(_shift));
        F coefficient = (F.Of(_supercritical) + (_subcritical * share)) + rise;

        // S² = A/B:  S/√(S² + S_D²) = √(A/(A + S_D² B)),  1/√(S² + S₀²) = √B/√(A + S₀² B)
        F squared = F.AtLeast(speedSquared, F.Of(LeastSpeedSquared));
        F a = (_radiusSquared * (spin * spin)) * acrossSquared;
        F b = squared * squared;
        F bySpin = F.Sqrt(a / (a + ((float)(SpinDrag.Scale * SpinDrag.Scale) * b)));
        F perSpin = squared / F.Sqrt(a + ((float)(SaturatingLift.Scale * SaturatingLift.Scale) * b));

        // D = ½ρA/m |u| (C_D + D …(1 − (1 − κ₀) q)),  L = ½ρA/m r|ω| C_L/S
        F ofDrag = one - ((float)(1 - SpinDrag.Subcritical) * share);
        F ofLift = one - ((float)(1 - SaturatingLift.Subcritical) * share);
        drag = ((_dragScale * coefficient) + ((_spinDrag * ofDrag) * bySpin)) * speed;
        lift = ((_lift * spin) * ofLift) * perSpin;

        // ω̇ = −(β π ρ r⁴/I |u| + ε ρ/1.2) ω
        decay = ((_decayPerMetre * speed) + F.Of(_decayAtRest)) * spin;
    }
}
