namespace Football.Physics;

/// <summary>The least miss distance around three elevations, by successive parabolas; at a bound through the two nearest.</summary>
internal sealed class ValleySearch
{
    /// <summary>Flights that may be spent on the bottom of one valley.</summary>
    private const int MostShots = 30;

    /// <summary>How near to a bound, rad, a kick must be that is further off than the one at the bound: the drag law's jump makes small waves.</summary>
    private const double NearBound = 0.06;

    private readonly ApproachByElevation _approaches;

    public ValleySearch(ApproachByElevation approaches) => _approaches = approaches;

    /// <summary>A kick is the closest where no other is closer by more than this, m, or this share of its miss.</summary>
    public static double Closeness => 5e-4;

    /// <summary>Searches for the bottom.</summary>
    /// <param name="at">Three elevations; on return those around the bottom.</param>
    /// <param name="enough">A miss distance that is known to be had elsewhere, m: a valley that is shallower need not be searched on.</param>
    /// <returns>True where the target lies on the other side of the way of the middle kick than of its neighbours': there are hits between.</returns>
    public bool Descend(ref ApproachBracket at, double enough)
    {
        bool above = at.Middle.Above;
        for (int i = 0; i < MostShots && !_approaches.IsSpent; i++)
        {
            double left = at.Left;
            double right = at.Right;
            if (!(left > 0 && right > 0) || Math.Max(left, right) < 1e-6 || at.LowerBound > enough || !Move(in at, out double move))
            {
                return false;
            }

            Approach next = _approaches.At(at.Middle.Elevation + move, in at.Middle);
            bool crossed = next.Above != above;
            at.Insert(in next, becomesMiddle: crossed);
            if (crossed)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Where to look next, from the middle elevation.</summary>
    /// <returns>False where the bottom is known well enough.</returns>
    private static bool Move(in ApproachBracket at, out double move)
    {
        double left = at.Left;
        double right = at.Right;
        at.Parabola(out double slope, out double curvature);
        if (at.Low.Miss < at.Middle.Miss || at.High.Miss < at.Middle.Miss)
        {
            // At a bound: downhill to the very end? The slope there is known up to a third derivative like the second.
            bool atRight = at.High.Miss < at.Low.Miss;
            double near = atRight ? right : left;
            double atBound = atRight ? slope + (curvature * right) : (curvature * left) - slope;
            move = (atRight ? 0.7 : -0.7) * near;
            return !((atBound < -Math.Abs(curvature) * near * (left + right) && near < NearBound) || near < 1e-4);
        }

        move = curvature > 0 ? -slope / curvature : 0;

        // The vertex is off by about half the product of the neighbours' distances, with such a third derivative.
        double doubt = 0.5 * left * right;
        if (0.5 * curvature * ((doubt * doubt) + (move * move)) < Closeness * Math.Max(1.0, at.Middle.Miss))
        {
            return false;
        }

        double least = 0.05 * Math.Max(left, right);
        if (Math.Abs(move) < least)
        {
            // No news from there: towards the further neighbour instead.
            least = Math.Max(least, 0.06);
            move = left > right ? -Math.Min(0.5 * left, least) : Math.Min(0.5 * right, least);
        }

        move = Math.Min(Math.Max(move, -0.9 * left), 0.9 * right);
        return true;
    }
}
