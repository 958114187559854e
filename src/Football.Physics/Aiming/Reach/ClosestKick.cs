namespace Football.Physics;

/// <summary>
/// Which kick comes closest to a target, over all elevations within the bounds. The signed miss distance is a smooth function of the elevation:
/// zero at a hit, negative where a kick is too low or too short. Where it is negative all over, its largest value is the verdict: out of reach.
/// </summary>
internal sealed class ClosestKick
{
    /// <summary>Elevations that are looked at in a wind.</summary>
    private const int Looks = 25;

    private readonly ApproachByElevation _approaches;
    private readonly RollingKick _roll;
    private readonly HitSearch _hits;
    private readonly CoarseSearch _coarse;
    private readonly CompassSearch _compass;
    private readonly Approach[] _looks = new Approach[Looks];

    public ClosestKick(AimContext context)
    {
        _approaches = new ApproachByElevation(context);
        _roll = new RollingKick(context, _approaches);
        _hits = new HitSearch(_approaches);
        var valley = new ValleySearch(_approaches);
        _coarse = new CoarseSearch(_approaches, _roll, valley, _hits);
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
        if (bounds.Highest - bounds.Lowest < 1e-9)
        {
            return _approaches.Accept(_approaches.At(bounds.Lowest));
        }

        if (_approaches.TurnWithAzimuth)
        {
            return _coarse.Find(in problem.Frame, arc);
        }

        // Where the miss changes sign between two elevations there is a hit: that of the wanted arc first.
        for (int i = 0; i < Looks && !_approaches.IsSpent; i++)
        {
            int look = arc == AimArc.Low ? i : Looks - 1 - i;
            _looks[i] = _approaches.At(bounds.Lowest + ((bounds.Highest - bounds.Lowest) * look / (Looks - 1)));
            if (i > 0 && _looks[i].Above != _looks[i - 1].Above && _hits.Between(in _looks[i - 1], in _looks[i]))
            {
                return true;
            }
        }

        return _approaches.Accept(_approaches.Best);
    }
}

/// <summary>The kick along the ground: whatever its elevation, it comes no closer than the target is above it. It is flown once.</summary>
internal sealed class RollingKick
{
    /// <summary>So far below the target, m, the direction of a roll need not be known to the centimetre.</summary>
    private const double WellBelow = 0.25;

    private readonly AimContext _context;
    private readonly ApproachByElevation _approaches;

    public RollingKick(AimContext context, ApproachByElevation approaches)
    {
        _context = context;
        _approaches = approaches;
    }

    /// <summary>Its elevation, rad.</summary>
    public double Elevation { get; private set; }

    /// <summary>What its miss distance is not below, m; infinite where the ball does not roll, or has been flown.</summary>
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
        double climb = _context.Scene.Ground.MinimumBounceSpeed / problem.Speed;
        double steepEnough = climb < 1 ? Elementary.Atan2(climb, Math.Sqrt(1.0 - (climb * climb))) * (1.0 + 1e-9) : double.PositiveInfinity;
        _approaches.Bounds = new ElevationBounds(Math.Max(bounds.Lowest, steepEnough), bounds.Highest);
    }

    /// <summary>Flies it.</summary>
    public Approach Fly()
    {
        double bound = LowerBound;
        LowerBound = double.PositiveInfinity;
        if (_approaches.TurnWithAzimuth && bound > WellBelow && _context.Steps.Roll is { } step)
        {
            // Well below a target only the direction counts, and even that little; where the ball stops short, the rest does too.
            Approach rough = _approaches.RollRoughly(Elevation, step);
            if (rough.Miss <= bound + (0.1 * ValleySearch.Closeness))
            {
                return rough;
            }
        }

        return _approaches.Roll(Elevation);
    }
}

/// <summary>Three elevations and parabolas through them: enough where they hit, or miss by far.</summary>
internal sealed class CoarseSearch
{
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
    /// <returns>Whether a hit was found.</returns>
    public bool Find(in TargetFrame frame, AimArc arc)
    {
        // 1. Downhill to three elevations about the closest. 2. Where none passes above, to the bottom between them, and to the waves beside it.
        // 3. Where one does, the hit between it and one that passes below.
        Vector3d way = frame.Target - frame.From;
        double sight = Elementary.Atan2(way.Y, Math.Max(frame.Distance, 1e-9));
        ApproachBracket at = Downhill(sight);
        return (at.AnyAbove || Bottom(ref at)) && _hits.Beside(in at, arc);
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
