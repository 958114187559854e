namespace Football.Physics;

/// <summary>
/// The library's own solver for a point on the way and a target: Newton's method in four unknowns, start and first Jacobian in closed form,
/// Broyden's updates, spins within their limits. Where it does not converge, the target comes first: it is hit with the spins that came nearest.
/// </summary>
internal sealed class DirectTwoPointAim : IAimMethod
{
    private const int N = TwoPointProblem.Size;
    private const int MostIterations = 20;

    /// <summary>How often a step that does not reach both planes is halved.</summary>
    private const int MostHalvings = 4;

    /// <summary>Below this elevation, rad, there is but one kick.</summary>
    private const double FlatKick = 0.5;

    /// <summary>Flights after which the next correction is foretold by the last: the first update of a Jacobian of four unknowns tells of one.</summary>
    private const int LeastFlights = 3;

    /// <summary>Kicks to begin with where the closed form leads nowhere.</summary>
    private const int Starts = 10;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly TimeSearch _times;
    private readonly TwoPointProblem _problem;
    private readonly TwoPointJacobian _jacobian;
    private readonly DampedTwoPointNewton _damped;
    private readonly TwoPointStep _step = new();
    private readonly double[] _x = new double[N];
    private readonly double[] _r = new double[N];
    private readonly double[] _nextX = new double[N];
    private readonly double[] _nextR = new double[N];

    public DirectTwoPointAim(AimContext context, DirectAim direct, TimeSearch times)
    {
        _times = times;
        _context = context;
        _direct = direct;
        _problem = new TwoPointProblem(context);
        _jacobian = new TwoPointJacobian(context);
        _damped = new DampedTwoPointNewton(_problem, _jacobian);
    }

    public AimSolution Find(AimRequest request)
    {
        if (!_problem.Set(request))
        {
            AimSolution alone = _direct.Find(request);
            alone.ThroughMiss = double.NaN;
            return alone;
        }

        AimSolution solution = Solve();
        if (Passes(in solution) || (solution.Status == AimStatus.Hit && solution.Kick.Elevation < FlatKick))
        {
            // A flat kick is the only one: where its spin is at the limit, no other passes the point.
            return solution;
        }

        // From elsewhere there may be one that the closed form is too far from.
        AimSolution best = solution;
        for (int start = 0; start < Starts && !_context.IsSpent; start++)
        {
            if (FromTarget(start, out AimSolution other) && (best.Status != AimStatus.Hit || other.ThroughMiss < best.ThroughMiss))
            {
                best = other;
                if (Passes(in best))
                {
                    break;
                }
            }
        }

        return best.Status == AimStatus.Hit ? best : TargetFirst(in solution);
    }

    private bool Passes(in AimSolution solution) =>
        solution.Status == AimStatus.Hit && solution.ThroughMiss <= _problem.Request.ThroughTolerance;

    /// <summary>Begins with a kick that hits the target, and ends with it where that leads no nearer to the point: on either arc, without spin, and with much of one kind.</summary>
    private bool FromTarget(int start, out AimSolution solution)
    {
        AimRequest request = _problem.Request;
        int spin = start / 2;
        double top = spin is 1 or 2 ? (spin == 1 ? -0.6 : 0.6) * request.MaximumTopSpin : 0;
        double side = spin is 3 or 4 ? (spin == 3 ? -0.6 : 0.6) * request.MaximumSideSpin : 0;
        if (!_times.WithSpeed(request, request.Speed, start % 2 == 0 ? AimArc.Low : AimArc.High, top, side, out solution))
        {
            return false;
        }

        _problem.Set(request);
        _x[TwoPointProblem.Elevation] = solution.Kick.Elevation;
        _x[TwoPointProblem.Azimuth] = solution.Kick.Azimuth;
        _x[TwoPointProblem.Top] = top;
        _x[TwoPointProblem.Side] = side;
        if (_damped.Solve(_x))
        {
            solution = Solution(AimStatus.Hit);
        }
        else
        {
            solution.ThroughMiss = double.PositiveInfinity;
        }

        return true;
    }

    /// <summary>The unknowns as the last flight had them.</summary>
    private AimSolution Solution(AimStatus status) => new()
    {
        Status = status,
        Forward = _problem.Frame.Forward,
        Speed = _problem.Request.Speed,
        Kick = TwoPointProblem.KickOf(_x),
        Miss = _problem.Miss,
        ThroughMiss = _problem.ThroughMiss,
        Time = _problem.AtTarget.Time,
    };

    /// <summary>The target alone, with the spins that came nearest to both, or else with as much lift as is allowed.</summary>
    private AimSolution TargetFirst(in AimSolution nearest)
    {
        AimRequest request = _problem.Request;
        AimSolution single = _direct.Find(request, request.Speed, request.Arc, nearest.Kick.Top, nearest.Kick.Side);
        single.ThroughMiss = nearest.ThroughMiss;
        if (single.Status != AimStatus.Hit)
        {
            AimSolution lifted = _direct.Find(request, request.Speed, request.Arc, -request.MaximumTopSpin, 0);
            if (lifted.Status == AimStatus.Hit || lifted.Miss < single.Miss)
            {
                lifted.ThroughMiss = single.ThroughMiss;
                return lifted;
            }
        }

        return single;
    }

    private AimSolution Solve()
    {
        TwoPointGuess.Make(_context, _problem, _x);
        _step.Reset();
        var solution = new AimSolution
        {
            Status = AimStatus.NotConverged,
            Forward = _problem.Frame.Forward,
            Speed = _problem.Request.Speed,
            Kick = TwoPointProblem.KickOf(_x),
            ThroughMiss = double.NaN,
        };
        _context.CountIteration();
        if (!_problem.Fly(_x, _r))
        {
            return solution;
        }

        _jacobian.ReadOff(_problem, _x);
        int limit = Math.Min(_problem.Request.MaximumIterations, MostIterations);
        double before = double.PositiveInfinity;
        int flights = 1;
        while (true)
        {
            double asked = _step.ThroughAsked(_r);
            solution.Kick = TwoPointProblem.KickOf(_x);
            solution.Miss = _problem.Miss;
            solution.ThroughMiss = _problem.ThroughMiss;
            solution.Time = _problem.AtTarget.Time;
            if (_problem.Miss <= _problem.Tolerance && asked <= _problem.ThroughTolerance)
            {
                solution.Status = _problem.StaysClear(_x) ? AimStatus.Hit : AimStatus.NotConverged;
                return solution;
            }

            if (_context.Iterations >= limit || !_step.Solve(_problem, _jacobian, _x, _r, out bool sameHeld))
            {
                return solution;
            }

            double size = Math.Sqrt((_problem.Miss * _problem.Miss) + (asked * asked));
            if (sameHeld && flights >= LeastFlights && Convergence.IsPlenty(size, before, _problem.Tolerance, out double contraction) && _problem.StaysClear(_x))
            {
                TakeStep();
                solution.Kick = TwoPointProblem.KickOf(_nextX);
                solution.Miss = contraction * _problem.Miss;
                solution.Status = AimStatus.Hit;
                return solution;
            }

            before = size;
            if (!FlyStep())
            {
                return solution;
            }

            flights++;
            bool stale = Norm(_nextR) > 0.9 * Norm(_r);
            _jacobian.Update(_step.Change, _r, _nextR);
            Array.Copy(_nextX, _x, N);
            Array.Copy(_nextR, _r, N);
            if (stale)
            {
                // Broyden's matrix no longer fits: read it off the flight again.
                _jacobian.ReadOff(_problem, _x);
            }

        }
    }

    /// <summary>Flies the kick after the step, or after a half, a quarter of it where that does not reach both planes.</summary>
    private bool FlyStep()
    {
        for (int half = 0; half < MostHalvings; half++)
        {
            TakeStep();
            _context.CountIteration();
            if (_problem.Fly(_nextX, _nextR))
            {
                return true;
            }

            for (int i = 0; i < N; i++)
            {
                _step.Change[i] *= 0.5;
            }
        }

        return false;
    }

    private void TakeStep()
    {
        for (int i = 0; i < N; i++)
        {
            _nextX[i] = _x[i] + _step.Change[i];
        }
    }

    private static double Norm(double[] r) => Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]) + (r[2] * r[2]) + (r[3] * r[3]));
}
