namespace Football.Physics;

/// <summary>
/// Newton's method on the crossing of the target's plane, for elevation and azimuth. It starts in closed form; the first correction is
/// rehearsed in fitted air; the first Jacobian is read off the flight itself, and Broyden's updates make it better, so that an iteration costs
/// one flight and no differences.
/// </summary>
internal static class BroydenShooting
{
    private const int MostIterations = 10;

    /// <summary>An iteration must shrink the miss to this share of it.</summary>
    private const double Progress = 0.7;

    /// <summary>Largest corrections of elevation and azimuth, rad: what asks for more is far from the model.</summary>
    private const double LargestElevation = 0.35;
    private const double LargestAzimuth = 0.5;

    /// <summary>A rehearsed correction leaves a share of the miss: no less than this is relied on, and with more than that nothing is learnt.</summary>
    private const double LeastContraction = 0.03;
    private const double MostContraction = 0.2;

    /// <summary>Solves a problem.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="solution">The kick, and how it crosses the target's plane.</param>
    /// <returns>False where it does not converge, or leaves the bounds.</returns>
    public static bool Solve(PlaneProblem problem, out PlaneShot solution)
    {
        solution = default;
        if (!problem.Guess(out Kick first, out double time))
        {
            return false;
        }

        // What longer steps were wrong about grazes the drag law's jump: there only a kick's own flight tells.
        CrossingJacobian jacobian = default;
        double contraction = 1;
        double rehearsed = problem.IsFine ? 0 : Rehearse(problem, ref first, ref time, out jacobian, out contraction);
        solution = problem.Fly(in first, time, rehearsed > 0);
        if (!solution.Crossed)
        {
            return false;
        }

        // A rehearsal tells how much a correction leaves of a miss; where the flight misses by more than the guess did, it told nothing.
        bool known = solution.Miss < rehearsed;
        jacobian = known ? jacobian : problem.Jacobian(in solution);
        double before = known ? solution.Miss / contraction : double.PositiveInfinity;
        int limit = Math.Min(problem.Request.MaximumIterations, MostIterations);
        bool isSure = !(rehearsed > 0);
        while (true)
        {
            bool hits = isSure && solution.Miss <= problem.Tolerance;
            if (!Correct(problem, in jacobian, in solution, out Kick next, out double elevation, out double azimuth))
            {
                return hits;
            }

            if (Convergence.IsPlenty(solution.Miss, before, problem.Tolerance, out double left) && !problem.IsFine)
            {
                solution.Kick = next;
                solution.Miss *= left;
                solution.Up *= left;
                solution.Left *= left;
                return true;
            }

            if (hits || problem.Shots >= limit || solution.Miss > Progress * before)
            {
                return hits;
            }

            before = solution.Miss;
            PlaneShot shot = problem.Fly(in next, solution.Time, false);
            if (!shot.Crossed)
            {
                return false;
            }

            isSure = true;
            jacobian.Update(elevation, azimuth, shot.Up - solution.Up, shot.Left - solution.Left);
            solution = shot;
        }
    }

    /// <summary>The first correction, in the fitted air.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="kick">The guess; the corrected kick.</param>
    /// <param name="time">About when the guess is there, s; about when the corrected kick is.</param>
    /// <param name="jacobian">How the crossing moves.</param>
    /// <param name="contraction">What a correction leaves of a miss.</param>
    /// <returns>What the guess misses by, m; 0 where there is nothing to learn from it.</returns>
    private static double Rehearse(PlaneProblem problem, ref Kick kick, ref double time, out CrossingJacobian jacobian, out double contraction)
    {
        jacobian = default;
        contraction = 1;
        problem.Fit(in kick, time);
        PlaneShot first = problem.Rehearse(in kick, time);
        if (!first.Crossed)
        {
            return 0;
        }

        jacobian = problem.Jacobian(in first);
        if (!Correct(problem, in jacobian, in first, out Kick next, out double elevation, out double azimuth))
        {
            return 0;
        }

        PlaneShot second = problem.Rehearse(in next, first.Time);
        contraction = Math.Max(second.Miss / first.Miss, LeastContraction);
        jacobian.Update(elevation, azimuth, second.Up - first.Up, second.Left - first.Left);
        if (!second.Crossed || !(contraction < MostContraction) || !Correct(problem, in jacobian, in second, out next, out _, out _))
        {
            return 0;
        }

        kick = next;
        time = second.Time;
        return first.Miss;
    }

    /// <summary>A corrected kick.</summary>
    /// <returns>False where the correction is too long, or leaves the bounds.</returns>
    private static bool Correct(
        PlaneProblem problem, in CrossingJacobian jacobian, in PlaneShot shot, out Kick next, out double elevation, out double azimuth)
    {
        next = shot.Kick;
        if (!jacobian.Solve(shot.Up, shot.Left, out elevation, out azimuth))
        {
            return false;
        }

        next.Elevation += elevation;
        next.Azimuth += azimuth;
        return Math.Abs(elevation) < LargestElevation && Math.Abs(azimuth) < LargestAzimuth && problem.Bounds.Contain(next.Elevation);
    }
}
