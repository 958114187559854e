namespace Football.Physics;

/// <summary>
/// The library's own solver for one target: Newton's method on the crossing of the target's plane, which takes two flights and a bit. Where
/// that fails, leaves the bounds or meets the ground, the closest approach over all elevations gives the hit, or the verdict that there is none.
/// </summary>
internal sealed class DirectAim : IAimMethod
{
    /// <summary>What the solver's own steps may be off, m: a closer miss is none, even where a request is content with less.</summary>
    private const double StepError = 1e-4;

    private readonly PlaneProblem _problem;
    private readonly ClosestKick _closest;

    public DirectAim(AimContext context, PlaneProblem problem)
    {
        _problem = problem;
        _closest = new ClosestKick(context);
    }

    public AimSolution Find(AimRequest request) => Find(request, request.Speed, request.Arc);

    /// <summary>Finds a kick with a speed and on an arc other than the request's.</summary>
    public AimSolution Find(AimRequest request, double speed, AimArc arc) => Find(request, speed, arc, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with spins other than the request's.</summary>
    public AimSolution FindSpun(AimRequest request, double top, double side) => Find(request, request.Speed, request.Arc, top, side);

    private AimSolution Find(AimRequest request, double speed, AimArc arc, double top, double side)
    {
        _problem.Set(request, speed, top, side);
        ref readonly TargetFrame frame = ref _problem.Frame;
        if (arc == AimArc.Low && frame.Distance >= 1e-6 && BroydenShooting.Solve(_problem, out PlaneShot shot) && _problem.StaysClear(in shot))
        {
            return new AimSolution
            {
                Status = AimStatus.Hit,
                Kick = shot.Kick,
                Forward = frame.Forward,
                Speed = speed,
                Miss = shot.Miss,
                Time = shot.Time,
                Iterations = _problem.Shots,
            };
        }

        Approach found = _closest.Find(_problem, arc);
        return new AimSolution
        {
            // Straight above or below only the elevation matters; at the ball there is no direction at all.
            Status = found.Miss <= request.Tolerance ? AimStatus.Hit
                : frame.IsDegenerate ? AimStatus.Degenerate
                : found.Miss < StepError ? AimStatus.NotConverged
                : AimStatus.OutOfReach,
            Kick = found.Kick,
            Forward = frame.Forward,
            Speed = speed,
            Miss = found.Miss,
            Time = found.Time,
            Iterations = _problem.Shots + _closest.Shots,
        };
    }
}
