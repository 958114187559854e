namespace Football.Physics;

/// <summary>
/// One Newton step of a two-point kick by the active-set method. A spin that would pass its limit is held there, and the equation at the point
/// on the way that it serves is dropped: the point is then missed, in that direction, by as little as the limit allows.
/// </summary>
internal sealed class TwoPointStep
{
    private const int N = TwoPointProblem.Size;

    /// <summary>Largest change of an angle, rad.</summary>
    private const double LargestTurn = 1.0;

    private readonly double[] _system = new double[N * (N + 1)];
    private readonly double[] _limit = new double[N];
    private readonly bool[] _held = new bool[N];

    /// <summary>The changes of the unknowns.</summary>
    public double[] Change { get; } = new double[N];

    /// <summary>Forgets which spins were held.</summary>
    public void Reset() => Array.Clear(_held, 0, N);

    /// <summary>The miss at the point on the way, m, but for the directions of spins that are held at their limit.</summary>
    public double ThroughAsked(double[] r)
    {
        double left = _held[TwoPointProblem.Side] ? 0 : r[TwoPointProblem.ThroughLeft];
        double up = _held[TwoPointProblem.Top] ? 0 : r[TwoPointProblem.ThroughUp];
        return Math.Sqrt((left * left) + (up * up));
    }

    /// <summary>Solves for the changes.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="jacobian">How the residuals move.</param>
    /// <param name="x">The unknowns.</param>
    /// <param name="r">The residuals.</param>
    /// <param name="sameHeld">Whether the same spins are held as in the step before.</param>
    /// <returns>False where the system is singular, or the kick would turn too far.</returns>
    public bool Solve(TwoPointProblem problem, TwoPointJacobian jacobian, double[] x, double[] r, out bool sameHeld)
    {
        // A spin that the step takes beyond its limit is put on it, its equation is dropped, and the rest is solved again: twice at most, once for each spin.
        bool topWasHeld = _held[TwoPointProblem.Top];
        bool sideWasHeld = _held[TwoPointProblem.Side];
        Reset();
        sameHeld = false;
        for (int attempt = 0; attempt < 3; attempt++)
        {
            Assemble(jacobian, x, r);
            if (!Linear.Solve(_system, Change, N))
            {
                return false;
            }

            bool holdsTop = Hold(problem, TwoPointProblem.Top, x);
            bool holdsSide = Hold(problem, TwoPointProblem.Side, x);
            if (!holdsTop && !holdsSide)
            {
                break;
            }
        }

        sameHeld = topWasHeld == _held[TwoPointProblem.Top] && sideWasHeld == _held[TwoPointProblem.Side];
        double elevation = x[TwoPointProblem.Elevation];
        Change[TwoPointProblem.Elevation] =
            Math.Min(Math.Max(Change[TwoPointProblem.Elevation], problem.Bounds.Lowest - elevation), problem.Bounds.Highest - elevation);
        return Math.Max(Math.Abs(Change[TwoPointProblem.Elevation]), Math.Abs(Change[TwoPointProblem.Azimuth])) < LargestTurn;
    }

    /// <summary>The system J Δx = −r; the row of a dropped equation holds its spin at the limit instead.</summary>
    private void Assemble(TwoPointJacobian jacobian, double[] x, double[] r)
    {
        for (int i = 0; i < N; i++)
        {
            // Left at the point on the way is the side spin's equation, up the top spin's.
            int spin = i == TwoPointProblem.ThroughLeft ? TwoPointProblem.Side : TwoPointProblem.Top;
            bool dropped = i is TwoPointProblem.ThroughLeft or TwoPointProblem.ThroughUp && _held[spin];
            int row = i * (N + 1);
            for (int k = 0; k < N; k++)
            {
                _system[row + k] = !dropped ? jacobian[i, k] : k == spin ? 1 : 0;
            }

            _system[row + N] = dropped ? _limit[spin] - x[spin] : -r[i];
        }
    }

    /// <summary>Holds a spin at its limit where it would pass it.</summary>
    /// <returns>Whether it is held from now on, so that the system must be solved again.</returns>
    private bool Hold(TwoPointProblem problem, int spin, double[] x)
    {
        double limit = problem.Limit(spin);
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
}

/// <summary>How the crossings of both planes move with the four unknowns of a two-point kick.</summary>
internal sealed class TwoPointJacobian
{
    private const int N = TwoPointProblem.Size;

    /// <summary>Change of a spin, rad/s, by which its effect is found: what a rehearsal is off by the guess of its time must not count.</summary>
    private const double SpinChange = 0.5;

    /// <summary>Square of the angle, rad, that counts as much as 1 rad/s of spin.</summary>
    private const double SpinUnit = 1e-4;

    private readonly double[] _j = new double[N * N];
    private readonly double[] _changed = new double[N];

    /// <summary>How an equation's residual moves with an unknown.</summary>
    public double this[int equation, int unknown] => _j[(equation * N) + unknown];

    /// <summary>In the air that kicks are rehearsed in: the angles' columns read off the last kick, the spins' by differences.</summary>
    /// <param name="problem">The problem.</param>
    /// <param name="x">The unknowns of the last kick that was rehearsed.</param>
    /// <param name="rehearsed">Its residuals.</param>
    /// <returns>False where a kick with a little more spin does not reach both planes.</returns>
    public bool Rehearse(TwoPointProblem problem, double[] x, double[] rehearsed)
    {
        Set(TwoPointProblem.ThroughLeft, TwoPointProblem.ThroughUp, problem.JacobianAtThrough(x));
        Set(TwoPointProblem.TargetLeft, TwoPointProblem.TargetUp, problem.JacobianAtTarget(x));
        for (int k = TwoPointProblem.Top; k <= TwoPointProblem.Side; k++)
        {
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
                _j[(i * N) + k] = (_changed[i] - rehearsed[i]) / SpinChange;
            }
        }

        return true;
    }

    /// <summary>Broyden's update: J += (Δr − J Δx) Δxᵀ / |Δx|², in units in which a radian and 100 rad/s of spin count alike.</summary>
    /// <param name="dx">What the unknowns changed by.</param>
    /// <param name="before">The residuals before.</param>
    /// <param name="after">The residuals after.</param>
    public void Update(double[] dx, double[] before, double[] after)
    {
        // The least change of the Jacobian that agrees with the last step.
        double squared = (dx[0] * dx[0]) + (dx[1] * dx[1]) + (SpinUnit * ((dx[2] * dx[2]) + (dx[3] * dx[3])));
        if (!(squared > 0))
        {
            return;
        }

        for (int i = 0; i < N; i++)
        {
            double error = after[i] - before[i];
            for (int k = 0; k < N; k++)
            {
                error -= _j[(i * N) + k] * dx[k];
            }

            for (int k = 0; k < N; k++)
            {
                _j[(i * N) + k] += error * (k < TwoPointProblem.Top ? 1 : SpinUnit) * dx[k] / squared;
            }
        }
    }

    private void Set(int left, int up, in CrossingJacobian angles)
    {
        _j[(left * N) + TwoPointProblem.Elevation] = angles.LeftByElevation;
        _j[(left * N) + TwoPointProblem.Azimuth] = angles.LeftByAzimuth;
        _j[(up * N) + TwoPointProblem.Elevation] = angles.UpByElevation;
        _j[(up * N) + TwoPointProblem.Azimuth] = angles.UpByAzimuth;
    }
}
