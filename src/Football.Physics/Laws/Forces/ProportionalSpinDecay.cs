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

    /// <summary>Reads the rates of the scene; without decay, both are 0.</summary>
    public void Prepare(Scene scene)
    {
        double r = scene.Ball.Radius;
        double density = scene.Forces.SpinDecay == ForceLaw.None ? 0 : scene.Air.Density;
        _perMetre = Beta * Math.PI * density * r * r * r * r / scene.Ball.MomentOfInertia;
        _atRest = AtRest * density / 1.2;
    }

    /// <summary>Returns the decay rate, in 1/s: ω̇ = −(β π ρ r⁴/I |u| + ε ρ/1.2) ω.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double PerSpin(double speed) => (_perMetre * speed) + _atRest;

    public readonly double Factor(in AirFlow flow) => PerSpin(flow.Speed) * flow.SpinRate;
}
