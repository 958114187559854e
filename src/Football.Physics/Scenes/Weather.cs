using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>The weather, which determines the density and viscosity of the air.</summary>
/// <remarks>The density is within 0.05 % of the CIPM-2007 formula in its range of validity.</remarks>
public sealed record Weather
{
    /// <summary>The pressure at sea level, in Pa (law: standard atmosphere).</summary>
    private const double SeaLevelPressure = 101_325;

    /// <summary>The specific gas constant of dry air, in J/(kg K) (law: ideal gas).</summary>
    internal const double DryGas = 287.058;

    /// <summary>The temperature t, in °C. −60 … 60; default 20.</summary>
    public double Temperature { get; init; } = 20;

    /// <summary>The relative humidity h. 0 … 1; default 0.5.</summary>
    public double Humidity { get; init; } = 0.5;

    /// <summary>The pressure p, in Pa. 10 000 … 120 000; default 101 325.</summary>
    public double Pressure { get; init; } = SeaLevelPressure;

    /// <summary>Returns the weather at an altitude, for standard pressure at sea level.</summary>
    /// <param name="altitude">The altitude z, in m. −500 … 11 000.</param>
    /// <param name="temperature">The temperature at that altitude, in °C.</param>
    /// <param name="humidity">The relative humidity at that altitude, 0 … 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The altitude is out of range; the message names field, value and range.</exception>
    public static Weather AtAltitude(double altitude, double temperature = 20, double humidity = 0.5)
    {
        Check.Within("air.weather.altitude", altitude, -500, 11_000);

        // z is the altitude in m, and p₀ the pressure at sea level.
        // p = p₀ (1 − 0.0065 z/288.15)^5.255880
        double pressure = SeaLevelPressure * Elementary.Pow(1.0 - (0.0065 * altitude / 288.15), 5.255880);
        return new Weather { Temperature = temperature, Humidity = humidity, Pressure = pressure };
    }

    /// <summary>Returns the air of this weather, without wind.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Air ToAir()
    {
        // The formulas below are valid in these ranges.
        Check.Within("air.weather.temperature", Temperature, -60, 60);
        Check.Within("air.weather.humidity", Humidity, 0, 1);
        Check.Within("air.weather.pressure", Pressure, 10_000, 120_000);

        // h is the relative humidity, t the temperature in °C, and p the pressure.
        // e_w = min(h · 611.2 exp(17.62 t/(243.12 + t)), p), the vapour pressure (Magnus formula).
        double saturated = 611.2 * Elementary.Exp(17.62 * Temperature / (243.12 + Temperature));
        double vapour = Math.Min(Humidity * saturated, Pressure);

        // R is the gas constant of dry air, and T the temperature in K.
        // ρ = (p − e_w)/(R T) + e_w/(461.495 T)
        double kelvin = Temperature + 273.15;
        double density = ((Pressure - vapour) / (DryGas * kelvin)) + (vapour / (461.495 * kelvin));

        // μ is the dynamic viscosity, and ν the kinematic one.
        // μ = 1.458e-6 T^1.5/(T + 110.4) (Sutherland), ν = μ/ρ
        double viscosity = 1.458e-6 * kelvin * Math.Sqrt(kelvin) / (kelvin + 110.4);
        return new Air { Density = density, KinematicViscosity = viscosity / density };
    }
}
