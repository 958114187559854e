using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Finds the kick that comes closest to a target, over all elevations within the bounds.</summary>
/// <remarks>
/// The signed miss is a smooth function of the elevation: it is zero at a hit, and negative if a kick is too low or too short. If it is negative everywhere,
/// the target is out of reach, and the maximum belongs to the closest kick.
/// </remarks>
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
        // 1. Search flights. 2. Try a roll if a roll may be closer. 3. In wind, which couples elevation and azimuth, search around the closest kick.
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

    /// <summary>True if all flights of the last search pass below the target or end short of it.</summary>
    public bool IsShort => !_approaches.AnyAbove;

    /// <summary>True if it is certain that no flight of the last search hits: in still air, after flights over all elevations.</summary>
    /// <remarks>The search has simulated the kick along the ground, or its height alone keeps it farther away than the closest kick.</remarks>
    public bool IsOutOfReach() =>
        _approaches.TurnWithAzimuth && (_approaches.Bounds.Lowest > _approaches.Bounds.Highest || _approaches.Cover.Excludes(_approaches));

    /// <summary>Returns the closest kick along the ground.</summary>
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

        // A single elevation needs no search.
        if (bounds.Highest - bounds.Lowest < 1e-9)
        {
            return _approaches.Accept(_approaches.At(bounds.Lowest));
        }

        return _approaches.TurnWithAzimuth && _coarse.Find(in problem.Frame, arc, out bool hit) ? hit : _close.Find(arc);
    }
}

/// <summary>The kick along the ground; its miss is at least the height of the target above the ball.</summary>
/// <remarks>Its elevation has no effect, so it is simulated only once.</remarks>
internal sealed class RollingKick(AimContext context, ApproachByElevation approaches)
{
    private readonly AimContext _context = context;
    private readonly ApproachByElevation _approaches = approaches;

    /// <summary>The elevation, in rad.</summary>
    public double Elevation { get; private set; }

    /// <summary>The lower bound of the miss, in m; infinite if the ball does not roll, or the roll has already been simulated.</summary>
    public double LowerBound { get; private set; }

    /// <summary>Prepares for a problem, and restricts the elevations of flights to those at which the ball leaves the ground.</summary>
    public void Begin(PlaneProblem problem)
    {
        ElevationBounds bounds = problem.Bounds;
        Elevation = bounds.Clamp(_context.AlongGround(in problem.Frame.From, in problem.Frame.Forward));
        LowerBound = double.PositiveInfinity;
        if (!_context.StaysDown(in problem.Frame, Kick.Of(problem.Request, Elevation, 0), problem.Speed))
        {
            return;
        }

        if (!_context.IsLevel)
        {
            // The slope of a kick along the ground depends on its direction, and a flight may begin at any elevation.
            LowerBound = 0;
            return;
        }

        // A ball on the ground rolls at low elevations, and leaves the ground at higher ones.
        LowerBound = problem.Request.TargetVelocity.Y == 0 ? Math.Abs(problem.Frame.Target.Y - _context.Game.ContactHeight) : 0;

        // At sin ε = climb, the upward speed equals the minimum bounce speed: a steeper kick leaves the ground.
        double climb = _context.Scene.Ground.MinimumBounceSpeed / problem.Speed;
        double steepEnough = climb < 1 ? Elementary.Atan2(climb, Math.Sqrt(1.0 - (climb * climb))) * (1.0 + 1e-9) : double.PositiveInfinity;
        _approaches.Bounds = new ElevationBounds(Math.Max(bounds.Lowest, steepEnough), bounds.Highest);
    }

    /// <summary>Simulates the kick.</summary>
    public Approach Fly()
    {
        LowerBound = double.PositiveInfinity;
        return _approaches.Roll(Elevation);
    }
}

/// <summary>Searches with three elevations and parabolas, which suffice for a hit or a clear miss.</summary>
internal sealed class CoarseSearch(ApproachByElevation approaches, RollingKick roll, ValleySearch valley, HitSearch hits)
{
    /// <summary>The miss, as a share of the distance, above which three elevations and a parabola are conclusive.</summary>
    private const double ClearMiss = 0.002;

    private readonly ApproachByElevation _approaches = approaches;
    private readonly RollingKick _roll = roll;
    private readonly ValleySearch _valley = valley;
    private readonly WaveSearch _waves = new(approaches, valley);
    private readonly HitSearch _hits = hits;

    /// <summary>Runs the search.</summary>
    /// <returns>False if a finer search is necessary.</returns>
    public bool Find(in TargetFrame frame, AimArc arc, out bool hit)
    {
        hit = false;
        // 1. Move downhill to three elevations around the closest one. 2. If no kick passes above, descend to the minimum between them, and into the
        // waves nearby. 3. If a kick passes above, find the hit between this kick and one that passes below.
        Vector3d way = frame.Target - frame.From;
        double sight = Elementary.Atan2(way.Y, Math.Max(frame.Distance, 1e-9));
        ApproachBracket at = Downhill(sight);
        if (at.AnyAbove || Bottom(ref at))
        {
            hit = _hits.Beside(in at, arc);
            return hit;
        }

        // A large miss is conclusive; near the target, the parabola may hide a hit.
        return at.LeastMiss > ClearMiss * frame.Distance && at.LeastMiss > 10 * _approaches.Tolerance;
    }

    /// <summary>Finds three elevations: the closest in the middle or at a bound, or one that passes above.</summary>
    /// <param name="sight">The elevation of the line of sight to the target, in rad.</param>
    private ApproachBracket Downhill(double sight)
    {
        double lowest = _approaches.Bounds.Lowest;
        double highest = _approaches.Bounds.Highest;
        double span = highest - lowest;

        // In vacuum, the kick that goes farthest is half-way between the line of sight and the vertical; in air, it is lower.
        double middle = Math.Min(Math.Max(0.55 + (0.5 * sight), lowest + (0.25 * span)), highest - (0.25 * span));
        Approach a = _approaches.At(Math.Max(lowest, middle - 0.3));
        Approach b = _approaches.At(middle);
        Approach c = _approaches.At(Math.Min(highest, middle + 0.25));
        while (!_approaches.IsSpent && !b.Above && (a.Miss < b.Miss || c.Miss < b.Miss))
        {
            // The neighbour with the smaller miss becomes the middle; the golden ratio lengthens the next interval.
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

    /// <summary>Finds the minimum of the valley of three elevations, and the waves near it.</summary>
    /// <returns>As <see cref="ValleySearch.Descend"/>.</returns>
    private bool Bottom(ref ApproachBracket at)
    {
        // A roll below the target is already closer than any flight: the closest flight need not be more accurate.
        bool above = _valley.Descend(ref at, enough: _roll.LowerBound);
        double bound = at.LowerBound;
        if (!above && _roll.LowerBound < at.Middle.Miss && !(_roll.Fly().Miss < bound))
        {
            above = _valley.Descend(ref at, enough: double.PositiveInfinity);
        }

        return above || (_approaches.Best.Elevation != _roll.Elevation && _waves.Find(ref at));
    }
}

/// <summary>Searches many elevations: every change of sign of the miss is a hit, and every valley is searched to its minimum.</summary>
internal sealed class CloseSearch(ApproachByElevation approaches, ValleySearch valley, HitSearch hits)
{
    private const int Looks = 25;

    private readonly ApproachByElevation _approaches = approaches;
    private readonly ValleySearch _valley = valley;
    private readonly HitSearch _hits = hits;
    private readonly Approach[] _looks = new Approach[Looks];

    /// <summary>Runs the search.</summary>
    /// <returns>True if a hit was found.</returns>
    public bool Find(AimArc arc)
    {
        // 1. Sample all elevations. 2. Find a hit between neighbours on opposite sides of the target, starting at the requested arc. 3. Descend into
        // every valley, because a kick between two samples may pass above the target. 4. Return the closest kick.
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
