namespace FootballPhysics.Tracks;

/// <summary>Tests whether the flights of a track obey the laws: gravity, which reveals a wrong clock or wrong heights, and one wind for the whole track.</summary>
internal sealed class MatchDoubts(Scene scene, MatchFitRequest request, FlightEquations equations, TrackPoint[] track, List<FlightPath> flights, double[] shares)
{
    /// <summary>The deviations of gravity, and its error, beyond which times or heights are wrong.</summary>
    private const double WeightDeviations = 3.5;
    private const double LeastWeight = 0.012;

    /// <summary>The square of the change of wind, in deviations, and the change in m/s, beyond which a part of the track is turned.</summary>
    private const double WindDeviations = 30;
    private const double LeastWind = 0.8;

    /// <summary>The square of the distance of the fitted drag from that of the ball, in deviations, above which the laws are in doubt.</summary>
    private const double MostStrangeness = 20;

    /// <summary>The doubt about the laws: the error of a velocity as a share of it, and of a spin in rad/s and as a share of it.</summary>
    private const double LawVelocity = 0.0025;
    private const double LawSpin = 1;
    private const double LawSpinShare = 0.08;

    /// <summary>The minimum number of flights in each part.</summary>
    private const int LeastFlights = 3;

    /// <summary>The factor of gravity at which the flights fit best; 1 if there are too few flights.</summary>
    public double Weight { get; private set; } = 1;

    private double WeightDeviation { get; set; } = double.PositiveInfinity;

    /// <summary>The most certain change of wind between two parts, in m/s.</summary>
    public double WindChange { get; private set; }

    private double WindOdds { get; set; }

    /// <summary>The time of that change, in s.</summary>
    public double WindTime { get; private set; }

    private double Strangeness { get; set; }

    /// <summary>True if the shape of the drag curve was fitted, because that of the ball does not describe the flights.</summary>
    public bool HasOtherLaw { get; private set; }

    /// <summary>True if times or heights have a wrong scale.</summary>
    public bool IsScaled => Math.Abs(Weight - 1) > Math.Max(LeastWeight, WeightDeviations * WeightDeviation);

    /// <summary>True if the wind changes within the track.</summary>
    public bool IsTurned => WindOdds > WindDeviations && WindChange > LeastWind;

    /// <summary>True if the drag of the fitted ball is not that of the scene's ball.</summary>
    public bool IsStrange => Strangeness > MostStrangeness;

    /// <summary>Runs the tests; the flights keep their launches.</summary>
    public void Test(SharedFit fit, FitWatch watch)
    {
        bool law = fit.Values.Length > new MatchModel(scene, request).Count;
        HasOtherLaw = law;
        var model = new MatchModel(scene, request, law);
        Strangeness = model.Strangeness(fit.Values, fit.Covariance);
        if (flights.Count < LeastFlights)
        {
            return;
        }

        double[][] launches = [.. flights.Select(flight => (double[])flight.Values.Clone())];
        double[][] covariances = [.. flights.Select(flight => (double[])flight.Covariance.Clone())];
        TestWeight(fit, law, watch);
        Restore(fit, launches, covariances);
        TestWind(fit, law, launches, watch);
        Restore(fit, launches, covariances);
    }

    /// <summary>
    /// Adds the doubt about the laws to the deviations of all flights: if the fitted drag is not that of the ball, its lift may not be either.
    /// </summary>
    /// <param name="others">The flights that were too short for the tests.</param>
    public void Widen(IEnumerable<FlightPath> others)
    {
        if (!IsStrange)
        {
            return;
        }

        foreach (FlightPath flight in flights.Concat(others))
        {
            double velocity = LawVelocity * flight.Velocity.Length;
            double spin = LawSpin + (LawSpinShare * flight.Spin.Length);
            for (int i = 3; i < FlightPath.Launch; i++)
            {
                flight.Covariance[(i * FlightPath.Launch) + i] += i < 6 ? velocity * velocity : spin * spin;
            }
        }
    }

    private void Restore(SharedFit fit, double[][] launches, double[][] covariances)
    {
        for (int i = 0; i < flights.Count; i++)
        {
            flights[i].Values = (double[])launches[i].Clone();
            flights[i].Covariance = (double[])covariances[i].Clone();
            equations.Measure(fit.At, flights[i]);
        }
    }

    private void TestWeight(SharedFit fit, bool law, FitWatch watch)
    {
        var heavy = new MatchModel(scene, request, law, weight: true);
        var weighed = new SharedFit(equations, heavy, [.. fit.Values, 1]);
        weighed.Descend(flights, shares, watch);
        weighed.MeasureUncertainty(flights, shares, watch);
        Weight = weighed.Values[^1];
        WeightDeviation = Math.Sqrt(Math.Max(0, weighed.Covariance[^1]));
    }

    /// <summary>Compares the winds of the flights before and after the middle, and before and after the longest pause.</summary>
    private void TestWind(SharedFit fit, bool law, double[][] launches, FitWatch watch)
    {
        if (!request.Wind || flights.Count < 2 * LeastFlights)
        {
            return;
        }

        int middle = flights.Count / 2;
        double half = 0.5 * (track[flights[0].First].Time + track[flights[^1].End - 1].Time);
        int byTime = Math.Clamp(flights.FindIndex(flight => track[flight.First].Time >= half), LeastFlights, flights.Count - LeastFlights);
        int pause = Enumerable.Range(LeastFlights, flights.Count - (2 * LeastFlights) + 1).OrderByDescending(i => track[flights[i].First].Time - track[flights[i - 1].End - 1].Time).First();
        foreach (int split in new HashSet<int> { middle, byTime, pause })
        {
            (Vector3d before, Vector3d beforeVariance) = Wind(fit, law, 0, split, launches, watch);
            (Vector3d after, Vector3d afterVariance) = Wind(fit, law, split, flights.Count, launches, watch);
            Vector3d change = after - before;
            Vector3d variance = beforeVariance + afterVariance;
            double odds = (change.X * change.X / variance.X) + (change.Z * change.Z / variance.Z);
            if (odds > WindOdds)
            {
                (WindOdds, WindChange, WindTime) = (odds, change.Length, track[flights[split].First].Time);
            }
        }
    }

    private (Vector3d Wind, Vector3d Variance) Wind(SharedFit fit, bool law, int from, int to, double[][] launches, FitWatch watch)
    {
        List<FlightPath> part = flights.GetRange(from, to - from);
        double[] some = shares[from..to];
        for (int i = from; i < to; i++)
        {
            flights[i].Values = (double[])launches[i].Clone();
        }

        // Only the wind is free: the ball is that of the whole track.
        var model = new MatchModel(fit.At.Scene with { Ground = scene.Ground }, request with { Drag = false, Crisis = false, Lift = false });
        var alone = new SharedFit(equations, model);
        alone.Descend(part, some, watch);
        alone.MeasureUncertainty(part, some, watch);
        return (new Vector3d(alone.Values[0], 0, alone.Values[1]), new Vector3d(alone.Covariance[0], 0, alone.Covariance[^1]));
    }
}
