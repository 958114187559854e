namespace Football.Physics;

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
