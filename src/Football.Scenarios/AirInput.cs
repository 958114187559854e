using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenes;

namespace FootballPhysics.Scenarios;

/// <summary>Reads the air of a scenario: density and viscosity, or the weather that determines them; a steady wind, or a wind profile over height.</summary>
public static class AirInput
{
    /// <summary>Reads the air.</summary>
    /// <param name="air">The object "air".</param>
    /// <param name="defaults">The values of members that are not given.</param>
    /// <param name="groundHeight">The height of the ground, in m.</param>
    public static Air Air(InputObject air, Air defaults, double groundHeight)
    {
        bool byHeight = air.IsObject("wind");
        air.Exclude("density", "weather");
        air.Exclude("kinematicViscosity", "weather");
        Air still = air.Has("weather") ? Weather(air.Object("weather")).ToAir() : defaults;
        return air.Numbers(SceneFields.Air, still) with
        {
            Wind = byHeight ? Vector3d.Zero : air.Vector("wind", defaults.Wind),
            WindField = byHeight ? Wind(air.Object("wind"), groundHeight) : null,
        };
    }

    private static Weather Weather(InputObject weather)
    {
        var defaults = new Weather();
        weather.Exclude("pressure", "altitude");
        double temperature = weather.Number("temperature", defaults.Temperature);
        double humidity = weather.Number("humidity", defaults.Humidity);
        double pressure = weather.Number("pressure", defaults.Pressure);
        double altitude = weather.Number("altitude", 0);
        return weather.Has("altitude")
            ? FootballPhysics.Weather.AtAltitude(altitude, temperature, humidity)
            : new Weather { Temperature = temperature, Humidity = humidity, Pressure = pressure };
    }

    private static WindByHeight? Wind(InputObject wind, double groundHeight)
    {
        var defaults = new WindByHeight(0, 1, 0);
        double speed = wind.Number("speed");
        double[] direction = wind.Numbers("direction", "[x, z]", 2);
        double referenceHeight = wind.Number("referenceHeight", defaults.ReferenceHeight);
        double roughness = wind.Number("roughness", defaults.Roughness);
        Gusts? gusts = wind.Has("gusts") ? Gusts(wind.Object("gusts")) : null;
        return !wind.Has("speed") || !wind.Has("direction") ? null : new WindByHeight(speed, direction[0], direction[1], referenceHeight, roughness, gusts, groundHeight);
    }

    private static Gusts Gusts(InputObject gusts)
    {
        var defaults = new Gusts();
        return new Gusts
        {
            Seed = gusts.OptionalWhole("seed") ?? defaults.Seed,
            Intensity = gusts.Number("intensity", defaults.Intensity),
            Length = gusts.Number("length", defaults.Length),
        };
    }
}
