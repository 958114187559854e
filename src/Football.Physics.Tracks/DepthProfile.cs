namespace FootballPhysics.Tracks;

/// <summary>Checks the uncertainty of the depth of a launch that is seen from one viewpoint.</summary>
/// <remarks>
/// If a path ends just before a bounce, a slightly lower one bounces within the track and fits far worse, but a higher one fits as well. Secants, which are the
/// same on both sides, then give a depth that pixels do not reveal. The profile minimises the cost at other depths, on either side.
/// </remarks>
internal static class DepthProfile
{
    /// <summary>The first distance from the result, in standard errors and at least in m. Each further one is twice as far.</summary>
    private const double First = 2;
    private const double LeastDistance = 0.05;

    /// <summary>The largest distance, in m, and the standard error from which on a depth is not identified anyway.</summary>
    private const double Farthest = 4;
    private const double Lost = 1;

    /// <summary>The excess of the cost up to which another depth is an alternative: three standard deviations of one parameter. The ratio of the standard
    /// errors from which on the other one counts.</summary>
    private const double AsGood = 9;
    private const double Wider = 1.5;

    /// <summary>The standard deviation with which a depth is held, as a share of the distance.</summary>
    private const double Held = 0.05;

    /// <summary>The decrease of the cost above which the other depth is the better result.</summary>
    private const double Lower = 0.1;

    /// <summary>Widens the covariance along the depth if other depths fit as well.</summary>
    /// <returns>False if another depth fits better; the parameters are then those of that fit.</returns>
    public static bool Widen(Sightings seen, TrackFitRequest request, TrackModel model, double[] values, double cost, double error, double[] covariance, FitWatch watch)
    {
        if (!(error < Lost))
        {
            return true;
        }

        double[] widest = new double[values.Length];
        double most = Wider * error;
        foreach (double sign in (double[])[1, -1])
        {
            for (double distance = Math.Max(LeastDistance, First * error); distance < Farthest; distance *= 2)
            {
                double[] tried = Scaled(seen.FirstCamera!, values, sign * distance);
                double rise = Minimise(seen, request, model, tried, sign * distance, values, watch) - cost;
                if (rise < -Lower)
                {
                    tried.CopyTo(values, 0);
                    return false;
                }

                // If the cost rises by r at a distance d, the standard error is d/√r.
                double share = 1 / Math.Sqrt(Math.Max(1, rise));
                if (rise < AsGood && share * distance > most)
                {
                    most = share * distance;
                    for (int i = 0; i < values.Length; i++)
                    {
                        widest[i] = share * (tried[i] - values[i]);
                    }
                }
            }
        }

        for (int i = 0; i < values.Length && most > Wider * error; i++)
        {
            for (int j = 0; j < values.Length; j++)
            {
                covariance[(i * values.Length) + j] += widest[i] * widest[j];
            }
        }

        return true;
    }

    /// <summary>Returns the launch with the same first pixel at another depth: position and velocity are scaled from the camera.</summary>
    private static double[] Scaled(TrackCamera camera, double[] values, double by)
    {
        var position = new Vector3d(values[0], values[1], values[2]);
        double scale = 1 + (by / camera.Depth(in position));
        Vector3d scaled = camera.Position + (scale * (position - camera.Position));
        double[] moved = [.. values];
        (moved[0], moved[1], moved[2]) = (scaled.X, scaled.Y, scaled.Z);
        for (int i = 3; i < TrackModel.FirstSpin; i++)
        {
            moved[i] *= scale;
        }

        return moved;
    }

    /// <summary>Minimises the cost with the depth held.</summary>
    /// <returns>The cost without the hold.</returns>
    private static double Minimise(Sightings seen, TrackFitRequest request, TrackModel model, double[] tried, double by, double[] from, FitWatch watch)
    {
        double depth = seen.FirstCamera!.Depth(new Vector3d(from[0], from[1], from[2])) + by;
        new TrackSearch(new HeldDepth(seen, depth, Math.Abs(Held * by)), request, model, watch).Descend(tried);
        return new TrackPaths(seen, request, model).Follow(tried, new double[seen.Rows]);
    }

    /// <summary>Observations, and the depth of the first of them.</summary>
    private sealed class HeldDepth(Sightings seen, double depth, double deviation) : OtherResiduals(seen)
    {
        private readonly Sightings _seen = seen;

        public override int Rows => _seen.Rows + 1;

        public override double Miss(int index, in Vector3d position, double[] misses)
        {
            double cost = _seen.Miss(index, in position, misses);
            if (index > 0)
            {
                return cost;
            }

            double off = (depth - FirstCamera!.Depth(in position)) / deviation;
            misses[_seen.Rows] = off;
            return cost + (off * off);
        }
    }
}
