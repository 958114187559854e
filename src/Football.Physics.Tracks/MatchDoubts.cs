namespace FootballPhysics.Tracks;

/// <summary>Tests whether the flights of a track obey the laws: gravity, which reveals a wrong clock or wrong heights, and one wind for the whole track.</summary>
internal sealed class MatchDoubts(Scene scene, MatchFitRequest request, FlightEquations equations, TrackPoint[] track, List<FlightPath> flights, double[] shares)
{
    /// <summary>The deviations of gravity, and its error, beyond which times or heights are wrong: of the scene's ball, of another ball, and of any.</summary>
    private const double WeightDeviations = 3.2;
    private const double LeastWeight = 0.008;
    private const double LeastStrangeWeight = 0.014;
    private const double LargeWeight = 0.025;
    private const double LargeWeightDeviations = 2.5;

    /// <summary>The residuals from which the linear step of gravity does not reach its value: as a multiple of the noise, plus m.</summary>
    private const double FarShare = 3.5;
    private const double FarError = 0.005;

    /// <summary>The square of the change of wind, in deviations, and the change in m/s, beyond which a part of the track is turned.</summary>
    private const double WindDeviations = 30;
    private const double LeastWind = 0.8;
    private const double SureWindDeviations = 60;
    private const double SureWind = 0.45;

    /// <summary>The same for parts that are fitted apart. Above: turned halves stay unseen. Below: balls of which a part has few flights.</summary>
    private const double PartDeviations = 50;
    private const double PartWind = 2;

    /// <summary>The critical Reynolds numbers of footballs.</summary>
    /// <remarks>Measured balls: 0.85e5 (a rough one in a stadium) … 2.4e5 (a smooth one). A fit beyond these has found no crisis at the speeds of the track.</remarks>
    private const double LeastCrisis = 0.82e5;
    private const double MostCrisis = 2.6e5;

    /// <summary>The square of the distance of the fitted drag from that of the ball, in deviations, above which the laws are in doubt.</summary>
    private const double MostStrangeness = 12;

    /// <summary>The errors of the drag and of the lift of a flight as shares of them: with a fitted shape of the drag curve, and without.</summary>
    /// <remarks>Below: of simulated flights by other laws, fewer than 98 % are within three deviations. Above: more than 76 % are within one.</remarks>
    private const double ShapedDrag = 0.015;
    private const double ShapedLift = 0.035;
    private const double LawDrag = 0.045;
    private const double LawLift = 0.08;

    /// <summary>The same for spins far from the fitted ones: the lift of a slow ball differs more between laws than that of the fitted spin.</summary>
    private const double ProfiledDrag = 0.1;
    private const double ProfiledLift = 0.25;

    /// <summary>The same for a short flight and for the flight before an impact: of a velocity as a share of it, and of a spin in rad/s and as a share of it.</summary>
    private const double LawVelocity = 0.0025;
    private const double LawSpin = 1;
    private const double LawSpinShare = 0.05;

    /// <summary>The squares of deviations above which a factor of gravity, and a change of the wind at the most different moment, add a doubt to the launches.</summary>
    private const double WeightDoubt = 4;
    private const double WindDoubt = 15;

    /// <summary>The ratio to the median residual above which a flight is no example of the others.</summary>
    private const double Odd = 1.6;

    /// <summary>The most by which the variances of such a flight grow.</summary>
    private const double MostInflation = 4;

    /// <summary>The minimum number of flights in each part.</summary>
    private const int LeastFlights = 3;

    private double _most;
    private int _split;

    /// <summary>The factor of gravity at which the flights fit best; 1 if there is no flight.</summary>
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

    /// <summary>The residual of the flights beyond the noise, in m, without flights that fit far worse than the others.</summary>
    public double Excess { get; private set; }

    /// <summary>The fit with the doubts about the laws of the ball; null without doubts.</summary>
    public SharedFit? Doubted { get; private set; }

    /// <summary>True if times or heights have a wrong scale.</summary>
    public bool IsScaled => Math.Abs(Weight - 1) > Math.Max(IsStrange ? LeastStrangeWeight : LeastWeight, WeightDeviations * WeightDeviation)
        || Math.Abs(Weight - 1) > Math.Max(LargeWeight, LargeWeightDeviations * WeightDeviation);

    /// <summary>True if the wind changes within the track.</summary>
    public bool IsTurned => (WindOdds > WindDeviations && WindChange > LeastWind) || (WindOdds > SureWindDeviations && WindChange > SureWind);

    /// <summary>True if the fitted crisis is none of a football.</summary>
    public bool HasNoCrisis { get; private set; }

    /// <summary>True if the drag of the fitted ball is not that of the scene's ball.</summary>
    public bool IsStrange => HasOtherLaw || Strangeness > MostStrangeness;

    /// <summary>Returns the doubt about a spin as a share of it, before the tests: 0 if the drag is that of the scene's ball.</summary>
    /// <param name="fit">The fit, with its covariance.</param>
    /// <param name="rigid">The model without the shape of the drag curve.</param>
    public static double OfSpin(SharedFit fit, MatchModel rigid) =>
        fit.Values.Length > rigid.Count || rigid.Strangeness(fit.Values, fit.Covariance) > MostStrangeness ? LawSpinShare : 0;

    /// <summary>Runs the tests; the flights keep their launches.</summary>
    public void Test(SharedFit fit, FitWatch watch)
    {
        bool law = fit.Values.Length > new MatchModel(scene, request).Count;
        HasOtherLaw = law;
        var model = new MatchModel(scene, request, law);
        Strangeness = model.Strangeness(fit.Values, fit.Covariance);
        HasNoCrisis = IsStrange && model.CrisisAt >= 0 && (fit.Values[model.CrisisAt] < LeastCrisis || fit.Values[model.CrisisAt] > MostCrisis);
        if (IsStrange)
        {
            var doubted = new SharedFit(equations, new MatchModel(scene, request, law, knownLift: true), request.Lift ? fit.Values : [.. fit.Values, 1])
            {
                DragDoubt = law ? ShapedDrag : LawDrag,
                LiftDoubt = law ? ShapedLift : LawLift,
            };
            doubted.MeasureUncertainty(flights, shares, watch);
            CopyCovariance(doubted, fit);
            (doubted.DragDoubt, doubted.LiftDoubt) = (ProfiledDrag, ProfiledLift);
            Doubted = doubted;
        }

        if (flights.Count == 0)
        {
            return;
        }

        double[] sorted = [.. flights.Select(flight => flight.Rms)];
        Array.Sort(sorted);
        _most = Odd * sorted[sorted.Length / 2];
        double squares = 0;
        int points = 0;
        foreach (FlightPath flight in flights)
        {
            squares += flight.Rms <= _most ? flight.Count * flight.Rms * flight.Rms : 0;
            points += flight.Rms <= _most ? flight.Count : 0;
        }

        Inflate(flights);
        Excess = Math.Sqrt(Math.Max(0, (squares / points) - (3 * equations.Noise * equations.Noise)));

        // One evaluation with a factor of gravity: from its equations, linear steps answer every question.
        var weighed = new SharedFit(equations, new MatchModel(scene, request, law, weight: true), [.. fit.Values, 1]);
        FlightScore[] scores = weighed.Scores(flights, shares, watch);
        TestWeight(fit, weighed, scores, watch);
        TestWind(scores);
        TestParts(fit, model, watch);
    }

    /// <summary>
    /// Adds the doubt about the laws to the deviations of short flights: if the fitted drag is not that of the ball, its lift may not be either.
    /// </summary>
    /// <param name="brief">The flights that were too short for the tests.</param>
    public void Widen(IReadOnlyList<FlightPath> brief)
    {
        Inflate(brief);
        if (!IsStrange)
        {
            return;
        }

        foreach (FlightPath flight in brief)
        {
            double velocity = LawVelocity * flight.Velocity.Length;
            double spin = LawSpin + (LawSpinShare * flight.Spin.Length);
            for (int i = 3; i < FlightPath.Launch; i++)
            {
                flight.Covariance[(i * FlightPath.Launch) + i] += i < 6 ? velocity * velocity : spin * spin;
            }
        }
    }

    /// <summary>Scales the deviations of flights whose residuals are odd: a touch or an impact within them is no noise.</summary>
    private void Inflate(IReadOnlyList<FlightPath> all)
    {
        foreach (FlightPath flight in all)
        {
            double factor = _most > 0 ? Math.Min(MostInflation, Math.Max(1, flight.Rms * flight.Rms / (_most * _most))) : 1;
            for (int i = 0; i < flight.Covariance.Length; i++)
            {
                flight.Covariance[i] *= factor;
            }
        }
    }

    /// <summary>Copies the covariance of the common parameters: the first ones of the other fit.</summary>
    private static void CopyCovariance(SharedFit from, SharedFit to)
    {
        int n = to.Values.Length;
        for (int i = 0; i < n; i++)
        {
            Array.Copy(from.Covariance, i * from.Values.Length, to.Covariance, i * n, n);
        }
    }

    private void TestWeight(SharedFit fit, SharedFit weighed, FlightScore[] scores, FitWatch watch)
    {
        int n = weighed.Values.Length;
        double[] inverse = new double[n * n];
        double[] covariance = new double[n * n];
        double[] step = new double[n];
        weighed.Solve(scores, 0, scores.Length, inverse, covariance, step);
        WeightDeviation = Math.Sqrt(Math.Max(0, covariance[^1]));
        Weight = 1 + step[^1];
        double squares = flights.Sum(flight => flight.Count * flight.Rms * flight.Rms) / flights.Sum(flight => flight.Count);
        if (!IsScaled && Math.Sqrt(squares) < (FarShare * equations.Noise) + FarError)
        {
            // The doubt that remains: what the launches would change by, as far as the change is more than its deviation.
            double excess = Math.Max(0, 1 - (WeightDoubt * covariance[^1] / (step[^1] * step[^1])));
            for (int f = 0; f < flights.Count && excess > 0; f++)
            {
                scores[f].AddChange(step, excess, flights[f].Covariance);
            }

            return;
        }

        // Far from the solution, the equations are not linear.
        double[][] launches = [.. flights.Select(flight => (double[])flight.Values.Clone())];
        weighed.Descend(flights, shares, watch);
        weighed.Solve(weighed.Scores(flights, shares, watch), 0, flights.Count, inverse, covariance, step);
        Weight = weighed.Values[^1];
        WeightDeviation = Math.Sqrt(Math.Max(0, covariance[^1]));
        for (int i = 0; i < flights.Count; i++)
        {
            flights[i].Values = launches[i];
            equations.Measure(fit.At, flights[i]);
        }
    }

    /// <summary>Compares the winds of the flights before and after each moment between two flights.</summary>
    private void TestWind(FlightScore[] scores)
    {
        if (!request.Wind || flights.Count < 2 * LeastFlights)
        {
            return;
        }

        for (int split = LeastFlights; split <= flights.Count - LeastFlights; split++)
        {
            (double x, double z, double xx, double xz, double zz) = Wind(scores, 0, split);
            (double laterX, double laterZ, double laterXx, double laterXz, double laterZz) = Wind(scores, split, scores.Length);
            (x, z, xx, xz, zz) = (laterX - x, laterZ - z, laterXx + xx, laterXz + xz, laterZz + zz);
            double odds = Odds(x, z, xx, xz, zz);
            if (odds > WindOdds)
            {
                Keep(split, odds, x, z);
            }
        }

        double excess = Math.Max(0, 1 - (WindDoubt / WindOdds));
        if (excess > 0 && !IsTurned)
        {
            (double x, double z, _, _, _) = Wind(scores, 0, _split);
            (double laterX, double laterZ, _, _, _) = Wind(scores, _split, scores.Length);
            for (int f = 0; f < flights.Count; f++)
            {
                scores[f].AddChange(f < _split ? [x, z] : [laterX, laterZ], excess, flights[f].Covariance);
            }
        }
    }

    private void Keep(int split, double odds, double x, double z) =>
        (_split, WindOdds, WindChange, WindTime) = (split, odds, Math.Sqrt((x * x) + (z * z)), track[flights[split].First].Time);

    /// <summary>Returns the square of a change of the wind, in deviations.</summary>
    private static double Odds(double x, double z, double xx, double xz, double zz) => ((x * x * zz) - (2 * x * z * xz) + (z * z * xx)) / ((xx * zz) - (xz * xz));

    /// <summary>Fits the two parts apart, from launches without spin, if the drag of the whole track is not that of the ball.</summary>
    /// <remarks>Two winds in one fit bend its drag and spins until the linear steps of <see cref="TestWind"/> show no second wind.</remarks>
    private void TestParts(SharedFit fit, MatchModel model, FitWatch watch)
    {
        if (!IsStrange || IsScaled || IsTurned || _split == 0)
        {
            return;
        }

        int split = Math.Min(Math.Max(_split, flights.Count / 3), flights.Count - (flights.Count / 3));
        double[][] launches = [.. flights.Select(flight => flight.Values)];
        double[][] covariances = [.. flights.Select(flight => flight.Covariance)];
        SharedFit before = Part(0, split);
        SharedFit after = Part(split, flights.Count);
        for (int i = 0; i < flights.Count; i++)
        {
            (flights[i].Values, flights[i].Covariance) = (launches[i], covariances[i]);
            equations.Measure(fit.At, flights[i]);
        }

        int n = fit.Values.Length;
        (double x, double z) = (after.Values[0] - before.Values[0], after.Values[1] - before.Values[1]);
        (double xx, double xz, double zz) = (after.Covariance[0] + before.Covariance[0], after.Covariance[1] + before.Covariance[1], after.Covariance[n + 1] + before.Covariance[n + 1]);
        double odds = Odds(x, z, xx, xz, zz);
        if (odds > Math.Max(PartDeviations, WindOdds) && Math.Sqrt((x * x) + (z * z)) > PartWind)
        {
            Keep(split, odds, x, z);
        }

        SharedFit Part(int from, int to)
        {
            List<FlightPath> part = flights.GetRange(from, to - from);
            foreach (FlightPath flight in part)
            {
                flight.Covariance = (double[])flight.Covariance.Clone();
                flight.Values = (double[])flight.Values.Clone();
                Array.Clear(flight.Values, 6, 3);
            }

            double[] weights = SharedFit.Shares(part);
            var alone = new SharedFit(equations, model);
            alone.Descend(part, weights, watch);
            alone.MeasureUncertainty(part, weights, watch);
            return alone;
        }
    }

    /// <summary>Returns the change of the wind in a part of the flights, and its covariance. Only the wind is free: the ball is that of the whole track.</summary>
    private (double X, double Z, double Xx, double Xz, double Zz) Wind(FlightScore[] scores, int from, int to)
    {
        double known = 1 / (request.WindDeviation * request.WindDeviation);
        (double a, double b, double d, double x, double z) = (known, 0, known, 0, 0);
        (double aa, double bb, double dd) = (known, 0, known);
        for (int f = from; f < to; f++)
        {
            FlightScore score = scores[f];
            double share = score.Share;
            int row = score.Score.Length;
            (a, b, d) = (a + (share * score.Information[0]), b + (share * score.Information[1]), d + (share * score.Information[row + 1]));
            (aa, bb, dd) = (aa + (share * share * score.Spread[0]), bb + (share * share * score.Spread[1]), dd + (share * share * score.Spread[row + 1]));
            (x, z) = (x + (share * score.Score[0]), z + (share * score.Score[1]));
        }

        double determinant = (a * d) - (b * b);
        (double p, double q, double r) = (d / determinant, -b / determinant, a / determinant);
        return (
            (p * x) + (q * z), (q * x) + (r * z), (p * p * aa) + (2 * p * q * bb) + (q * q * dd), (p * q * aa) + (((p * r) + (q * q)) * bb) + (q * r * dd), (q * q * aa) + (2 * q * r * bb) + (r * r * dd));
    }
}
