using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>Fits that know when they are wrong: what they say of χ², of another minimum, of another ball.</summary>
public sealed class TrackVerdictTests
{
    private const double Noise = 0.02;

    [Fact]
    public void A_fit_of_the_scene_that_was_is_as_expected()
    {
        int expected = 0;
        for (int i = 0; i < 12; i++)
        {
            TrackFitResult found = new TrackFit().Find(Seen(Scene.Default, i, bounces: false, Noise, out _, out _));
            Assert.InRange(found.Probability, 1e-3, 1 - 1e-3);
            expected += found.Verdict == TrackVerdict.AsExpected ? 1 : 0;
            Assert.Contains(FormattableString.Invariant($"χ² is {found.ChiSquared:0.0} of {found.DegreesOfFreedom} expected"), found.Explanation, StringComparison.Ordinal);
        }

        Assert.InRange(expected, 11, 12);
    }

    [Fact]
    public void Noise_that_was_said_too_small_or_too_large_is_told_by_chi_squared()
    {
        for (int i = 0; i < 4; i++)
        {
            TrackPoint[] track = Seen(Scene.Default, i, bounces: false, Noise, out _, out _);
            TrackFitResult poor = new TrackFit().Find(Said(track, Noise / 2));
            Assert.Equal(TrackVerdict.Poor, poor.Verdict);
            Assert.InRange(poor.Probability, 0, 1e-3);
            Assert.Contains("once in a thousand", poor.Explanation, StringComparison.Ordinal);

            // Deviations follow the residuals, not the noise that was said.
            TrackFitResult right = new TrackFit().Find(track);
            for (int k = 3; k < 6; k++)
            {
                Assert.InRange(poor.StandardError(k) / right.StandardError(k), 0.6, 1.5);
            }

            Assert.Equal(TrackSuspicions.None, poor.Suspicions);
            Assert.True(poor.GoodFor.HasFlag(MatchAnswers.Launches));
            TrackFitResult well = new TrackFit().Find(Said(track, 2 * Noise));
            Assert.Equal(TrackVerdict.NoiseOverestimated, well.Verdict);
            Assert.Contains("too large", well.Explanation, StringComparison.Ordinal);
        }
    }

    /// <summary>χ² distributes as it should: of many right fits its probability is below ½ about half the time.</summary>
    [Fact]
    public void The_probability_of_a_right_fit_is_spread_evenly()
    {
        int low = 0;
        int lowest = 0;
        for (int i = 0; i < 60; i++)
        {
            double probability = new TrackFit().Find(Seen(Scene.Default, 100 + i, bounces: false, Noise, out _, out _)).Probability;
            low += probability < 0.5 ? 1 : 0;
            lowest += probability < 0.1 ? 1 : 0;
        }

        Assert.InRange(low, 18, 42);
        Assert.InRange(lowest, 1, 14);
    }

    /// <summary>Tracks with a bounce, where another spin may fit nearly as well: whoever ends in the wrong valley says so, and names the other.</summary>
    [Fact]
    public void A_fit_with_a_bounce_is_right_or_names_the_other_minimum()
    {
        int wrong = 0;
        int ambiguous = 0;
        for (int i = 0; i < 60; i++)
        {
            TrackPoint[] track = Seen(Scene.Default, 1000 + i, bounces: true, Noise, out _, out Vector3d spin);
            TrackFitResult found = new TrackFit().Find(track);
            double off = Deviations(found, found.Spin, spin);
            if (found.OtherSpin is { } other)
            {
                ambiguous++;
                Assert.Equal(TrackVerdict.Ambiguous, found.Verdict);
                Assert.Contains("another bounce", found.Explanation, StringComparison.Ordinal);
                off = Math.Min(off, Deviations(found, other, spin));
            }

            wrong += off > 4.5 ? 1 : 0;
        }

        Assert.Equal(0, wrong);
        Assert.InRange(ambiguous, 0, 12);
    }

    /// <summary>The true ball is one of several that were named: deviations of the noise alone are too small for the wrong one, those over balls are not.</summary>
    [Fact]
    public void Deviations_with_a_wrong_ball_are_told_as_too_small()
    {
        var request = new TrackFitRequest { OtherBalls = [BallProperties.Jabulani, BallProperties.Tango12] };
        double worst = 0;
        double worstOver = 0;
        int said = 0;
        const int Tracks = 12;
        for (int i = 0; i < Tracks; i++)
        {
            Scene truth = Scene.Default with { Ball = i % 2 == 0 ? BallProperties.Jabulani : BallProperties.Tango12 };
            TrackPoint[] track = Seen(truth, 2000 + i, bounces: false, Noise, out Vector3d velocity, out Vector3d spin);
            double[] true_ = [velocity.X, velocity.Y, velocity.Z, spin.X, spin.Y, spin.Z];
            TrackFitResult found = new TrackFit().Find(track, request);
            double off = 0;
            double over = 0;
            for (int k = 0; k < 6; k++)
            {
                double miss = Math.Abs(found.Value(3 + k) - true_[k]);
                off = Math.Max(off, miss / found.StandardError(3 + k));
                over = Math.Max(over, miss / found.DeviationOverBalls(3 + k));
                Assert.True(found.DeviationOverBalls(3 + k) >= found.StandardError(3 + k));
            }

            Assert.Equal(2, found.ByBall.Count);
            worst = Math.Max(worst, off);
            worstOver = Math.Max(worstOver, over);

            // The true one fits as it should, wherever the wrong one has ended.
            Assert.InRange(found.ByBall[i % 2].ChiSquared, 0.5 * found.DegreesOfFreedom, 1.5 * found.DegreesOfFreedom);
            bool reports = found.Verdict is TrackVerdict.OtherBall or TrackVerdict.Poor;
            Assert.True(found.Verdict != TrackVerdict.Poor, "one of the balls explains it");
            said += reports ? 1 : 0;
            Assert.True(reports || off < 4.5, $"track {i}: {off:F1} deviations off, and nothing is said: {found.Explanation}");
            Assert.True(found.Verdict != TrackVerdict.OtherBall || found.Explanation.Contains("too small", StringComparison.Ordinal));
        }

        Assert.True(worst > 4.5, $"{worst}: none of the wrong balls matters");
        Assert.InRange(worstOver, 0, 4.5);
        Assert.InRange(said, Tracks / 2, Tracks);
    }

    /// <summary>The rule of match fits: what no free ball does is good for nothing, and a spin needs all its components.</summary>
    [Fact]
    public void A_track_of_no_free_ball_is_good_for_nothing()
    {
        TrackPoint[] track = Seen(Scene.Default, 3, bounces: false, Noise, out _, out _);
        TrackPoint[] slow = [.. track.Select(point => new TrackPoint(3 * point.Time, point.Position, Noise))];
        TrackFitResult found = new TrackFit().Find(slow);
        Assert.Equal((MatchAnswers.None, TrackSuspicions.Misfit), (found.GoodFor, found.Suspicions));
        var seen = new HashSet<MatchAnswers>();
        foreach (int points in (int[])[6, 10, 16, 24, 35])
        {
            found = new TrackFit().Find(track[..points]);
            bool launch = found.Converged && Enumerable.Range(3, 3).All(k => found.StandardError(k) <= 1);
            bool spin = launch && Enumerable.Range(6, 3).All(k => found.StandardError(k) <= 20);
            Assert.Equal((launch ? MatchAnswers.Launches : 0) | (spin ? MatchAnswers.Spins : 0), found.GoodFor);
            seen.Add(found.GoodFor);
        }

        Assert.True(seen.Count > 1, "all lengths are good for the same");
    }

    private static double Deviations(TrackFitResult found, in Vector3d spin, in Vector3d truth)
    {
        Vector3d off = spin - truth;
        return Math.Max(Math.Abs(off.X) / found.StandardError(6), Math.Max(Math.Abs(off.Y) / found.StandardError(7), Math.Abs(off.Z) / found.StandardError(8)));
    }

    private static TrackPoint[] Said(TrackPoint[] track, double noise) => [.. track.Select(point => new TrackPoint(point.Time, point.Position, noise))];

    /// <summary>A shot as a camera sees it: in the air all the while, or with a bounce in the middle.</summary>
    private static TrackPoint[] Seen(Scene scene, int seed, bool bounces, double noise, out Vector3d velocity, out Vector3d spin)
    {
        var random = new SeededRandom(SeededRandom.Mix(77, seed));
        var simulator = new Simulator(scene);
        velocity = bounces ? random.Velocity(12, 22, 8, 22) : random.Velocity(18, 28, 25, 40);
        spin = random.Uniform(0, 60) * random.Direction();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, spin);
        var track = new TrackPoint[35];
        var log = new StepLog();
        for (int i = 0; i < track.Length; i++)
        {
            track[i] = new TrackPoint(0.04 * i, ball.Position + new Vector3d(Normal(), Normal(), Normal()), noise);
            log.Clear();
            simulator.Run(ref ball, 0.01, 0.04, StopAt.Time, log);
        }

        return track;

        double Normal() => noise * Math.Sqrt(-2 * Math.Log(1 - random.Next())) * Math.Cos(2 * Math.PI * random.Next());
    }
}
