namespace Football.Physics;

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

    /// <summary>Kicks flown by the last search.</summary>
    public int Shots => _approaches.Shots;

    /// <summary>Searches all elevations within the bounds.</summary>
    /// <param name="problem">What the kick is to do.</param>
    /// <param name="arc">Which of two hits is wanted.</param>
    /// <returns>A hit within the problem's tolerance, or the closest kick.</returns>
    public Approach Find(PlaneProblem problem, AimArc arc)
    {
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

    /// <summary>Searches the elevations at which the ball flies.</summary>
    private bool Flying(PlaneProblem problem, AimArc arc)
    {
        ElevationBounds bounds = _approaches.Bounds;
        if (bounds.Highest - bounds.Lowest < 1e-9)
        {
            return _approaches.Accept(_approaches.At(bounds.Lowest));
        }

        return _approaches.TurnWithAzimuth && _coarse.Find(in problem.Frame, arc, out bool hit) ? hit : _close.Find(arc);
    }
}
