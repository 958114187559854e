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
    /// <returns>False where it does not converge, or leaves the bounds.</returns>
    public static bool Solve(PlaneProblem problem, out PlaneShot solution)
    {
        // A guess in closed form; one correction rehearsed in fitted air, which also tells how much a correction leaves of a miss; one real flight;
        // a correction by what it missed. Where the next would miss by far less than the tolerance, it is not flown: one flight an aim. Else
        // Broyden's update, and the next flight, as long as misses shrink.
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

/// <summary>How the crossing of the target's plane (up, left) moves with elevation and azimuth, m/rad.</summary>
internal struct CrossingJacobian
{
    private double _upByElevation;
    private double _upByAzimuth;
    private double _leftByElevation;
    private double _leftByAzimuth;

    public CrossingJacobian(double upByElevation, double upByAzimuth, double leftByElevation, double leftByAzimuth)
    {
        _upByElevation = upByElevation;
        _upByAzimuth = upByAzimuth;
        _leftByElevation = leftByElevation;
        _leftByAzimuth = leftByAzimuth;
    }

    /// <summary>How the height of the crossing moves with the elevation, m/rad.</summary>
    public readonly double UpByElevation => _upByElevation;

    /// <summary>How it moves with the azimuth.</summary>
    public readonly double UpByAzimuth => _upByAzimuth;

    /// <summary>How the distance to the left moves with the elevation.</summary>
    public readonly double LeftByElevation => _leftByElevation;

    /// <summary>How it moves with the azimuth.</summary>
    public readonly double LeftByAzimuth => _leftByAzimuth;

    /// <summary>
    /// Read off one flight: drag and Magnus force turn with the kick, so the whole way turns with it, but for the displacements by
    /// gravity and wind; then back along the velocity to the plane.
    /// </summary>
    /// <param name="kick">The kick.</param>
    /// <param name="crossing">Where it crossed the plane.</param>
    /// <param name="frame">The frame of the target.</param>
    /// <param name="wind">Wind, m/s.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    public static CrossingJacobian Of(in Kick kick, in PlaneCrossing crossing, in TargetFrame frame, in Vector3d wind, double upward)
    {
        Vector3d p = crossing.Position - frame.From;
        Vector3d d = kick.Direction(in frame.Forward);

        // Damped by drag: the mean speed over the launch speed is about the damping of both displacements.
        double t = crossing.Time;
        double damping = 0.9;
        Vector3d byGravity = new(0, 0.5 * damping * upward * t * t, 0);
        Vector3d turning = p - byGravity - (0.3 * t * wind);
        Vector3d byElevation = Vector3d.Cross(new Vector3d(-d.Z, 0, d.X), in turning); // axis d × ŷ raises the kick
        Vector3d byAzimuth = Vector3d.Cross(Vector3d.Up, in turning);
        Elementary.SinCos(kick.Elevation, out double sine, out double cosine);
        if (kick.Side != 0 && cosine > 0.1)
        {
            // The axis of the side spin stays upright: its bend is that of the horizontal velocity alone, which a raised kick has less of.
            Vector3d across = new(d.Z, 0, -d.X); // ŷ × d
            byElevation -= sine / cosine * Vector3d.Dot(in turning, in across) * across;
        }

        double speed = Vector3d.Dot(crossing.Velocity, in frame.Forward);
        Vector3d slope = speed > 1e-3 ? crossing.Velocity / speed : frame.Forward;
        byElevation -= Vector3d.Dot(in byElevation, in frame.Forward) * slope;
        byAzimuth -= Vector3d.Dot(in byAzimuth, in frame.Forward) * slope;
        return new CrossingJacobian(
            byElevation.Y, byAzimuth.Y, Vector3d.Dot(in byElevation, in frame.Left), Vector3d.Dot(in byAzimuth, in frame.Left));
    }

    /// <summary>The changes of elevation and azimuth that bring a crossing to the target.</summary>
    /// <param name="up">How high above the target it is, m.</param>
    /// <param name="left">How far to its left, m.</param>
    /// <param name="elevation">Change of the elevation, rad.</param>
    /// <param name="azimuth">Change of the azimuth, rad.</param>
    /// <returns>False where the Jacobian is singular.</returns>
    public readonly bool Solve(double up, double left, out double elevation, out double azimuth)
    {
        double determinant = (_upByElevation * _leftByAzimuth) - (_upByAzimuth * _leftByElevation);
        elevation = ((_upByAzimuth * left) - (_leftByAzimuth * up)) / determinant;
        azimuth = ((_leftByElevation * up) - (_upByElevation * left)) / determinant;
        return double.IsFinite(elevation) && double.IsFinite(azimuth);
    }

    /// <summary>Broyden's update after a change of the angles moved the crossing: J += (Δr − J Δx) Δxᵀ / |Δx|².</summary>
    public void Update(double elevation, double azimuth, double up, double left)
    {
        double squared = (elevation * elevation) + (azimuth * azimuth);
        if (!(squared > 0))
        {
            return;
        }

        double moreUp = (up - (_upByElevation * elevation) - (_upByAzimuth * azimuth)) / squared;
        double moreLeft = (left - (_leftByElevation * elevation) - (_leftByAzimuth * azimuth)) / squared;
        _upByElevation += moreUp * elevation;
        _upByAzimuth += moreUp * azimuth;
        _leftByElevation += moreLeft * elevation;
        _leftByAzimuth += moreLeft * azimuth;
    }
}
