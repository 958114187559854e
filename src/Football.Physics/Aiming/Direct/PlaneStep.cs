using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A Newton step of a <see cref="PlaneProblem"/>, and the Jacobian of its residuals.</summary>
/// <remarks>
/// With a waypoint it uses the active-set method: a spin that would exceed its limit is held at the limit, and its equation at the waypoint is
/// dropped. The kick then misses the waypoint in that direction by as little as the limit allows.
/// </remarks>
internal sealed class PlaneStep
{
    private const int N = PlaneProblem.Most;

    /// <summary>The largest corrections of elevation and azimuth, in rad; the linear model does not hold beyond. With a waypoint, both have the same
    /// limit.</summary>
    private const double LargestElevation = 0.35;
    private const double LargestAzimuth = 0.5;
    private const double LargestTurn = 1.0;

    /// <summary>The change of spin that measures its effect, in rad/s; large enough to exceed the error of a rehearsal.</summary>
    private const double SpinChange = 0.5;

    /// <summary>The squared angle, in rad², that weighs as much as 1 rad/s of spin.</summary>
    private const double SpinUnit = 1e-4;

    private readonly double[] _weight = [1, 1, SpinUnit, SpinUnit];
    private readonly double[] _j = new double[N * N];
    private readonly double[] _changed = new double[N];
    private readonly double[] _system = new double[N * (N + 1)];
    private readonly double[] _limit = new double[N];
    private readonly bool[] _held = new bool[N];

    /// <summary>The Jacobian for a target only.</summary>
    private CrossingJacobian _angles;

    /// <summary>The changes of the unknowns.</summary>
    public double[] Change { get; } = new double[N];

    /// <summary>Releases the spins that were held.</summary>
    public void Reset()
    {
        Array.Clear(_held, 0, N);
        Array.Clear(Change, 0, N);
    }

    /// <summary>Returns the miss at the waypoint, in m. It ignores the directions whose spin is at its limit.</summary>
    public double ThroughError(double[] r)
    {
        double left = _held[PlaneProblem.Side] ? 0 : r[PlaneProblem.ThroughLeft];
        double up = _held[PlaneProblem.Top] ? 0 : r[PlaneProblem.ThroughUp];
        return Math.Sqrt((left * left) + (up * up));
    }

    /// <summary>Computes the Jacobian: the angles from the last flight, the spins by differences in fitted air.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="x">The unknowns of the last kick.</param>
    /// <param name="r">The residuals of the last kick.</param>
    /// <returns>False if a kick with slightly more spin does not reach both planes.</returns>
    public bool Measure(PlaneProblem problem, double[] x, double[] r)
    {
        // The angles rotate the entire path, so the flight itself yields their columns. Each spin needs another flight, with slightly more of that spin.
        _angles = problem.JacobianAtTarget(x);
        if (!problem.HasThrough)
        {
            return true;
        }

        Set(PlaneProblem.ThroughLeft, PlaneProblem.ThroughUp, problem.JacobianAtThrough(x));
        Set(PlaneProblem.TargetLeft, PlaneProblem.TargetUp, in _angles);
        for (int k = PlaneProblem.Top; k <= PlaneProblem.Side; k++)
        {
            // Compute forward differences, from flights with the fitted air model.
            double kept = x[k];
            x[k] = kept + SpinChange;
            bool reaches = problem.Rehearse(x, _changed);
            x[k] = kept;
            if (!reaches)
            {
                return false;
            }

            for (int i = 0; i < N; i++)
            {
                _j[(i * N) + k] = (_changed[i] - r[i]) / SpinChange;
            }
        }

        return true;
    }

    /// <summary>Applies Broyden's update, scaled so that 1 rad weighs as much as 100 rad/s of spin.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="before">The residuals before the last step.</param>
    /// <param name="after">The residuals after it.</param>
    public void Update(PlaneProblem problem, double[] before, double[] after)
    {
        double[] dx = Change;
        if (!problem.HasThrough)
        {
            double up = after[PlaneProblem.TargetUp] - before[PlaneProblem.TargetUp];
            _angles.Update(dx[PlaneProblem.Elevation], dx[PlaneProblem.Azimuth], up, after[PlaneProblem.TargetLeft] - before[PlaneProblem.TargetLeft]);
            return;
        }

        double squared = (dx[0] * dx[0]) + (dx[1] * dx[1]) + (SpinUnit * ((dx[2] * dx[2]) + (dx[3] * dx[3])));
        for (int i = 0; i < N; i++)
        {
            Broyden.Update(_j, i * N, N, dx, _weight, squared, after[i] - before[i]);
        }
    }

    /// <summary>Solves for the changes.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="x">The unknowns.</param>
    /// <param name="r">The residuals.</param>
    /// <param name="sameHeld">True if the same spins are held as in the previous step.</param>
    /// <returns>False if the system is singular, or the kick would turn too far or leave its bounds.</returns>
    public bool Solve(PlaneProblem problem, double[] x, double[] r, out bool sameHeld)
    {
        sameHeld = true;
        if (!problem.HasThrough)
        {
            bool solved = _angles.Solve(r[PlaneProblem.TargetUp], r[PlaneProblem.TargetLeft], out double up, out double aside);
            Change[PlaneProblem.Elevation] = up;
            Change[PlaneProblem.Azimuth] = aside;
            return solved && Math.Abs(up) < LargestElevation && Math.Abs(aside) < LargestAzimuth && problem.Bounds.Contain(x[PlaneProblem.Elevation] + up);
        }

        // If a spin exceeds its limit, set it to the limit, drop its equation, and solve again: at most twice, once per spin.
        bool topWasHeld = _held[PlaneProblem.Top];
        bool sideWasHeld = _held[PlaneProblem.Side];
        Array.Clear(_held, 0, N);
        bool holds = true;
        for (int attempt = 0; attempt < 3 && holds; attempt++)
        {
            Assemble(x, r);
            if (!Linear.Solve(_system, Change, N))
            {
                return false;
            }

            holds = Hold(problem, PlaneProblem.Top, x) | Hold(problem, PlaneProblem.Side, x);
        }

        sameHeld = topWasHeld == _held[PlaneProblem.Top] && sideWasHeld == _held[PlaneProblem.Side];

        // Clamp the elevation. The spins are already within their limits.
        double elevation = x[PlaneProblem.Elevation];
        Change[PlaneProblem.Elevation] =
            Math.Min(Math.Max(Change[PlaneProblem.Elevation], problem.Bounds.Lowest - elevation), problem.Bounds.Highest - elevation);
        return Math.Max(Math.Abs(Change[PlaneProblem.Elevation]), Math.Abs(Change[PlaneProblem.Azimuth])) < LargestTurn;
    }

    /// <summary>Assembles J Δx = −r; the row of a dropped equation fixes its spin at the limit instead.</summary>
    private void Assemble(double[] x, double[] r)
    {
        for (int i = 0; i < N; i++)
        {
            // At the waypoint, the sidespin gets the equation to the left, and the topspin the equation upwards.
            int spin = i == PlaneProblem.ThroughLeft ? PlaneProblem.Side : PlaneProblem.Top;
            bool dropped = i is PlaneProblem.ThroughLeft or PlaneProblem.ThroughUp && _held[spin];
            int row = i * (N + 1);
            for (int k = 0; k < N; k++)
            {
                _system[row + k] = !dropped ? _j[(i * N) + k] : k == spin ? 1 : 0;
            }

            _system[row + N] = dropped ? _limit[spin] - x[spin] : -r[i];
        }
    }

    /// <summary>Holds a spin at its limit if it would exceed it.</summary>
    /// <returns>True if the spin is now held, so that the system must be solved again.</returns>
    private bool Hold(PlaneProblem problem, int spin, double[] x)
    {
        double limit = spin == PlaneProblem.Top ? problem.Request.MaximumTopSpin : problem.Request.MaximumSideSpin;
        double wanted = x[spin] + Change[spin];
        double allowed = Math.Min(Math.Max(wanted, -limit), limit);
        if (_held[spin] || allowed == wanted)
        {
            return false;
        }

        _held[spin] = true;
        _limit[spin] = allowed;
        return true;
    }

    private void Set(int left, int up, in CrossingJacobian angles)
    {
        _j[(left * N) + PlaneProblem.Elevation] = angles.LeftByElevation;
        _j[(left * N) + PlaneProblem.Azimuth] = angles.LeftByAzimuth;
        _j[(up * N) + PlaneProblem.Elevation] = angles.UpByElevation;
        _j[(up * N) + PlaneProblem.Azimuth] = angles.UpByAzimuth;
    }
}

/// <summary>The derivative of the crossing of a plane (up, left) with respect to elevation and azimuth, in m/rad.</summary>
internal struct CrossingJacobian(double upByElevation, double upByAzimuth, double leftByElevation, double leftByAzimuth)
{
    /// <summary>The derivative of the crossing's height with respect to elevation, in m/rad.</summary>
    public double UpByElevation { readonly get; private set; } = upByElevation;

    /// <summary>The derivative of the crossing's height with respect to azimuth, in m/rad.</summary>
    public double UpByAzimuth { readonly get; private set; } = upByAzimuth;

    /// <summary>The derivative of the crossing's distance to the left with respect to elevation, in m/rad.</summary>
    public double LeftByElevation { readonly get; private set; } = leftByElevation;

    /// <summary>The derivative of the crossing's distance to the left with respect to azimuth, in m/rad.</summary>
    public double LeftByAzimuth { readonly get; private set; } = leftByAzimuth;

    /// <summary>Computes the Jacobian from a single flight.</summary>
    /// <remarks>
    /// Drag and Magnus force rotate with the kick, so the whole path rotates too, except for the displacements by gravity and wind. The rotated end
    /// is then projected along the velocity to the plane.
    /// </remarks>
    /// <param name="kick">The kick.</param>
    /// <param name="crossing">The crossing of the plane.</param>
    /// <param name="frame">The frame of the target.</param>
    /// <param name="wind">The wind, in m/s.</param>
    /// <param name="upward">The upward acceleration by gravity and buoyancy, in m/s².</param>
    public static CrossingJacobian Of(in Kick kick, in PlaneCrossing crossing, in TargetFrame frame, in Vector3d wind, double upward)
    {
        Vector3d p = crossing.Position - frame.From;
        Vector3d d = kick.Direction(in frame.Forward);

        // Drag reduces both displacements by about the ratio of mean speed to launch speed.
        double t = crossing.Time;
        double damping = 0.9;
        Vector3d byGravity = new(0, 0.5 * damping * upward * t * t, 0);
        Vector3d turning = p - byGravity - (0.3 * t * wind);
        Vector3d byElevation = Vector3d.Cross(new Vector3d(-d.Z, 0, d.X), in turning); // the axis d × ŷ raises the kick
        Vector3d byAzimuth = Vector3d.Cross(Vector3d.Up, in turning);
        Elementary.SinCos(kick.Elevation, out double sine, out double cosine);
        if (kick.Side != 0 && cosine > 0.1)
        {
            // The sidespin axis stays vertical, so its Magnus force depends only on the horizontal velocity, which is smaller for steeper kicks.
            Vector3d across = new(d.Z, 0, -d.X); // ŷ × d
            byElevation -= sine / cosine * Vector3d.Dot(in turning, in across) * across;
        }

        // The rotated path no longer ends on the plane, so project its end back along the velocity.
        double speed = Vector3d.Dot(crossing.Velocity, in frame.Forward);
        Vector3d slope = speed > 1e-3 ? crossing.Velocity / speed : frame.Forward;
        byElevation -= Vector3d.Dot(in byElevation, in frame.Forward) * slope;
        byAzimuth -= Vector3d.Dot(in byAzimuth, in frame.Forward) * slope;
        return new CrossingJacobian(
            byElevation.Y, byAzimuth.Y, Vector3d.Dot(in byElevation, in frame.Left), Vector3d.Dot(in byAzimuth, in frame.Left));
    }

    /// <summary>Solves for the changes of elevation and azimuth that move a crossing to the target.</summary>
    /// <param name="up">The height above the target, in m.</param>
    /// <param name="left">The distance to its left, in m.</param>
    /// <param name="elevation">The change of elevation, in rad.</param>
    /// <param name="azimuth">The change of azimuth, in rad.</param>
    /// <returns>False if the Jacobian is singular.</returns>
    public readonly bool Solve(double up, double left, out double elevation, out double azimuth)
    {
        // Solve J Δ = −r for the changes Δ of the angles by Cramer's rule: derivatives J, misses r.
        double determinant = (UpByElevation * LeftByAzimuth) - (UpByAzimuth * LeftByElevation);
        elevation = ((UpByAzimuth * left) - (LeftByAzimuth * up)) / determinant;
        azimuth = ((LeftByElevation * up) - (UpByElevation * left)) / determinant;
        return double.IsFinite(elevation) && double.IsFinite(azimuth);
    }

    /// <summary>Applies Broyden's update after the angles changed: J += (Δr − J Δx) Δxᵀ / |Δx|².</summary>
    public void Update(double elevation, double azimuth, double up, double left)
    {
        double squared = (elevation * elevation) + (azimuth * azimuth);
        if (!(squared > 0))
        {
            return;
        }

        double moreUp = (up - (UpByElevation * elevation) - (UpByAzimuth * azimuth)) / squared;
        double moreLeft = (left - (LeftByElevation * elevation) - (LeftByAzimuth * azimuth)) / squared;
        UpByElevation += moreUp * elevation;
        UpByAzimuth += moreUp * azimuth;
        LeftByElevation += moreLeft * elevation;
        LeftByAzimuth += moreLeft * azimuth;
    }
}
