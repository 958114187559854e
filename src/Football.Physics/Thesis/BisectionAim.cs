namespace Football.Physics;

/// <summary>The thesis' Method B (4.2): bisection over the elevation, the azimuth corrected by the horizontal angle each time.</summary>
internal sealed class BisectionAim
{
    private readonly FrameProblem _problem;

    public BisectionAim(AimContext context, FrameShooter frames) => _problem = new FrameProblem(context, frames);

    public AimSolution Find(AimRequest request) => Find(request, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with spins other than the request's.</summary>
    public AimSolution Find(AimRequest request, double top, double side)
    {
        _problem.Set(request, top, side);
        if (!_problem.BetweenExtremes(out AimSolution extreme))
        {
            return extreme;
        }

        double low = _problem.Bounds.Lowest;
        double high = _problem.Bounds.Highest;
        var passes = new PassesAbove(_problem, FrameProblem.Margin * request.Tolerance);
        if (_problem.Miss > passes.Tolerance)
        {
            Roots.Bisect(ref passes, ref low, ref high, request.MaximumIterations);
        }

        return _problem.Best(passes.Iterations);
    }

    /// <summary>Whether a kick of an elevation passes above the target; done where it hits.</summary>
    private struct PassesAbove : ICondition
    {
        private readonly FrameProblem _problem;
        private double _azimuth;

        public PassesAbove(FrameProblem problem, double tolerance)
        {
            _problem = problem;
            _azimuth = problem.Kick.Azimuth + problem.HorizontalAngle();
            Tolerance = tolerance;
            Iterations = 0;
        }

        public double Tolerance { get; }

        public int Iterations { get; private set; }

        public bool Evaluate(double x, out bool holds)
        {
            Iterations++;
            Kick kick = _problem.Kick;
            kick.Elevation = x;
            kick.Azimuth = _azimuth;
            _problem.Fly(in kick);
            _azimuth += _problem.HorizontalAngle();
            holds = !(_problem.Closest.Y < _problem.Frame.Target.Y);
            return !(_problem.Miss > Tolerance);
        }
    }
}
