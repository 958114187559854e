namespace Football.Physics;

/// <summary>
/// The library's own solver for a point on the way and a target: Newton's method in four unknowns, start in closed form, first
/// corrections in fitted air, Broyden's updates, spins within their limits. Where it does not converge, the target comes first: it is hit with the spins that came nearest.
/// </summary>
internal sealed class DirectTwoPointAim
{
    private const int N = TwoPointProblem.Size;
    private const int MostIterations = 20;

    /// <summary>An iteration that leaves more than this share of the least misses so far is none that helps; so many in a row, and it leads nowhere.</summary>
    private const double Progress = 0.7;
    private const int MostStalled = 4;

    /// <summary>How often a step that does not reach both planes is halved.</summary>
    private const int MostHalvings = 4;

    /// <summary>Below this elevation, rad, a kick whose spin is at its limit is the only one.</summary>
    private const double FlatKick = 0.5;

    /// <summary>A spin of this share of its limit is at it.</summary>
    private const double NearLimit = 1.0 - 1e-9;

    /// <summary>Flights after which the next correction is foretold by the last: the first update of a Jacobian of four unknowns tells of one.</summary>
    private const int LeastFlights = 3;

    /// <summary>Corrections in fitted air, the miss below which there need be none more, m, and what each must leave of a miss at least and at most.</summary>
    private const int MostRehearsals = 6;
    private const double RehearsedEnough = 1e-4;
    private const double Plenty = 0.1;
    private const double LeastContraction = 0.05;
    private const double MostContraction = 1.5;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly GeneralAim _general;
    private readonly TwoPointProblem _problem;
    private readonly TwoPointJacobian _jacobian;
    private readonly TwoPointStep _step = new();
    private readonly double[] _x = new double[N];
    private readonly double[] _r = new double[N];
    private readonly double[] _guess = new double[N];
    private readonly double[] _nextX = new double[N];
    private readonly double[] _nextR = new double[N];

    public DirectTwoPointAim(AimContext context, DirectAim direct, GeneralAim general)
    {
        _general = general;
        _context = context;
        _direct = direct;
        _problem = new TwoPointProblem(context);
        _jacobian = new TwoPointJacobian();
    }

    public AimSolution Find(AimRequest request)
    {
        if (!_problem.Set(request))
        {
            AimSolution alone = _direct.Find(request);
            alone.ThroughMiss = double.NaN;
            return !_context.Scene.Air.IsStill && _general.Through(request, in alone.Kick, out AimSolution turned) ? turned : alone;
        }

        AimSolution solution = Solve(rehearses: !_context.Steps.AreShort);
        if (Suffices(in solution))
        {
            return solution;
        }

        // From elsewhere there may be one that the closed form is too far from.
        return _general.Through(request, in solution.Kick, out AimSolution other) ? other : solution.Status == AimStatus.Hit ? solution : TargetFirst(in solution);
    }

    private bool Suffices(in AimSolution solution) =>
        (Passes(in solution) && !_context.Steps.AreShort) || (solution.Status == AimStatus.Hit && IsOnlyOne(in solution.Kick));

    private bool Passes(in AimSolution solution) =>
        solution.Status == AimStatus.Hit && solution.ThroughMiss <= _problem.Request.ThroughTolerance;

    /// <summary>In still air, where the spin of a flat kick is at its limit, no other passes the point more closely.</summary>
    private bool IsOnlyOne(in Kick kick)
    {
        AimRequest request = _problem.Request;
        return kick.Elevation < FlatKick && _context.Scene.Air.IsStill && !_context.IsRuledByAir(request.Speed, kick.SpinRate)
            && (Math.Abs(kick.Top) >= request.MaximumTopSpin * NearLimit || Math.Abs(kick.Side) >= request.MaximumSideSpin * NearLimit);
    }

    /// <summary>The target alone, with the spins that came nearest to both, or else with as much lift as is allowed.</summary>
    private AimSolution TargetFirst(in AimSolution nearest)
    {
        AimRequest request = _problem.Request;
        AimSolution single = _direct.Find(request, request.Speed, request.Arc, nearest.Kick.Top, nearest.Kick.Side);
        single.ThroughMiss = ThroughMissOf(in single.Kick);
        if (single.Status != AimStatus.Hit)
        {
            AimSolution lifted = _direct.Find(request, request.Speed, request.Arc, -request.MaximumTopSpin, 0);
            if (lifted.Status == AimStatus.Hit || lifted.Miss < single.Miss)
            {
                lifted.ThroughMiss = ThroughMissOf(in lifted.Kick);
                return lifted;
            }
        }

        return single;
    }

    /// <summary>By what a kick for the target alone misses the point on the way, m: it is flown to tell.</summary>
    private double ThroughMissOf(in Kick kick)
    {
        _problem.Set(_problem.Request);
        _x[TwoPointProblem.Elevation] = kick.Elevation;
        _x[TwoPointProblem.Azimuth] = kick.Azimuth;
        _x[TwoPointProblem.Top] = kick.Top;
        _x[TwoPointProblem.Side] = kick.Side;
        return _problem.Fly(_x, _r, false) ? TwoPointProblem.ThroughMiss(_r) : double.NaN;
    }

    /// <summary>Newton's method.</summary>
    /// <param name="rehearses">Whether its first corrections are made in fitted air.</param>
    private AimSolution Solve(bool rehearses)
    {
        // 1. A guess in closed form, corrected in fitted air. 2. One real flight, to both planes. 3. Where it misses by more than the guess did, the Jacobian is made
        // anew. 4. Newton's steps, spins held at their limits, with Broyden's updates. 5. The last is not flown where it will miss by far less than the tolerance.
        // 6. Given up where steps do not help, or the kick leaves its bounds.
        bool isRehearsed = Rehearse(rehearses ? MostRehearsals : 0, out double rehearsed, out double contraction);
        var solution = new AimSolution
        {
            Status = AimStatus.NotConverged,
            Forward = _problem.Frame.Forward,
            Speed = _problem.Request.Speed,
            Kick = TwoPointProblem.KickOf(_x),
            ThroughMiss = double.NaN,
        };
        _context.CountIteration();
        if (!_problem.Fly(_x, _r, isRehearsed))
        {
            return solution;
        }

        // A rehearsal tells how much a correction leaves of a miss; where the flight misses by more than the guess did, it told nothing.
        bool isKnown = isRehearsed && Asked(_r) < rehearsed;
        if (!isKnown)
        {
            _step.Reset();
            if (!Differentiate())
            {
                return solution;
            }
        }

        int limit = Math.Min(_problem.Request.MaximumIterations, MostIterations);
        double before = isKnown ? Asked(_r) / contraction : double.PositiveInfinity;
        double least = double.PositiveInfinity;
        int stalled = 0;
        int flights = isKnown ? LeastFlights : 1;
        bool isSure = !isRehearsed;
        while (true)
        {
            double miss = TwoPointProblem.Miss(_r);
            solution.Kick = TwoPointProblem.KickOf(_x);
            solution.Miss = miss;
            solution.ThroughMiss = TwoPointProblem.ThroughMiss(_r);
            solution.Time = _problem.Time;
            if (isSure && miss <= _problem.Tolerance && _step.ThroughAsked(_r) <= _problem.ThroughTolerance)
            {
                solution.Status = _problem.StaysClear(_x) ? AimStatus.Hit : AimStatus.NotConverged;
                return solution;
            }

            if (_context.Iterations >= limit || !_step.Solve(_problem, _jacobian, _x, _r, out bool sameHeld))
            {
                return solution;
            }

            double size = Asked(_r);
            bool isPlenty = Convergence.IsPlenty(size, before, _problem.Tolerance, out double left) && !_context.Steps.AreShort;
            if (isPlenty && sameHeld && flights >= LeastFlights && _problem.StaysClear(_x))
            {
                TakeStep();
                solution.Kick = TwoPointProblem.KickOf(_nextX);
                solution.Miss = left * miss;
                solution.Status = AimStatus.Hit;
                return solution;
            }

            stalled = size < Progress * least ? 0 : stalled + 1;
            least = Math.Min(least, size);
            before = size;
            if (stalled == MostStalled || !FlyStep())
            {
                return solution;
            }

            flights++;
            isSure = true;

            // Where Broyden's matrix no longer fits, it is made anew.
            bool isStale = Norm(_nextR) > 0.9 * Norm(_r);
            TakeFlown();
            if (isStale && !Differentiate())
            {
                return solution;
            }
        }
    }

    /// <summary>The misses at the target and at the point on the way, m, but for the directions of spins that are held at their limit.</summary>
    private double Asked(double[] r)
    {
        double miss = TwoPointProblem.Miss(r);
        double asked = _step.ThroughAsked(r);
        return Math.Sqrt((miss * miss) + (asked * asked));
    }

    /// <summary>Makes the step that was flown the kick, and the Jacobian better by it.</summary>
    private void TakeFlown()
    {
        _jacobian.Update(_step.Change, _r, _nextR);
        Array.Copy(_nextX, _x, N);
        Array.Copy(_nextR, _r, N);
    }

    /// <summary>Makes the Jacobian anew.</summary>
    private bool Differentiate() => _problem.Rehearse(_x, _nextR) && _jacobian.Rehearse(_problem, _x, _nextR);

    /// <summary>Guesses a kick, and corrects it in fitted air.</summary>
    /// <param name="most">Corrections at most.</param>
    /// <param name="first">What the guess misses by, m.</param>
    /// <param name="contraction">What a correction leaves of a miss.</param>
    /// <returns>False where nothing is learnt: the kick is the guess then.</returns>
    private bool Rehearse(int most, out double first, out double contraction)
    {
        // Corrections in fitted air cost a quarter of a flight: as many as shrink the miss, until it is below what that air itself is off.
        double drag = TwoPointGuess.Make(_context, _problem, _x, out double throughTime, out double targetTime);
        _problem.Prepare(drag, throughTime, targetTime);
        _step.Reset();
        contraction = 1;
        first = 0;
        if (most == 0 || !_problem.Rehearse(_x, _r) || !_jacobian.Rehearse(_problem, _x, _r))
        {
            return false;
        }

        Array.Copy(_x, _guess, N);
        first = Asked(_r);
        double size = first;
        for (int i = 0; i <= most; i++)
        {
            if (!_step.Solve(_problem, _jacobian, _x, _r, out _))
            {
                break;
            }

            TakeStep();
            if (i == most || (size * contraction < RehearsedEnough && contraction < Plenty))
            {
                Array.Copy(_nextX, _x, N);
                return true;
            }

            if (!_problem.Rehearse(_nextX, _nextR))
            {
                break;
            }

            TakeFlown();
            double next = Asked(_r);
            contraction = Math.Max(next / size, LeastContraction);
            if (!(contraction < MostContraction))
            {
                break;
            }

            size = next;
        }

        Array.Copy(_guess, _x, N);
        return false;
    }

    /// <summary>Flies the kick after the step, or after a half, a quarter of it where that does not reach both planes.</summary>
    private bool FlyStep()
    {
        for (int half = 0; half < MostHalvings; half++)
        {
            TakeStep();
            _context.CountIteration();
            if (_problem.Fly(_nextX, _nextR, false))
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
