using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>Finds balls that come so close to the drag law's jump that a step in floats does not tell on which side it is.</summary>
/// <remarks>
/// The branch with spin holds where both |u|² − v_c² and (r|ω|/0.05)² − |u|² are positive. Of each a parabola over the step is known, through
/// both ends and the middle: the mean velocity of the step by Simpson's rule gives the middle one.
/// </remarks>
internal static class LaneJumpCheck
{
    /// <summary>Share of the largest bend of the distance from the jump in a step that a parabola may hide.</summary>
    private const double Margin = 0.05;

    /// <summary>A crossing is steep enough where its slope is above this, of the same.</summary>
    private const double LeastSlope = 0.5;

    /// <summary>True when a step comes too close.</summary>
    /// <param name="now">Before the step.</param>
    /// <param name="next">After the step.</param>
    /// <param name="at">The ball's place.</param>
    /// <param name="jump">Where the law jumps.</param>
    /// <param name="inside">Whether the step began on the branch with spin.</param>
    /// <param name="crosses">Whether it ended on the other.</param>
    /// <param name="length">Length of the step, s.</param>
    [MethodImpl(Hot.Path)]
    public static bool Grazes(LaneState now, LaneState next, int at, in LaneJump jump, bool inside, bool crosses, double length)
    {
        double bend = Distances(now, at, next, at, in jump, length, out LaneParabola bySpeed, out LaneParabola bySpin);
        double margin = Margin * bend;
        if (crosses)
        {
            // Where the nearer of the two is another one at the end, the crossing is not that of a parabola.
            return bySpeed.CrossesBelow(LeastSlope * bend) || bySpin.CrossesBelow(LeastSlope * bend)
                || (bySpeed.Start < bySpin.Start) != (bySpeed.End < bySpin.End);
        }

        return inside
            ? bySpeed.LeastWithin() < margin || bySpin.LeastWithin() < margin
            : bySpeed.Greatest(margin) > 0 && bySpin.Greatest(margin) > 0;
    }

    /// <summary>True when the rest of a step from the jump on does not lead away from it at once: the ball then slides along it.</summary>
    /// <param name="middle">At the jump.</param>
    /// <param name="from">The ball's place there.</param>
    /// <param name="next">After the step.</param>
    /// <param name="to">The ball's place there.</param>
    /// <param name="jump">Where the law jumps.</param>
    /// <param name="inside">Whether it enters the branch with spin.</param>
    /// <param name="length">Length of the rest of the step, s.</param>
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

    /// <summary>|u|² − v_c² and (r|ω|/0.05)² − |u|² over a time.</summary>
    /// <returns>Twice the most that they can bend by in that time.</returns>
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
