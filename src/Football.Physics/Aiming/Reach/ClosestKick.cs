namespace FootballPhysics.Aiming;

/// <summary>
/// Which kick comes closest to a target, over all elevations within the bounds. The signed miss distance is a smooth function of the elevation:
/// zero at a hit, negative where a kick is too low or too short. Where it is negative all over, its largest value is the verdict: out of reach.
/// </summary>
internal sealed class ClosestKick
{
    private readonly ApproachByElevation _approaches;
    private readonly RollingKick _roll;
    private readonly HitSearch _hits;
    private readonly CoarseSearch _coarse;
    private readonly CloseSearch _close;
    private readonly CompassSearch _compass;

    public ClosestKick(AimContext context)
    {
        _approaches = new ApproachByElevation(context);
        _roll = new RollingKick(context, _approaches);
        _hits = new HitSearch(_approaches);
        var valley = new ValleySearch(_approaches);
        _coarse = new CoarseSearch(_approaches, _roll, valley, _hits);
        _close = new CloseSearch(_approaches, valley, _hits);
        _compass = new CompassSearch(_approaches);
    }

    /// <summary>Searches all elevations within the bounds.</summary>
    /// <returns>A hit within the problem's tolerance, or the closest kick.</returns>
    public Approach Find(PlaneProblem problem, AimArc arc)
    {
        // Flights first, then the roll where it may be closer than what flew, then a search beside the closest where a wind couples elevation and azimuth.
        _approaches.Aim(problem);
        _hits.Begin(problem.Request);
        _roll.Begin(problem);
        if (_approaches.Bounds.Lowest <= _approaches.Bounds.Highest && Flying(problem, arc))
        {
            return _approaches.Hit;
        }

        if (_roll.LowerBound < _approaches.Best.Miss && _approaches.Accept(_roll.Fly()))
        {
            return _approaches.Hit;
        }

        if (!_approaches.TurnWithAzimuth)
        {
            _compass.Find(rolls: _approaches.Best.Elevation == _roll.Elevation);
        }

        return _approaches.Best;
    }

    /// <summary>The closest kick along the ground.</summary>
    public Approach Roll(PlaneProblem problem)
    {
        _approaches.Aim(problem);
        _roll.Begin(problem);
        return _roll.Fly();
    }

    /// <summary>Searches the elevations at which the ball flies.</summary>
    private bool Flying(PlaneProblem problem, AimArc arc)
    {
        ElevationBounds bounds = _approaches.Bounds;

        // A single elevation is flown, not searched.
        if (bounds.Highest - bounds.Lowest < 1e-9)
        {
            return _approaches.Accept(_approaches.At(bounds.Lowest));
        }

        return _approaches.TurnWithAzimuth && _coarse.Find(in problem.Frame, arc, out bool hit) ? hit : _close.Find(arc);
    }
}

/// <summary>The kick along the ground: whatever its elevation, it comes no closer than the target is above it. It is flown once.</summary>
internal sealed class RollingKick
{
    private readonly AimContext _context;
    private readonly ApproachByElevation _approaches;

    public RollingKick(AimContext context, ApproachByElevation approaches)
    {
        _context = context;
        _approaches = approaches;
    }

    /// <summary>Its elevation, rad.</summary>
    public double Elevation { get; private set; }

    /// <summary>Lower bound of its miss distance, m; infinite where the ball does not roll, or has been flown.</summary>
    public double LowerBound { get; private set; }

    /// <summary>Prepares for a problem, and narrows the elevations of flights to those that leave the ground.</summary>
    public void Begin(PlaneProblem problem)
    {
        ElevationBounds bounds = problem.Bounds;
        Elevation = bounds.Clamp(0);
        LowerBound = double.PositiveInfinity;
        Elementary.SinCos(Elevation, out double sine, out _);
        if (!_context.StaysDown(in problem.Frame.From, problem.Speed * sine))
        {
            return;
        }

        // On the ground there are two ways to go: to roll along it, whatever the elevation, or to leave it at a steeper one.
        LowerBound = problem.Request.TargetVelocity.Y == 0 ? Math.Abs(problem.Frame.Target.Y - _context.Game.ContactHeight) : 0;

        // sin ε = climb: what leaves the ground faster than the least bounce flies.
        double climb = _context.Scene.Ground.MinimumBounceSpeed / problem.Speed;
        double steepEnough = climb < 1 ? Elementary.Atan2(climb, Math.Sqrt(1.0 - (climb * climb))) * (1.0 + 1e-9) : double.PositiveInfinity;
        _approaches.Bounds = new ElevationBounds(Math.Max(bounds.Lowest, steepEnough), bounds.Highest);
    }

    /// <summary>Flies it.</summary>
    public Approach Fly()
    {
        LowerBound = double.PositiveInfinity;
        return _approaches.Roll(Elevation);
    }
}

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
    /// <returns>False where it takes a closer look.</returns>
    public bool Find(in TargetFrame frame, AimArc arc, out bool hit)
    {
        hit = false;
        // 1. Downhill to three elevations about the closest. 2. Where none passes above, to the bottom between them, and to the waves beside it.
        // 3. Where one does, the hit between it and one that passes below.
        Vector3d way = frame.Target - frame.From;
        double sight = Elementary.Atan2(way.Y, Math.Max(frame.Distance, 1e-9));
        ApproachBracket at = Downhill(sight);
        if (at.AnyAbove || Bottom(ref at))
        {
            hit = _hits.Beside(in at, arc);
            return hit;
        }

        // A clear miss needs no closer look; near the target the parabola may hide a hit.
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
            // The closer neighbour becomes the middle; beyond it the next look is wider apart by the golden ratio.
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

/// <summary>Many elevations: every change of sign of the miss distance is a hit, and every valley is searched to its bottom.</summary>
internal sealed class CloseSearch
{
    private const int Looks = 25;

    private readonly ApproachByElevation _approaches;
    private readonly ValleySearch _valley;
    private readonly HitSearch _hits;
    private readonly Approach[] _looks = new Approach[Looks];

    public CloseSearch(ApproachByElevation approaches, ValleySearch valley, HitSearch hits)
    {
        _approaches = approaches;
        _valley = valley;
        _hits = hits;
    }

    /// <summary>Searches.</summary>
    /// <returns>Whether a hit was found.</returns>
    public bool Find(AimArc arc)
    {
        // 1. Looks all over the elevations. 2. A hit between two neighbours of which one passes above, from the end of the wanted arc. 3. The bottom of every valley: it may
        // reach above the target between two looks. 4. What came closest.
        double lowest = _approaches.Bounds.Lowest;
        double highest = _approaches.Bounds.Highest;
        for (int i = 0; i < Looks; i++)
        {
            if (_approaches.IsSpent)
            {
                return _approaches.Accept(_approaches.Best);
            }

            _looks[i] = _approaches.At(i == Looks - 1 ? highest : lowest + ((highest - lowest) * i / (Looks - 1)));
        }

        for (int i = 1; i < Looks; i++)
        {
            int at = arc == AimArc.Low ? i : Looks - i;
            if (_looks[at - 1].Above != _looks[at].Above && _hits.Between(in _looks[at - 1], in _looks[at]))
            {
                return true;
            }
        }

        for (int i = 0; i < Looks; i++)
        {
            double miss = _looks[i].Miss;
            if (miss <= _looks[Math.Max(0, i - 1)].Miss && miss <= _looks[Math.Min(Looks - 1, i + 1)].Miss && FindInValley(i, arc))
            {
                return true;
            }
        }

        return _approaches.Accept(_approaches.Best);
    }

    private bool FindInValley(int look, AimArc arc)
    {
        int middle = Math.Min(Math.Max(look, 1), Looks - 2);
        var at = new ApproachBracket(in _looks[middle - 1], in _looks[middle], in _looks[middle + 1]);
        if (!_valley.Descend(ref at, enough: double.PositiveInfinity))
        {
            return false;
        }

        return arc == AimArc.Low
            ? _hits.Between(in at.Low, in at.Middle) || _hits.Between(in at.High, in at.Middle)
            : _hits.Between(in at.High, in at.Middle) || _hits.Between(in at.Low, in at.Middle);
    }
}
