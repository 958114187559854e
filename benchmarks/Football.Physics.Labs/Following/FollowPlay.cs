
namespace FootballPhysics.Labs.Following;

/// <summary>Plays a track to a filter and to the oracle, and measures both.</summary>
internal static class FollowPlay
{
    private const double Ahead = 1;

    /// <summary>The change of the velocity, in standard deviations of a point per interval, from which a kick counts.</summary>
    private const double Sharp = 5;

    /// <summary>The upward velocity from which a kick is into the air, in m/s.</summary>
    private const double Hop = 0.2;

    /// <summary>The error of the velocity, in deviations of the oracle, from which a kick is listed.</summary>
    private const double FarOff = 4;

    /// <summary>The number of points within which a kick must be found.</summary>
    private const int Soon = 5;

    /// <param name="track">The track.</param>
    /// <param name="settings">The settings of the filter.</param>
    /// <param name="withHeights">True to pass the positions, and to compare with the oracle; false to pass them without their heights.</param>
    public static FollowScore Run(FollowTrack track, BallFilterSettings settings, bool withHeights = true)
    {
        var score = new FollowScore();
        var filter = new BallFilter(track.Scene, settings);
        var oracle = withHeights ? new FollowOracle(track.Scene, settings) : null;
        var path = new Trajectory();
        int next = 0;
        int after = int.MinValue;
        TrueKick? last = null;
        bool found = true;
        double reported = double.NegativeInfinity;
        bool begun = false;
        for (int i = 0; i < track.Rows.Count; i++)
        {
            FollowRow row = track.Rows[i];
            bool kicked = next < track.Kicks.Count && track.Kicks[next].Time < row.Time;
            if (kicked)
            {
                last = track.Kicks[next++];
                after = 0;
                found = false;
            }

            if (withHeights)
            {
                filter.Update(row.Time, row.Measured);
            }
            else
            {
                filter.Update(row.Time, row.Measured.X, row.Measured.Z);
            }

            if (row.IsRepeated)
            {
                continue;
            }

            after++;
            if (!row.IsOutlier && oracle is not null)
            {
                if (!begun)
                {
                    oracle.Begin(row, track.Noise);
                    begun = true;
                }
                else if (last is { } kick && after >= 1 && IsPending(kick, row))
                {
                    oracle.Kick(kick, row, track.Noise);
                }
                else
                {
                    oracle.Add(row, track.Noise);
                }
            }

            BallEstimate estimate = filter.Estimate;
            bool sharp = last is { } sharpKick && (sharpKick.Velocity - sharpKick.Before).Length >= Sharp * track.Noise * track.Rate;
            if (estimate.HasKick && estimate.KickTime - reported > 0.1)
            {
                reported = estimate.KickTime;
                double tolerance = (2 / track.Rate) + 0.05 + (3 * estimate.KickDeviation);
                bool isTrue = track.Kicks.Any(kick => Math.Abs(kick.Time - reported) < tolerance);
                if (!isTrue)
                {
                    score.False++;
                    score.Falses.Add(FormattableString.Invariant($"{track.Rate} Hz {track.Noise} m: false at {row.Time - track.Rows[0].Time:F3} (kick {reported - track.Rows[0].Time:F3} ± {estimate.KickDeviation:F3}), v {row.Truth.Velocity}, y {row.Truth.Position.Y:F2}, kicks {string.Join(' ', track.Kicks.Select(k => (k.Time - track.Rows[0].Time).ToString("F2")))}"));
                }
            }

            if (last is { } sought && !found && after <= Soon)
            {
                found = estimate.HasKick && Math.Abs(estimate.KickTime - sought.Time) < (2 / track.Rate) + 0.05 + (3 * estimate.KickDeviation);
                if (sharp && (found || after == Soon))
                {
                    score.Kicks++;
                    if (!found)
                    {
                        score.Missed++;
                        score.Falses.Add(FormattableString.Invariant($"{track.Rate} Hz {track.Noise} m: missed {sought.Time - track.Rows[0].Time:F3}, p {estimate.KickProbability:F3}, {estimate.KickTime - track.Rows[0].Time:F3}"));
                    }
                }

                found |= after == Soon;
            }

            bool isFree = next >= track.Kicks.Count || track.Kicks[next].Time > row.Time + Ahead;
            int rowAhead = isFree ? track.Rows.FindIndex(i, other => Math.Abs(other.Time - row.Time - Ahead) < 1e-6) : -1;
            int at = Array.IndexOf(FollowScore.After, after);
            if (at >= 0 && sharp && last is not null && oracle is not null)
            {
                oracle.Finish();
                double deviation = Deviation(oracle.Covariance, 3);
                double off = (new Vector3d(oracle.Estimate[3], oracle.Estimate[4], oracle.Estimate[5]) - row.Truth.Velocity).Length;
                if (oracle.HasBound)
                {
                    score.AddBound(at, off / Math.Sqrt(3) / Deviation(oracle.Bound, 3), last is { } of && (of.Velocity.Y > Hop || of.Position.Y > TruthBall.Radius + 0.01));
                }

                double scale = 1 / (Math.Sqrt(3) * deviation);
                double error = scale * (estimate.State.Velocity - row.Truth.Velocity).Length;
                score.AddError(at, error, scale * off);
                if (error > FarOff && at == FollowScore.After.Length - 1)
                {
                    score.Falses.Add(FormattableString.Invariant($"{track.Rate} Hz {track.Noise} m: velocity off by {error:F1} deviations of the oracle (its own {scale * off:F1}), {after} points after {last.Value.Time - track.Rows[0].Time:F3}, to {last.Value.Velocity}; told {estimate.VelocityDeviation:F2} m/s, the oracle {deviation:F2}"));
                }
            }

            if (after >= FollowScore.After[0])
            {
                score.AddCover(0, estimate.State.Position - row.Truth.Position, estimate.PositionDeviation);
                score.AddCover(1, estimate.State.Velocity - row.Truth.Velocity, estimate.VelocityDeviation);
                score.AddCover(2, estimate.State.Spin - row.Truth.Spin, estimate.SpinDeviation);
            }

            if (after >= FollowScore.After[^1] && rowAhead >= 0)
            {
                filter.LookAhead(Ahead, path);
                Vector3d truth = track.Rows[rowAhead].Truth.Position;
                double told = filter.DeviationAt(path.EndTime);
                score.AddCover(3, path.Final.Position - truth, told);
                if (after == FollowScore.After[^1] && sharp && oracle is not null)
                {
                    (Vector3d position, double deviation) = oracle.LookAhead(Ahead);
                    double scale = 1 / (Math.Sqrt(3) * deviation);
                    score.AddError(3, scale * (path.Final.Position - truth).Length, scale * (position - truth).Length);
                }
            }
        }

        score.Seconds = track.Rows[^1].Time - track.Rows[0].Time;
        return score;

        bool IsPending(TrueKick kick, FollowRow row) => !oracle!.LastKick.Equals(kick.Time) && row.Time > kick.Time;
    }

    private static double Deviation(double[] covariance, int first)
    {
        double sum = 0;
        for (int i = first; i < first + 3; i++)
        {
            sum += covariance[(i * FilterHypothesis.Motion) + i];
        }

        return Math.Sqrt(sum / 3);
    }
}
