namespace FootballPhysics.Batch;

/// <content>The method of derivatives: one kick, its linear map to the plane, and test kicks that bend the map.</content>
public sealed partial class GoalChance
{
    /// <summary>Limits of the test kicks at two standard deviations, relative to two standard deviations along the short axis.</summary>
    /// <remarks>The first limits the error of the derivatives, the second the common bend of both sides, whose mean is corrected. Below the third, in m, neither counts.</remarks>
    private const double LargestError = 0.08;
    private const double LargestBend = 0.25;
    private const double Negligible = 1e-3;

    /// <summary>The largest correction of a probability by the curvature of the map and the times of the crossings.</summary>
    private const double LargestCorrection = 0.01;

    private const double TimeStep = 0.02;

    private readonly CrossingMap _map = new();

    /// <summary>Tries the derivatives: A = M L maps normal numbers to the plane. False if kicks at ± two standard deviations disagree.</summary>
    private bool TryDerivatives(in SpreadKick kick, in GoalPlane plane, out GoalChanceResult result)
    {
        result = default;
        PlaneCrossingPoint meant = _flights.Alone(in kick, in plane, kick.Velocity, kick.Spin);
        if (!(meant.Time > 0))
        {
            return false;
        }

        BallState ball = _simulator.Launch(kick.Position, kick.Velocity, kick.Spin, kick.Orientation);
        _derivatives.Run(ref ball, TimeStep, meant.Time, StopAt.Time);
        plane.Place(meant.Position, out double aside, out double height);
        double a = 0;
        double b = 0;
        double c = 0;
        for (int j = 0; j < KickSpread.Count; j++)
        {
            Map(in kick, in plane, ball.Velocity, j, out double right, out double up);
            a += right * right;
            b += up * up;
            c += right * up;
        }

        double product = Math.Sqrt(a * b);
        result = new GoalChanceResult
        {
            Method = GoalChanceMethod.Derivatives,
            Kicks = 2 + (2 * KickSpread.Count),
            Crosses = 1,
            Aside = aside,
            Height = height,
            Time = meant.Time,
            AsideDeviation = Math.Sqrt(a),
            HeightDeviation = Math.Sqrt(b),
            Correlation = product > 0 ? Math.Min(1, Math.Max(-1, c / product)) : 0,
        };
        double shiftAside = 0;
        double shiftHeight = 0;
        _map.Begin(aside, height, meant.Time);
        for (int j = 0; j < KickSpread.Count; j++)
        {
            Map(in kick, in plane, ball.Velocity, j, out double right, out double up);
            if (!Holds(in kick, in plane, in result, j, right, up, out double bendAside, out double bendHeight))
            {
                return false;
            }

            // The mean of a curve x + ½ x'' z² is shifted by ½ x''.
            shiftAside += 0.5 * bendAside;
            shiftHeight += 0.5 * bendHeight;
        }

        result = result with { Aside = aside + shiftAside, Height = height + shiftHeight };
        _frame!.Look(_simulator, in kick, meant.Time, in result);
        plane.Chances(in result, _frame, out double onTarget, out double covered);
        _map.Correct(in plane, in result, _frame, out double moreOnTarget, out double moreCovered);
        result = result with
        {
            OnTarget = Share(onTarget + moreOnTarget, 1),
            Covered = Share(covered + moreCovered, onTarget + moreOnTarget),
        };
        return Math.Abs(moreOnTarget) <= LargestCorrection && Math.Abs(moreCovered) <= LargestCorrection;
    }

    private static double Share(double value, double most) => Math.Max(0, Math.Min(value, Math.Min(most, 1)));

    /// <summary>Maps one standard deviation along a column of L to the plane: δq = δp − v (n·δp)/(n·v).</summary>
    private void Map(in SpreadKick kick, in GoalPlane plane, in Vector3d velocity, int column, out double right, out double up)
    {
        Vector3d change = Vector3d.Zero;
        for (int i = 0; i < KickSpread.Count; i++)
        {
            kick.Derivative(i, out Vector3d velocityBy, out Vector3d spinBy);
            _by[i] = _factor[(i * KickSpread.Count) + column];
            change += _by[i] * ((_derivatives.PositionByVelocity * velocityBy) + (_derivatives.PositionBySpin * spinBy));
        }

        Vector3d normal = plane.Out;
        change -= Vector3d.Dot(in normal, in change) / Vector3d.Dot(in normal, in velocity) * velocity;
        plane.Change(in change, out right, out up);
    }

    /// <summary>Returns true if kicks at two standard deviations on both sides cross where the derivatives predict. Also returns their second derivative.</summary>
    private bool Holds(
        in SpreadKick kick, in GoalPlane plane, in GoalChanceResult at, int column, double right, double up, out double bendAside, out double bendHeight)
    {
        bool crosses = Cross(in kick, in plane, 2.0, out double x1, out double y1, out double t1);
        crosses &= Cross(in kick, in plane, -2.0, out double x0, out double y0, out double t0);
        _map.Set(column, right, up, x0, x1, y0, y1, t0, t1);
        double oddX = (0.5 * (x1 - x0)) - (2.0 * right);
        double oddY = (0.5 * (y1 - y0)) - (2.0 * up);
        double evenX = x1 + x0 - (2.0 * at.Aside);
        double evenY = y1 + y0 - (2.0 * at.Height);
        bendAside = 0.25 * evenX;
        bendHeight = 0.25 * evenY;
        double axis = 2.0 * at.ShortAxis;
        return crosses && Math.Sqrt((oddX * oddX) + (oddY * oddY)) <= (LargestError * axis) + Negligible
            && 0.5 * Math.Sqrt((evenX * evenX) + (evenY * evenY)) <= (LargestBend * axis) + Negligible;
    }

    private bool Cross(in SpreadKick kick, in GoalPlane plane, double deviations, out double aside, out double height, out double time)
    {
        for (int i = 0; i < KickSpread.Count; i++)
        {
            _draws[i] = deviations * _by[i];
        }

        kick.With(_draws, out Vector3d velocity, out Vector3d spin);
        PlaneCrossingPoint at = _flights.Alone(in kick, in plane, in velocity, in spin);
        plane.Place(at.Position, out aside, out height);
        time = at.Time;
        return time > 0;
    }
}
