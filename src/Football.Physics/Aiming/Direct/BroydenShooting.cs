namespace Football.Physics;

/// <summary>
/// Newton's method on the crossing of the target's plane, for elevation and azimuth. It starts in closed form; the first Jacobian is read off
/// the flight itself, and Broyden's updates make it better, so that an iteration costs one flight and no differences.
/// </summary>
internal static class BroydenShooting
{
    private const int MostIterations = 10;

    /// <summary>An iteration must shrink the miss to this share of it.</summary>
    private const double Progress = 0.7;

    /// <summary>Largest corrections of elevation and azimuth, rad: what asks for more is far from the model.</summary>
    private const double LargestElevation = 0.35;
    private const double LargestAzimuth = 0.5;

    /// <summary>Solves a problem.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="solution">The kick, and how it crosses the target's plane.</param>
    /// <returns>False where it does not converge, or leaves the bounds.</returns>
    public static bool Solve(PlaneProblem problem, out PlaneShot solution)
    {
        solution = default;
        if (!problem.Guess(out Kick first))
        {
            return false;
        }

        solution = problem.Fly(in first);
        if (!solution.Crossed)
        {
            return false;
        }

        CrossingJacobian jacobian = problem.Jacobian(in solution);
        double before = double.PositiveInfinity;
        int limit = Math.Min(problem.Request.MaximumIterations, MostIterations);
        while (solution.Miss > problem.Tolerance)
        {
            if (problem.Shots >= limit
                || !jacobian.Solve(solution.Up, solution.Left, out double elevation, out double azimuth)
                || solution.Miss > Progress * before)
            {
                return false;
            }

            Kick next = solution.Kick;
            next.Elevation += elevation;
            next.Azimuth += azimuth;
            if (!(Math.Abs(elevation) < LargestElevation && Math.Abs(azimuth) < LargestAzimuth) || !problem.Bounds.Contain(next.Elevation))
            {
                return false;
            }

            if (Convergence.IsPlenty(solution.Miss, before, problem.Tolerance, out double contraction))
            {
                solution.Kick = next;
                solution.Miss *= contraction;
                return true;
            }

            before = solution.Miss;
            PlaneShot shot = problem.Fly(in next);
            if (!shot.Crossed)
            {
                return false;
            }

            jacobian.Update(elevation, azimuth, shot.Up - solution.Up, shot.Left - solution.Left);
            solution = shot;
        }

        return true;
    }
}
