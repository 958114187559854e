using System.Runtime.CompilerServices;

namespace FootballPhysics.Laws;

/// <summary>Spin decay proportional to speed times spin, T_D = −(β π ρ r⁴ |u| + I ε ρ/1.2) ω. It never reverses a spin.</summary>
internal struct ProportionalSpinDecay : IAirLaw
{
    /// <summary>β. Measured on golf balls (Smits and Smith 1994), scaled. For footballs a guess, 0.003 … 0.012.</summary>
    public const double Beta = 0.0096;

    /// <summary>ε, in 1/s: the decay rate in still air of density 1.2. Guess, 0.003 … 0.006.</summary>
    public const double AtRest = 0.004;

    private double _perMetre; // β π ρ r⁴ / I, 1/m
    private double _atRest; // ε ρ/1.2, 1/s

    public readonly RateBound Bound => new(_perMetre, 0, _atRest);

    /// <summary>Reads the rates of the scene. A constant decay does not grow with the speed; without decay, both rates are 0.</summary>
    public void Prepare(Scene scene)
    {
        ForceLaw kind = scene.Forces.SpinDecay;
        if (kind != ForceLaw.Empirical)
        {
            _perMetre = 0;
            _atRest = kind == ForceLaw.Constant ? ConstantSpinDecay.Scale(scene) : 0;
            return;
        }

        double r = scene.Ball.Radius;
        _perMetre = Beta * Math.PI * scene.Air.Density * r * r * r * r / scene.Ball.MomentOfInertia;
        _atRest = AtRest * scene.Air.Density / 1.2;
    }

    /// <summary>Returns the decay rate, in 1/s: ω̇ = −(β π ρ r⁴/I |u| + ε ρ/1.2) ω.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double PerSpin(double speed) => (_perMetre * speed) + _atRest;

    public readonly double Factor(in AirFlow flow) => PerSpin(flow.Speed) * flow.SpinRate;
}
