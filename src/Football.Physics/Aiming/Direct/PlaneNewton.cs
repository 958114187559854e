namespace FootballPhysics.Aiming;

/// <summary>Newton's method on the plane crossings of a <see cref="PlaneProblem"/>.</summary>
/// <remarks>
/// It starts from the closed form, and rehearses the first corrections in fitted air. The first Jacobian is computed from the flight itself, and
/// Broyden's updates improve it. An iteration therefore costs one flight, and needs no difference quotients.
/// </remarks>
internal sealed class PlaneNewton(PlaneProblem problem)
{
    private const int N = PlaneProblem.Most;

    /// <summary>An iteration counts as stalled if its miss exceeds this multiple of the smallest miss so far.</summary>
    private const double Progress = 0.7;

    /// <summary>The number of flights after which one correction predicts the next; with four unknowns, one update is not enough.</summary>
    private const int LeastFlights = 3;

    /// <summary>The miss at which rehearsals end, in m, and the contraction per correction that is sufficient.</summary>
    private const double RehearsedEnough = 1e-4;
    private const double Plenty = 0.1;

    private readonly PlaneProblem _problem = problem;
    private readonly PlaneStep _step = new();
    private readonly double[] _guess = new double[N];
    private readonly double[] _nextX = new double[N];
    private readonly double[] _nextR = new double[N];
    private NewtonPatience _patience;

    /// <summary>The unknowns of the kick.</summary>
    public double[] X { get; } = new double[N];

    /// <summary>The residuals of the kick.</summary>
    public double[] R { get; } = new double[N];

    /// <summary>The misses at the target and at the waypoint, in m.</summary>
    public double Miss { get; private set; }

    public double ThroughMiss { get; private set; }

    /// <summary>The time at the target, in s.</summary>
    public double Time { get; private set; }

    /// <summary>Solves the problem.</summary>
    /// <returns>False if it does not converge, or leaves the bounds; the kick is then the last one simulated.</returns>
    public bool Solve()
    {
        // 1. Correct a closed-form guess in fitted air, which also measures the contraction per correction. 2. Simulate one full flight. 3. If it
        // misses by more than the guess did, rebuild the Jacobian. 4. Correct by the miss; skip the final flight if the predicted miss is far below
        // the tolerance. 5. Otherwise, apply Broyden's update and simulate again, while the misses shrink.
        bool through = _problem.HasThrough;
        if (!Begin(out bool isRehearsed, out bool isKnown, out double before))
        {
            return false;
        }

        double least = double.PositiveInfinity;
        int limit = Math.Min(_problem.Request.MaximumIterations, _patience.Flights);
        int stalled = 0;
        bool isSure = !isRehearsed;
        for (int flights = 1; ; flights++)
        {
            Miss = PlaneProblem.MissOf(R);
            ThroughMiss = PlaneProblem.ThroughMissOf(R);
            Time = _problem.Time;

            // A rehearsed flight with long steps only predicts a hit: confirm the hit with shorter steps.
            bool hits = isSure && Miss <= _problem.Tolerance && !(through && _step.ThroughError(R) > _problem.ThroughTolerance);
            if ((hits && through) || !_step.Solve(_problem, X, R, out bool sameHeld))
            {
                return hits;
            }

            double size = ErrorOf(R);
            bool isForetold = sameHeld && (isKnown || !through || flights >= LeastFlights);
            if (Convergence.IsPlenty(size, before, _problem.Tolerance, out double left) && isForetold && !_problem.IsFine)
            {
                TakeStep();
                Array.Copy(_nextX, X, N);

                // Estimate the remaining miss from the last contraction, without another flight.
                Miss *= left;
                R[PlaneProblem.TargetUp] *= left;
                return true;
            }

            // Give up after too many flights, or too many slow iterations in a row.
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

            // Rebuild the Broyden matrix when it no longer fits.
            isSure = true;
            bool isStale = Norm(_nextR) > 0.9 * Norm(R);
            TakeFlown();
            if (isStale && !Differentiate())
            {
                return false;
            }
        }
    }

    /// <summary>Rehearses the closed-form guess, and simulates the first flight.</summary>
    /// <param name="isRehearsed">True if the rehearsal succeeded.</param>
    /// <param name="isKnown">True if the Jacobian and the contraction of the rehearsal are valid for the flight.</param>
    /// <param name="before">The miss before the flight, in m; infinite if it is not known.</param>
    /// <returns>False if there is no guess, or its flight fails.</returns>
    private bool Begin(out bool isRehearsed, out bool isKnown, out double before)
    {
        Miss = 0;
        ThroughMiss = double.NaN;
        Time = 0;
        isRehearsed = false;
        isKnown = false;
        before = double.PositiveInfinity;
        _patience = _problem.HasThrough ? NewtonPatience.Through : NewtonPatience.Target;
        if (!_problem.Guess(X))
        {
            return false;
        }

        // Longer steps have proved inaccurate, so the kick grazes the jump in the drag law: use full flights only.
        double rehearsed = 0;
        double contraction = 1;
        _step.Reset();
        isRehearsed = !_problem.IsFine && Rehearse(out rehearsed, out contraction);
        if (!_problem.Fly(X, R, isRehearsed))
        {
            return false;
        }

        // Trust the contraction of the rehearsal only if the flight misses by less than the guess did.
        isKnown = isRehearsed && ErrorOf(R) < rehearsed;
        if (isKnown)
        {
            before = ErrorOf(R) / contraction;
            return true;
        }

        _step.Reset();
        return Differentiate();
    }

    /// <summary>Corrects the guess in fitted air.</summary>
    /// <param name="first">The miss of the guess, in m.</param>
    /// <param name="contraction">The share of a miss that a correction leaves.</param>
    /// <returns>False if the rehearsal failed or barely converged; the kick is then the guess.</returns>
    private bool Rehearse(out double first, out double contraction)
    {
        // A correction in fitted air costs a quarter of a flight: repeat it while the miss shrinks, down to the error of the fit.
        int most = _patience.Rehearsals;
        contraction = 1;
        first = 0;
        Array.Copy(X, _guess, N);
        if (!_problem.Rehearse(X, R) || !_step.Measure(_problem, X, R))
        {
            _problem.ForgetRehearsals();
            return false;
        }

        first = ErrorOf(R);
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
            double next = ErrorOf(R);

            // Apply a lower bound, because one lucky correction does not predict the next one.
            contraction = Math.Max(next / size, _patience.LeastContraction);
            if (!(contraction < _patience.MostContraction))
            {
                break;
            }

            size = next;
        }

        // The rehearsal did not help: return to the guess.
        Array.Copy(_guess, X, N);
        _problem.ForgetRehearsals();
        return false;
    }

    /// <summary>Returns the combined miss at target and waypoint, in m. It ignores the directions whose spin is at its limit.</summary>
    private double ErrorOf(double[] r)
    {
        double miss = PlaneProblem.MissOf(r);
        double through = _problem.HasThrough ? _step.ThroughError(r) : 0;
        return through > 0 ? Math.Sqrt((miss * miss) + (through * through)) : miss;
    }

    /// <summary>Accepts the step that was simulated, and updates the Jacobian.</summary>
    private void TakeFlown()
    {
        _step.Update(_problem, R, _nextR);
        Array.Copy(_nextX, X, N);
        Array.Copy(_nextR, R, N);
    }

    /// <summary>Rebuilds the Jacobian.</summary>
    private bool Differentiate() => (!_problem.HasThrough || _problem.Rehearse(X, _nextR)) && _step.Measure(_problem, X, _nextR);

    /// <summary>Simulates the kick after the step; halves the step repeatedly if the kick does not reach its planes.</summary>
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

/// <summary>The limits of Newton's method: a kick to a target converges at once or never; a kick with a waypoint takes longer.</summary>
/// <param name="Flights">The maximum number of flights.</param>
/// <param name="Stalled">The number of stalled iterations in a row after which it gives up.</param>
/// <param name="Tries">The number of times that a step which does not reach its planes is halved.</param>
/// <param name="Rehearsals">The maximum number of corrections in fitted air.</param>
/// <param name="LeastContraction">The lower bound applied to the contraction of a rehearsed correction.</param>
/// <param name="MostContraction">The contraction above which a rehearsal is discarded.</param>
internal readonly record struct NewtonPatience(int Flights, int Stalled, int Tries, int Rehearsals, double LeastContraction, double MostContraction)
{
    public static NewtonPatience Target => new(Flights: 10, Stalled: 1, Tries: 1, Rehearsals: 1, LeastContraction: 0.03, MostContraction: 0.2);

    public static NewtonPatience Through => new(Flights: 20, Stalled: 4, Tries: 4, Rehearsals: 6, LeastContraction: 0.05, MostContraction: 1.5);
}

/// <summary>Decides if a quasi-Newton iteration can skip its last flight.</summary>
internal static class Convergence
{
    /// <summary>True if the corrected kick certainly hits, so that its flight can be skipped.</summary>
    /// <remarks>The last correction shrank the miss by a factor; assume that the next correction shrinks it at least as much.</remarks>
    /// <param name="miss">The current miss, in m.</param>
    /// <param name="before">The miss before the last correction, in m; infinite before the first.</param>
    /// <param name="tolerance">The tolerance, in m.</param>
    /// <param name="contraction">The factor.</param>
    public static bool IsPlenty(double miss, double before, double tolerance, out double contraction)
    {
        contraction = miss / before;
        return contraction > 0 && contraction < 0.1 && contraction * miss < 0.1 * tolerance;
    }
}
