namespace Football.Physics;

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
