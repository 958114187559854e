namespace FootballPhysics.Tests.Scenes;

/// <summary>Density and viscosity of the air by weather, against values worked out with another calculator.</summary>
public sealed class WeatherTests
{
    [Theory]
    [InlineData(0, 20, 0.5, 1.198846, 1.5126e-5)]
    [InlineData(0, -5, 0.8, 1.3147, 1.2864e-5)]
    [InlineData(0, 35, 0.6, 1.1311, 1.6659e-5)]
    [InlineData(2240, 20, 0.4, 0.9127, 1.9869e-5)] // Mexico City
    [InlineData(3640, 12, 0.4, 0.7865, 2.2568e-5)] // La Paz
    [InlineData(1172, 25, 0.5, 1.0214, 1.7987e-5)] // Brasília
    public void Density_and_viscosity_follow_from_the_weather(double altitude, double temperature, double humidity, double density, double viscosity)
    {
        Air air = Weather.AtAltitude(altitude, temperature, humidity).ToAir();
        Assert.Equal(density, air.Density, density > 1.19 && density < 1.2 ? 5e-7 : 5e-5);
        Assert.Equal(viscosity, air.KinematicViscosity, 5.1e-10);
        Assert.Equal(Vector3d.Zero, air.Wind);
    }

    [Fact]
    public void At_sea_level_the_pressure_is_that_of_the_standard_atmosphere()
    {
        Assert.Equal(new Weather(), Weather.AtAltitude(0));
        Assert.Equal(new Weather().ToAir(), new Weather { Temperature = 20, Humidity = 0.5, Pressure = 101_325 }.ToAir());
        Assert.Equal(89_874.6, Weather.AtAltitude(1000).Pressure, 0.5);
    }

    [Fact]
    public void High_altitude_is_the_weather_of_Mexico_City() =>
        Assert.Equal(Weather.AtAltitude(2240, 20, 0.4).ToAir(), Scene.HighAltitude.Air);

    /// <summary>Steam alone: the vapour is no more than all of the air.</summary>
    [Fact]
    public void Vapour_has_at_most_the_pressure_of_the_air() =>
        Assert.Equal(10_000 / (461.495 * 333.15), new Weather { Temperature = 60, Humidity = 1, Pressure = 10_000 }.ToAir().Density, 1e-12);

    [Theory]
    [InlineData(-61, 0.5, 101_325, "air.weather.temperature is -61; allowed: -60 … 60")]
    [InlineData(20, 1.1, 101_325, "air.weather.humidity is 1.1; allowed: 0 … 1")]
    [InlineData(20, double.NaN, 101_325, "air.weather.humidity is NaN; allowed: 0 … 1")]
    [InlineData(20, 0.5, 1013, "air.weather.pressure is 1013; allowed: 10000 … 120000")]
    public void Weather_out_of_range_is_refused(double temperature, double humidity, double pressure, string message)
    {
        var weather = new Weather { Temperature = temperature, Humidity = humidity, Pressure = pressure };
        Assert.Contains(message, Assert.Throws<ArgumentOutOfRangeException>(weather.ToAir).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_place_out_of_the_atmosphere_is_refused() =>
        Assert.Contains("air.weather.altitude is 12000; allowed: -500 … 11000", Assert.Throws<ArgumentOutOfRangeException>(() => Weather.AtAltitude(12_000)).Message, StringComparison.Ordinal);
}
