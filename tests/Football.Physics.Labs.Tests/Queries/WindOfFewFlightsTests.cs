using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>The wind from one flight and from several: docs/data-sets.md has these numbers.</summary>
public sealed class WindOfFewFlightsTests
{
    private const double Noise = 0.002;
    private const double Seconds = 1.6;
    private static readonly Vector3d s_wind = new(4, 0, 2);
    private static readonly Vector3d[] s_velocities = [new(3, 9, -20), new(18, 10, 6), new(-12, 8, 16)];

    /// <summary>Three flights in different directions tell the wind from the spin.</summary>
    [Fact]
    public void Three_flights_reveal_the_wind()
    {
        MatchFitResult found = Fit(3, 40);
        Assert.Equal(s_wind.X, Value(found, "wind.x", out double across), 0.15);
        Assert.Equal(s_wind.Z, Value(found, "wind.z", out double along), 0.15);
        Assert.InRange(across, 0, 0.1);
        Assert.InRange(along, 0, 0.1);
    }

    /// <summary>In one flight, a sidespin of 3 rad/s is like a crosswind of 4 m/s: the prior decides, and the standard error says so.</summary>
    [Fact]
    public void One_flight_hardly_reveals_the_wind_and_the_error_says_so()
    {
        MatchFitResult found = Fit(1, 40);
        double x = Value(found, "wind.x", out double across);
        double z = Value(found, "wind.z", out double along);
        Assert.InRange(x, 0, 1);
        Assert.InRange(z, 0.9, 1.5);
        Assert.InRange(across, 1.5, 3);
        Assert.InRange(along, 0.5, 1.2);
        Assert.InRange(Math.Abs(x - s_wind.X) / across, 0, 2);
        Assert.InRange(Math.Abs(z - s_wind.Z) / along, 0, 2);
        Assert.InRange(found.Pieces[0].Spin.Y, -4, -2);
        Assert.InRange(found.Rms, 0, 1.2 * Math.Sqrt(3) * Noise);
    }

    /// <summary>A known spin leaves the wind alone.</summary>
    [Fact]
    public void One_flight_without_spin_reveals_the_wind()
    {
        MatchFitResult found = Fit(1, 0.1);
        Assert.Equal(s_wind.X, Value(found, "wind.x", out double across), 0.1);
        Assert.Equal(s_wind.Z, Value(found, "wind.z", out _), 0.1);
        Assert.InRange(across, 0, 0.2);
    }

    private static double Value(MatchFitResult found, string name, out double error)
    {
        int index = found.Names.ToList().IndexOf(name);
        error = found.StandardError(index);
        return found.Value(index);
    }

    private static MatchFitResult Fit(int flights, double spinDeviation)
    {
        var random = new SeededRandom(1L);
        double Normal() => Noise * Math.Sqrt(-2 * Math.Log(1 - random.Next())) * Math.Cos(2 * Math.PI * random.Next());
        var simulator = new Simulator(Scene.Measured with { Air = Scene.Measured.Air with { Wind = s_wind } });
        List<TrackPoint> track = [];
        for (int flight = 0; flight < flights; flight++)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), s_velocities[flight], Vector3d.Zero);
            for (int i = 0; 0.02 * i < Seconds; i++)
            {
                track.Add(new TrackPoint((5 * flight) + (0.02 * i), ball.Position + new Vector3d(Normal(), Normal(), Normal()), Noise));
                simulator.Run(ref ball, 0.01, 0.02, StopAt.Time, new StepLog());
            }
        }

        var request = new MatchFitRequest { Wind = true, Drag = false, Surface = false, Height = false, SpinDeviation = spinDeviation };
        return new MatchFit(Scene.Measured).Find([.. track], request);
    }
}
