using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The closed-form initial guess of a kick with a waypoint.</summary>
/// <remarks>
/// The path bends sideways like a parabola in time, so the two bearings yield azimuth and lateral curvature. The same applies vertically, once the
/// fall by gravity is removed. The curvatures are then converted to spins.
/// </remarks>
internal static class TwoPointGuess
{
    /// <summary>Guesses the unknowns of a problem.</summary>
    /// <param name="context">The scene.</param>
    /// <param name="problem">The problem.</param>
    /// <param name="x">The unknowns.</param>
    /// <param name="throughTime">The approximate time at the waypoint, in s.</param>
    /// <param name="targetTime">The approximate time at the target, in s.</param>
    /// <returns>The drag per length, in 1/m.</returns>
    public static double Make(AimContext context, PlaneProblem problem, double[] x, out double throughTime, out double targetTime)
    {
        // In each of three rounds, compute times from the drag, bearings and curvatures from both points, spin from curvature, and then the drag again.
        AimRequest request = problem.Request;
        ref readonly TargetFrame frame = ref problem.Frame;
        Vector3d wind = context.Scene.Air.Wind;
        double mostSpin = Math.Sqrt((request.MaximumTopSpin * request.MaximumTopSpin) + (request.MaximumSideSpin * request.MaximumSideSpin));
        double spinRate = Math.Max(10.0, Math.Sqrt((request.TopSpin * request.TopSpin) + (request.SideSpin * request.SideSpin)));
        double top = 0;
        double side = 0;
        double elevation = 0.2;
        double aside = 0;
        double drag = 0;
        throughTime = 0;
        targetTime = 0;
        for (int i = 0; i < 3; i++)
        {
            FlatFire model = context.Model(request.Speed, spinRate, frame.Distance);
            Elementary.SinCos(elevation, out _, out double cosine);
            drag = model.Drag;
            double t1 = model.TimeFor(request.Speed, problem.ThroughDistance / Math.Max(cosine, 0.3));
            double t2 = model.TimeFor(request.Speed, frame.Distance / Math.Max(cosine, 0.3));
            throughTime = t1;
            targetTime = t2;
            model.Ways(request.Speed, t1, out double s1, out _, out double fall1, out double bend1);
            model.Ways(request.Speed, t2, out double s2, out _, out double fall2, out double bend2);

            // Subtract gravity and wind. The remaining offset at each point is s · slope + bend · lift; solve both equations for slope and lift.
            double left1 = Vector3d.Dot(problem.Through - frame.From - (t1 * wind), in frame.Left);
            double left2 = Vector3d.Dot(frame.Target - frame.From - (t2 * wind), in frame.Left);
            double up1 = problem.Through.Y - frame.From.Y - (t1 * wind.Y) - (model.Upward * fall1);
            double up2 = frame.Target.Y - frame.From.Y - (t2 * wind.Y) - (model.Upward * fall2);
            double determinant = (s1 * bend2) - (s2 * bend1);
            double slopeLeft = ((left1 * bend2) - (left2 * bend1)) / determinant;
            double bendLeft = ((s1 * left2) - (s2 * left1)) / determinant;
            double slopeUp = ((up1 * bend2) - (up2 * bend1)) / determinant;
            double bendUp = ((s1 * up2) - (s2 * up1)) / determinant;

            // Solve the law of lift, L ~ |ω|^0.83, for the spin rate |ω|.
            double lift = Math.Sqrt((bendLeft * bendLeft) + (bendUp * bendUp));
            double share = model.Lift > 0 ? lift / model.Lift : 0;
            double grown = spinRate * Math.Min(Math.Max(share * (0.83 + (0.17 * share)), 0.1), 4.0);
            spinRate = Math.Min(Math.Max(grown, 0.5), 1.5 * mostSpin);
            if (!double.IsFinite(lift + slopeUp + slopeLeft))
            {
                // No path in the model passes the waypoint: aim straight at the target, and leave the rest to the single-target solver.
                side = 0;
                top = 0;
                break;
            }

            side = lift > 0 ? spinRate * bendLeft / lift : 0;
            top = lift > 0 ? -spinRate * bendUp / lift : 0;
            elevation = Math.Min(Math.Max(AngleOf(slopeUp), -1.2), 1.2);
            aside = slopeLeft;
        }

        x[PlaneProblem.Elevation] = problem.Bounds.Clamp(elevation);
        x[PlaneProblem.Azimuth] = AngleOf(aside);
        x[PlaneProblem.Top] = Math.Min(Math.Max(top, -request.MaximumTopSpin), request.MaximumTopSpin);
        x[PlaneProblem.Side] = Math.Min(Math.Max(side, -request.MaximumSideSpin), request.MaximumSideSpin);
        return drag;
    }

    /// <summary>Returns the angle of a direction from its transverse component.</summary>
    private static double AngleOf(double across) => Elementary.Atan2(across, Math.Sqrt(Math.Max(0.05, 1.0 - (across * across))));
}
