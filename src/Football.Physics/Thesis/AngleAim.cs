namespace Football.Physics;

/// <summary>The thesis' Method A (4.1): fly, and turn the velocity by the angle between where the ball went and the target.</summary>
internal sealed class AngleAim
{
    private readonly FrameProblem _problem;

    public AngleAim(AimContext context, FrameShooter frames) => _problem = new FrameProblem(context, frames);

    public AimSolution Find(AimRequest request)
    {
        _problem.Set(request, request.TopSpin, request.SideSpin);
        return _problem.BetweenExtremes(out AimSolution extreme) ? Iterate(request, FrameProblem.Margin) : extreme;
    }

    /// <summary>The iteration alone, from a kick that is not an extreme one: the two-point method's last resort.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="start">Where to begin.</param>
    /// <param name="margin">Share of the tolerance within which it ends.</param>
    public AimSolution Refine(AimRequest request, in Kick start, double margin)
    {
        _problem.Set(request, start.Top, start.Side);
        _problem.Fly(in start);
        return Iterate(request, margin);
    }

    private AimSolution Iterate(AimRequest request, double margin)
    {
        int iterations = 0;
        while (_problem.Miss > margin * request.Tolerance && iterations < request.MaximumIterations)
        {
            iterations++;
            Kick turned = Turned();
            if (turned.Elevation == _problem.Kick.Elevation && turned.Azimuth == _problem.Kick.Azimuth)
            {
                break;
            }

            _problem.Fly(in turned);
        }

        return _problem.Best(iterations);
    }

    private Kick Turned()
    {
        ref readonly TargetFrame frame = ref _problem.Frame;
        _problem.Kick.Vectors(1.0, in frame.Forward, out Vector3d direction, out _);
        return AngleCorrection.Turn(_problem.Closest - frame.From, frame.Target - frame.From, ref direction)
            ? frame.Turned(_problem.Kick, in direction, _problem.Bounds)
            : _problem.Kick;
    }
}
