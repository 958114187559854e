using Football.Physics.Headless.Lab;

namespace Football.Physics.Headless.Sweep;

/// <summary>One launch of a sweep: it depends on the seed and its index only.</summary>
internal readonly record struct SweepKick(double Speed, double Elevation, double Azimuth, double TopSpin, double SideSpin)
{
    private const double Degree = Math.PI / 180.0;

    public static SweepKick Draw(SweepScenario sweep, long seed, long index)
    {
        var random = new LabRandom(LabRandom.Mix(seed, index));
        return new SweepKick(
            Between(random, sweep.Speeds),
            Between(random, sweep.Elevations),
            Between(random, sweep.Azimuths),
            Between(random, sweep.TopSpins),
            Between(random, sweep.SideSpins));
    }

    /// <summary>Velocity and spin.</summary>
    public void Vectors(out Vector3d velocity, out Vector3d spin)
    {
        var kick = new Kick { Elevation = Elevation * Degree, Azimuth = Azimuth * Degree, Top = TopSpin, Side = SideSpin };
        kick.Vectors(Speed, new Vector3d(0, 0, -1), out velocity, out spin);
    }

    /// <summary>A number is drawn for every range, so that narrowing one does not change the others.</summary>
    private static double Between(LabRandom random, (double Low, double High) range)
    {
        double value = random.Uniform(range.Low, range.High);
        return Math.Min(value, range.High);
    }
}
