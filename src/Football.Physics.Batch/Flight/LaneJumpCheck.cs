using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Finds balls so close to the jump in the drag law that a step in floats cannot tell their side.</summary>
/// <remarks>
/// The branch with spin holds where both |u|² − v_c² and (r|ω|/0.05)² − |u|² are positive. Each is approximated by a parabola over the step, through its ends
/// and middle. Simpson's rule gives the middle velocity from the mean velocity of the step.
/// </remarks>
internal static class LaneJumpCheck
{
    /// <summary>The share of the largest bend of the distance in a step that the parabola may miss.</summary>
    private const double Margin = 0.05;

    /// <summary>The slope, relative to the same bend, above which a crossing is steep enough.</summary>
    private const double LeastSlope = 0.5;

    /// <summary>Returns true if a step comes too close to the jump.</summary>
    /// <param name="now">The state before the step.</param>
    /// <param name="next">The state after the step.</param>
    /// <param name="at">The slot of the ball.</param>
    /// <param name="jump">The jump in the drag law.</param>
    /// <param name="inside">True if the step began on the branch with spin.</param>
    /// <param name="crosses">True if it ended on the other branch.</param>
    /// <param name="length">The length of the step, in s.</param>
    [MethodImpl(Hot.Path)]
    public static bool Grazes(LaneState now, LaneState next, int at, in LaneJump jump, bool inside, bool crosses, double length)
    {
        double bend = Distances(now, at, next, at, in jump, length, out LaneParabola bySpeed, out LaneParabola bySpin);
        double margin = Margin * bend;
        if (crosses)
        {
            // If the nearer surface changes within the step, a single parabola does not describe the crossing.
            return bySpeed.CrossesBelow(LeastSlope * bend) || bySpin.CrossesBelow(LeastSlope * bend)
                || (bySpeed.Start < bySpin.Start) != (bySpeed.End < bySpin.End);
        }

        return inside
            ? bySpeed.LeastWithin() < margin || bySpin.LeastWithin() < margin
            : bySpeed.Greatest(margin) > 0 && bySpin.Greatest(margin) > 0;
    }

    /// <summary>Returns true if the ball does not move away from the jump at once, so that it slides along it.</summary>
    /// <param name="middle">The state at the jump.</param>
    /// <param name="from">The slot of the ball in this state.</param>
    /// <param name="next">The state after the step.</param>
    /// <param name="to">The slot of the ball in that state.</param>
    /// <param name="jump">The jump in the drag law.</param>
    /// <param name="inside">True if the ball enters the branch with spin.</param>
    /// <param name="length">The length of the rest of the step, in s.</param>
    [MethodImpl(Hot.Path)]
    public static bool Slides(LaneState middle, int from, LaneState next, int to, in LaneJump jump, bool inside, double length)
    {
        if (!(length > 0))
        {
            return false;
        }

        double bend = Distances(middle, from, next, to, in jump, length, out LaneParabola bySpeed, out LaneParabola bySpin);
        LaneParabola nearer = Math.Abs(bySpeed.Start) < Math.Abs(bySpin.Start) ? bySpeed : bySpin;
        return (inside ? nearer.StartSlope : -nearer.StartSlope) < LeastSlope * bend;
    }

    /// <summary>Computes the parabolas of |u|² − v_c² and (r|ω|/0.05)² − |u|² over a time.</summary>
    /// <returns>Twice the largest bend of both in that time.</returns>
    [MethodImpl(Hot.Path)]
    private static double Distances(
        LaneState start, int from, LaneState end, int to, in LaneJump jump, double length, out LaneParabola bySpeed, out LaneParabola bySpin)
    {
        Vector3d u0 = start.Velocity(from);
        Vector3d u1 = end.Velocity(to);
        Vector3d middle = 0.25 * (((6.0 / length) * (end.Path(to) - start.Path(from))) - u0 - u1);
        double w0 = start.W[from];
        double w1 = end.W[to];
        double w = 0.5 * (w0 + w1);
        const double Least = FittedDrag.CriticalSpeed * FittedDrag.CriticalSpeed;
        double s0 = u0.LengthSquared;
        double sm = middle.LengthSquared;
        double s1 = u1.LengthSquared;
        bySpeed = new LaneParabola(s0 - Least, sm - Least, s1 - Least);
        bySpin = new LaneParabola((jump.PerSpinSquared * w0 * w0) - s0, (jump.PerSpinSquared * w * w) - sm, (jump.PerSpinSquared * w1 * w1) - s1);
        return 2.0 * length * jump.Gravity * (u1 - u0).Length;
    }
}
