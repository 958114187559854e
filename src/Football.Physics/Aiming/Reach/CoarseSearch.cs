namespace Football.Physics;

/// <summary>Three elevations and parabolas through them: enough where they hit, or miss by far.</summary>
internal sealed class CoarseSearch
{
    /// <summary>Share of the target's distance by which three elevations and a parabola must miss it to need no closer look.</summary>
    private const double ClearMiss = 0.002;

    private readonly ApproachByElevation _approaches;
    private readonly RollingKick _roll;
    private readonly ValleySearch _valley;
    private readonly WaveSearch _waves;
    private readonly HitSearch _hits;

    public CoarseSearch(ApproachByElevation approaches, RollingKick roll, ValleySearch valley, HitSearch hits)
    {
        _approaches = approaches;
        _roll = roll;
        _valley = valley;
        _waves = new WaveSearch(approaches, valley);
        _hits = hits;
    }

    /// <summary>Searches.</summary>
    /// <param name="frame">The frame of the target.</param>
    /// <param name="arc">Which of two hits is wanted.</param>
    /// <param name="hit">Whether a hit was found.</param>
    /// <returns>False where it takes a closer look.</returns>
    public bool Find(in TargetFrame frame, AimArc arc, out bool hit)
    {
        hit = false;
        Vector3d way = frame.Target - frame.From;
        double sight = Elementary.Atan2(way.Y, Math.Max(frame.Distance, 1e-9));
        ApproachBracket at = Downhill(sight);
        if (at.AnyAbove || Bottom(ref at))
        {
            hit = _hits.Beside(in at, arc);
            return hit;
        }

        return at.LeastMiss > ClearMiss * frame.Distance && at.LeastMiss > 10 * _approaches.Tolerance;
    }

    /// <summary>Three elevations, of which the closest is in the middle, or at a bound, or one passes above.</summary>
    /// <param name="sight">Elevation of the line to the target, rad.</param>
    private ApproachBracket Downhill(double sight)
    {
        double lowest = _approaches.Bounds.Lowest;
        double highest = _approaches.Bounds.Highest;
        double span = highest - lowest;

        // Without air the farthest kick is half-way between the line of sight and the vertical; with it, it is lower.
        double middle = Math.Min(Math.Max(0.55 + (0.5 * sight), lowest + (0.25 * span)), highest - (0.25 * span));
        Approach a = _approaches.At(Math.Max(lowest, middle - 0.3));
        Approach b = _approaches.At(middle);
        Approach c = _approaches.At(Math.Min(highest, middle + 0.25));
        while (!_approaches.IsSpent && !b.Above && (a.Miss < b.Miss || c.Miss < b.Miss))
        {
            if (c.Miss < b.Miss)
            {
                if (c.Above || c.Elevation >= highest)
                {
                    break;
                }

                (a, b) = (b, c);
                c = _approaches.At(Math.Min(highest, b.Elevation + (1.6 * (b.Elevation - a.Elevation))));
            }
            else
            {
                if (a.Above || a.Elevation <= lowest)
                {
                    break;
                }

                (b, c) = (a, b);
                a = _approaches.At(Math.Max(lowest, b.Elevation - (1.6 * (c.Elevation - b.Elevation))));
            }
        }

        return new ApproachBracket(in a, in b, in c);
    }

    /// <summary>The bottom of the valley that three elevations span, and the waves beside it.</summary>
    /// <returns>As <see cref="ValleySearch.Descend"/>.</returns>
    private bool Bottom(ref ApproachBracket at)
    {
        // Where a ball that rolls below the target is closer than any that flies, the closest of those need not be known any better.
        bool above = _valley.Descend(ref at, enough: _roll.LowerBound);
        double bound = at.LowerBound;
        if (!above && _roll.LowerBound < at.Middle.Miss && !(_roll.Fly().Miss < bound))
        {
            above = _valley.Descend(ref at, enough: double.PositiveInfinity);
        }

        return above || (_approaches.Best.Elevation != _roll.Elevation && _waves.Find(ref at));
    }
}
