namespace FootballPhysics.Aiming;

/// <summary>
/// Newton's method on the crossings of a <see cref="PlaneProblem"/>. It starts in closed form; the first corrections are rehearsed in fitted air; the first Jacobian is read
/// off the flight itself, and Broyden's updates make it better, so that an iteration costs one flight and no differences.
/// </summary>
internal sealed class PlaneNewton
{
    private const int N = PlaneProblem.Most;

    /// <summary>An iteration that leaves more than this share of the least misses so far is none that helps.</summary>
    private const double Progress = 0.7;

    /// <summary>Flights after which the next correction is foretold by the last: the first update of a Jacobian of four unknowns tells of one.</summary>
    private const int LeastFlights = 3;

    /// <summary>The miss below which no more corrections need be rehearsed, m, and what each must leave of a miss to count as plenty.</summary>
    private const double RehearsedEnough = 1e-4;
    private const double Plenty = 0.1;

    private readonly PlaneProblem _problem;
    private readonly PlaneStep _step = new();
    private readonly double[] _guess = new double[N];
    private readonly double[] _nextX = new double[N];
    private readonly double[] _nextR = new double[N];
    private NewtonPatience _patience;

    public PlaneNewton(PlaneProblem problem) => _problem = problem;

    /// <summary>The unknowns of the kick.</summary>
    public double[] X { get; } = new double[N];

    /// <summary>Its residuals.</summary>
    public double[] R { get; } = new double[N];

    /// <summary>Miss distances at the target and at the point on the way, m.</summary>
    public double Miss { get; private set; }

    public double ThroughMiss { get; private set; }

    /// <summary>When it is at the target, s.</summary>
    public double Time { get; private set; }

    /// <summary>Solves the problem.</summary>
    /// <returns>False where it does not converge, or leaves the bounds; the kick is then the last that was flown.</returns>
    public bool Solve()
    {
        // 1. A guess in closed form, corrected in fitted air, which also tells how much a correction leaves of a miss. 2. One real flight. 3. Where it misses by more than
        // the guess did, the Jacobian is made anew. 4. A correction by what it missed; it is not flown where it will miss by far less than the tolerance: one flight an
        // aim. 5. Else Broyden's update, and the next flight, as long as misses shrink.
        Miss = 0;
        ThroughMiss = double.NaN;
        Time = 0;
        bool through = _problem.HasThrough;
        _patience = through ? NewtonPatience.Through : NewtonPatience.Target;
        if (!_problem.Guess(X))
        {
            return false;
        }

        // What longer steps were wrong about grazes the drag law's jump: there only a kick's own flight tells.
        double rehearsed = 0;
        double contraction = 1;
        _step.Reset();
        bool isRehearsed = !_problem.IsFine && Rehearse(out rehearsed, out contraction);
        if (!_problem.Fly(X, R, isRehearsed))
        {
            return false;
        }

        // A rehearsal tells how much a correction leaves of a miss; where the flight misses by more than the guess did, it told nothing.
        bool isKnown = isRehearsed && Asked(R) < rehearsed;
        if (!isKnown)
        {
            _step.Reset();
            if (!Differentiate())
            {
                return false;
            }
        }

        double before = isKnown ? Asked(R) / contraction : double.PositiveInfinity;
        double least = double.PositiveInfinity;
        int limit = Math.Min(_problem.Request.MaximumIterations, _patience.Flights);
        int stalled = 0;
        bool isSure = !isRehearsed;
        for (int flights = 1; ; flights++)
        {
            Miss = PlaneProblem.MissOf(R);
            ThroughMiss = PlaneProblem.ThroughMissOf(R);
            Time = _problem.Time;

            // A flight in the long steps of a rehearsed kick only foretells; to hit, it is flown in shorter ones.
            bool hits = isSure && Miss <= _problem.Tolerance && !(through && _step.ThroughAsked(R) > _problem.ThroughTolerance);
            if ((hits && through) || !_step.Solve(_problem, X, R, out bool sameHeld))
            {
                return hits;
            }

            double size = Asked(R);
            bool isForetold = sameHeld && (isKnown || !through || flights >= LeastFlights);
            if (Convergence.IsPlenty(size, before, _problem.Tolerance, out double left) && isForetold && !_problem.IsFine)
            {
                TakeStep();
                Array.Copy(_nextX, X, N);

                // Estimated, not flown: what the correction leaves by the measure of the one before.
                Miss *= left;
                R[PlaneProblem.TargetUp] *= left;
                return true;
            }

            // Slow in a row, or as often as is allowed: given up.
            stalled = size < Progress * least ? 0 : stalled + 1;
            if (hits || flights >= limit || stalled == _patience.Stalled)
            {
                return hits;
            }

            least = Math.Min(least, size);
            before = size;
            if (!FlyStep())
            {
                return false;
            }

            // Where Broyden's matrix no longer fits, it is made anew.
            isSure = true;
            bool isStale = Norm(_nextR) > 0.9 * Norm(R);
            TakeFlown();
            if (isStale && !Differentiate())
            {
                return false;
            }
        }
    }

    /// <summary>Corrects the guess in fitted air.</summary>
    /// <param name="first">What the guess misses by, m.</param>
    /// <param name="contraction">What a correction leaves of a miss.</param>
    /// <returns>False where nothing is learnt: the kick is the guess then.</returns>
    private bool Rehearse(out double first, out double contraction)
    {
        // Corrections in fitted air cost a quarter of a flight: as many as shrink the miss, until it is below what that air itself is off.
        int most = _patience.Rehearsals;
        contraction = 1;
        first = 0;
        Array.Copy(X, _guess, N);
        if (!_problem.Rehearse(X, R) || !_step.Measure(_problem, X, R))
        {
            _problem.ForgetRehearsals();
            return false;
        }

        first = Asked(R);
        double size = first;
        for (int i = 0; i <= most && _step.Solve(_problem, X, R, out _); i++)
        {
            TakeStep();
            if (i == most || (size * contraction < RehearsedEnough && contraction < Plenty))
            {
                Array.Copy(_nextX, X, N);
                return true;
            }

            if (!_problem.Rehearse(_nextX, _nextR))
            {
                break;
            }

            TakeFlown();
            double next = Asked(R);

            // Bounded below, for one lucky correction says little of the next.
            contraction = Math.Max(next / size, _patience.LeastContraction);
            if (!(contraction < _patience.MostContraction))
            {
                break;
            }

            size = next;
        }

        // Nothing was learnt: back to the guess.
        Array.Copy(_guess, X, N);
        _problem.ForgetRehearsals();
        return false;
    }

    /// <summary>The misses at the target and at the point on the way, m, but for the directions of spins that are held at their limit.</summary>
    private double Asked(double[] r)
    {
        double miss = PlaneProblem.MissOf(r);
        double asked = _problem.HasThrough ? _step.ThroughAsked(r) : 0;
        return asked > 0 ? Math.Sqrt((miss * miss) + (asked * asked)) : miss;
    }

    /// <summary>Makes the step that was flown the kick, and the Jacobian better by it.</summary>
    private void TakeFlown()
    {
        _step.Update(_problem, R, _nextR);
        Array.Copy(_nextX, X, N);
        Array.Copy(_nextR, R, N);
    }

    /// <summary>Makes the Jacobian anew.</summary>
    private bool Differentiate() => (!_problem.HasThrough || _problem.Rehearse(X, _nextR)) && _step.Measure(_problem, X, _nextR);

    /// <summary>Flies the kick after the step, or after a half, a quarter of it where that does not reach its planes.</summary>
    private bool FlyStep()
    {
        for (int i = 0; i < _patience.Tries; i++)
        {
            TakeStep();
            if (_problem.Fly(_nextX, _nextR, false))
            {
                return true;
            }

            for (int k = 0; k < N; k++)
            {
                _step.Change[k] *= 0.5;
            }
        }

        return false;
    }

    private void TakeStep()
    {
        for (int i = 0; i < N; i++)
        {
            _nextX[i] = X[i] + _step.Change[i];
        }
    }

    private static double Norm(double[] r) => Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]) + (r[2] * r[2]) + (r[3] * r[3]));
}

/// <summary>How long Newton's method goes on: the angles to a target alone are found at once or not at all, angles and spins through a point take their time.</summary>
/// <param name="Flights">Flights at most.</param>
/// <param name="Stalled">So many iterations in a row that do not help, and it leads nowhere.</param>
/// <param name="Tries">How often a step that does not reach its planes is tried, shorter by half each time.</param>
/// <param name="Rehearsals">Corrections in fitted air.</param>
/// <param name="LeastContraction">A rehearsed correction leaves a share of the miss: no less than this is relied on.</param>
/// <param name="MostContraction">With more than that nothing is learnt.</param>
internal readonly record struct NewtonPatience(int Flights, int Stalled, int Tries, int Rehearsals, double LeastContraction, double MostContraction)
{
    public static NewtonPatience Target => new(Flights: 10, Stalled: 1, Tries: 1, Rehearsals: 1, LeastContraction: 0.03, MostContraction: 0.2);

    public static NewtonPatience Through => new(Flights: 20, Stalled: 4, Tries: 4, Rehearsals: 6, LeastContraction: 0.05, MostContraction: 1.5);
}

/// <summary>When a quasi-Newton iteration need not fly its last kick.</summary>
internal static class Convergence
{
    /// <summary>
    /// The last correction shrank the miss by a factor, and the next one will by no less. Where that is plenty, the corrected kick needs no
    /// flight to show that it hits.
    /// </summary>
    /// <param name="miss">The miss now, m.</param>
    /// <param name="before">The miss before the last correction, m; infinite before there was one.</param>
    /// <param name="tolerance">The tolerance, m.</param>
    /// <param name="contraction">The factor.</param>
    public static bool IsPlenty(double miss, double before, double tolerance, out double contraction)
    {
        contraction = miss / before;
        return contraction > 0 && contraction < 0.1 && contraction * miss < 0.1 * tolerance;
    }
}
