using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Scenes;

/// <summary>Wind by height and gusts, against values worked out with another calculator.</summary>
public sealed class WindTests
{
    [Theory]
    [InlineData(-3, 0)]
    [InlineData(0, 0)]
    [InlineData(0.11, 0.2650)]
    [InlineData(1, 0.6084)]
    [InlineData(2, 0.7251)]
    [InlineData(5, 0.8813)]
    [InlineData(10, 1)]
    public void Wind_grows_with_the_logarithm_of_the_height(double height, double share)
    {
        Vector3d wind = new WindByHeight(8, 3, 4, groundHeight: -1).At(12, new Vector3d(5, height - 1, 2));
        Assert.Equal(8 * share * 0.6, wind.X, 4e-4);
        Assert.Equal(0, wind.Y);
        Assert.Equal(8 * share * 0.8, wind.Z, 4e-4);
    }

    [Theory]
    [InlineData(0, 0, -0.444817, 1.141585, -0.869829)]
    [InlineData(10, 0, -0.317064, 0.407945, -0.534661)]
    [InlineData(18, 1, -0.317064, 0.407945, -0.534661)]
    public void Gusts_are_a_function_of_seed_place_and_time(double distance, double time, double along, double across, double up)
    {
        // At the reference height, and for a wind along −z, across is along x.
        Vector3d wind = new WindByHeight(8, 0, -1, gusts: new Gusts { Seed = 7 }).At(time, new Vector3d(0, 10, -distance));
        Assert.Equal(along, -wind.Z - 8, 6e-7);
        Assert.Equal(across, wind.X, 6e-7);
        Assert.Equal(up, wind.Y, 6e-7);
    }

    [Theory]
    [InlineData(1e13, 0)]
    [InlineData(1e15, 0)]
    [InlineData(0, 1e20)]
    [InlineData(0, -1e45)]
    public void Gusts_stay_bounded_beyond_distances_that_have_digits(double time, double distance)
    {
        var wind = new WindByHeight(20, 0, 1, gusts: new Gusts { Seed = 4, Length = 1 });
        Assert.InRange(wind.At(time, new Vector3d(0, 10, distance)).Length, 0, wind.MaximumSpeed);
    }

    [Fact]
    public void Gusts_have_their_strength_over_a_long_way_and_no_mean()
    {
        foreach (long seed in (long[])[0, 1, -9, long.MaxValue])
        {
            var wind = new WindByHeight(10, 1, 0, gusts: new Gusts { Seed = seed });
            Vector3d sum = default;
            Vector3d squares = default;
            const int Count = 40_000;
            for (int i = 0; i < Count; i++)
            {
                Vector3d gust = wind.At(0, new Vector3d(i * 3.7, 10, 0)) - new Vector3d(10, 0, 0);
                sum += gust;
                squares += new Vector3d(gust.X * gust.X, gust.Y * gust.Y, gust.Z * gust.Z);
                Assert.InRange((gust + new Vector3d(10, 0, 0)).Length, 0, wind.MaximumSpeed);
            }

            Assert.InRange(sum.Length / Count, 0, 0.05);
            Assert.Equal(1.8, Math.Sqrt(squares.X / Count), 0.05);
            Assert.Equal(1.44, Math.Sqrt(squares.Z / Count), 0.05);
            Assert.Equal(0.9, Math.Sqrt(squares.Y / Count), 0.05);
        }
    }

    /// <summary>Below 2 m the upward gusts fade to nothing, as the ground does not let them through.</summary>
    [Fact]
    public void Near_the_ground_no_gust_goes_up_or_down()
    {
        var wind = new WindByHeight(8, 1, 0, gusts: new Gusts { Seed = 7 });
        double atOne = wind.At(0, new Vector3d(0, 1, 0)).Y;
        Assert.Equal(-0.869829 * 0.6084 * 0.5, atOne, 1e-4);
        Assert.Equal(0, wind.At(0, Vector3d.Zero).Y);
    }

    [Theory]
    [InlineData(-1, 1, 0, 10, 0.03, "air.wind.speed is -1; allowed: 0 … 200")]
    [InlineData(5, 0, 0, 10, 0.03, "air.wind.direction is [0, 0]; allowed: [x, z]")]
    [InlineData(5, double.NaN, 0, 10, 0.03, "air.wind.direction is [NaN, 0]")]
    [InlineData(5, 1, 0, 0, 0.03, "air.wind.referenceHeight is 0; allowed: 0.1 … 1000")]
    [InlineData(5, 1, 0, 10, 0, "air.wind.roughness is 0; allowed: 0.0001 … 2")]
    public void A_wind_out_of_range_is_refused(double speed, double x, double z, double referenceHeight, double roughness, string message) => Assert.Contains(
        message, Assert.Throws<ArgumentOutOfRangeException>(() => new WindByHeight(speed, x, z, referenceHeight, roughness)).Message, StringComparison.Ordinal);

    [Fact]
    public void Gusts_out_of_range_are_refused()
    {
        Assert.Contains("air.wind.gusts.intensity is 1.5", Refusal(new Gusts { Intensity = 1.5 }), StringComparison.Ordinal);
        Assert.Contains("air.wind.gusts.length is 0", Refusal(new Gusts { Length = 0 }), StringComparison.Ordinal);

        static string Refusal(Gusts gusts) => Assert.Throws<ArgumentOutOfRangeException>(() => new WindByHeight(5, 1, 0, gusts: gusts)).Message;
    }

    [Fact]
    public void A_wind_that_says_it_is_faster_than_the_limit_is_refused() => Assert.Contains(
        "air.windField.maximumSpeed is 1001; allowed: 0 … 1000",
        Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(Scene.Published with { Air = new Air { WindField = new UniformWind(new Vector3d(1001, 0, 0)) } })).Message,
        StringComparison.Ordinal);
}
