using FootballPhysics.Numerics;

namespace FootballPhysics.State;

/// <summary>Checks that a state read from bytes is one that a ball can have.</summary>
internal static class StateCheck
{
    /// <summary>Bounds that no ball launched within <see cref="Limits"/> can exceed, in m; speed, spin and time follow in m/s, rad/s and s.</summary>
    /// <remarks>The bounds allow for a fall without drag and for the roll of the smallest ball. Within the bounds, every step gives finite numbers.</remarks>
    private const double Farthest = 1e45;

    /// <summary>The largest speed, in m/s; in a scene, of the speed that the ball would have if it gave its spin to its motion.</summary>
    public const double FastestSpeed = 1e30;

    private const double FastestSpin = 1e35;
    private const double LatestTime = 1e15;

    /// <summary>The latest <see cref="BallState.ClearUntil"/>, in s: a search looks ahead by at most a few of the longest steps.</summary>
    private const double LatestClear = 2 * LatestTime;

    /// <summary>The largest angle since the last change of the spin, in rad.</summary>
    private const double LargestAngle = FastestSpin * LatestTime;

    /// <summary>The allowed deviation from 1 of the squared length of a unit vector or quaternion.</summary>
    private const double Rounding = 1e-6;

    /// <summary>True if a ball can have this state: the test of <see cref="Validate"/>, in a few nanoseconds.</summary>
    public static bool Holds(in BallState state)
    {
        // Comparisons with NaN are false, so a NaN fails the test.
        Vector3d p = state.Position;
        Vector3d v = state.Velocity;
        if (!(state.Time >= 0 && state.Time <= LatestTime && (uint)state.Branch < 5 && (ulong)state.Carrier <= int.MaxValue
            && p.LengthSquared <= 3 * Farthest * Farthest && v.LengthSquared <= FastestSpeed * FastestSpeed
            && Math.Abs(state.BaseOrientation.LengthSquared - 1) <= Rounding
            && state.ClearUntil >= 0 && state.ClearUntil <= LatestClear && (state.ClearIn != 0 || state.ClearUntil == 0)
            && state.AirDistance >= 0 && state.AirDistance <= Farthest
            && (state.Reserved | state.ReservedToo) == 0))
        {
            return false;
        }

        // In flight, the state has a unit axis, a rate and an angle.
        double axis = state.SpinAxis.LengthSquared;
        if (state.Motion == MotionState.Airborne)
        {
            return Math.Abs(axis - 1) <= Rounding && state.SpinRate >= 0 && state.SpinRate <= FastestSpin && Math.Abs(state.Angle) <= LargestAngle;
        }

        // On the ground, SpinAxis stores the spin. A supporting object may move and carry the ball along.
        bool carried = state.SpinRate == 1 && state.Angle == 0;
        return state.Motion == MotionState.Rest
            ? carried && (state.Carrier > 0 ? axis <= Limits.Spin * Limits.Spin : axis == 0 && v.LengthSquared == 0)
            : carried && (state.Motion is MotionState.Sliding or MotionState.Rolling or MotionState.Pinned) && axis <= FastestSpin * FastestSpin;
    }

    /// <summary>Throws if no ball can have this state.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public static void Validate(in BallState state)
    {
        Check.Within("state.time", state.Time, 0, LatestTime);
        Check.Defined("state.motion", state.Motion, (int)state.Motion, 5);
        Check.Defined("state.branch", state.Branch, (int)state.Branch, 5);
        double size = Math.Max(Math.Max(Math.Abs(state.Position.X), Math.Abs(state.Position.Y)), Math.Abs(state.Position.Z));
        Check.Within("state.position", state.Position.IsFinite ? size : double.NaN, 0, Farthest);
        Check.Size("state.velocity", state.Velocity, FastestSpeed, "m/s");
        Check.Within("state.orientation", state.BaseOrientation.LengthSquared, 1 - Rounding, 1 + Rounding);
        Check.Within("state.angle", state.Angle, -LargestAngle, LargestAngle);
        if (state.Motion == MotionState.Airborne)
        {
            Check.Within("state.spinAxis", state.SpinAxis.LengthSquared, 1 - Rounding, 1 + Rounding);
            Check.Within("state.spinRate", state.SpinRate, 0, FastestSpin);
        }
        else
        {
            // On the ground, SpinAxis stores the spin.
            Check.Size("state.spin", state.SpinAxis, state.Motion != MotionState.Rest ? FastestSpin : state.Carrier > 0 ? Limits.Spin : 0, "rad/s");
            Check.Within("state.spinRate", state.SpinRate, 1, 1);
            Check.Within("state.angle", state.Angle, 0, 0);
        }

        // A ball can rest on a moving object.
        double moves = state.Carrier > 0 ? FastestSpeed : 0;
        if (state.Motion == MotionState.Rest)
        {
            Check.Size("state.velocity", state.Velocity, moves, "m/s");
        }

        Check.Within("state.carrier", state.Carrier, 0, int.MaxValue);
        Check.Within("state.clearUntil", state.ClearUntil, 0, state.ClearIn != 0 ? LatestClear : 0);
        Check.Within("state.airDistance", state.AirDistance, 0, Farthest);
        Check.Within("state.reserved", state.Reserved | state.ReservedToo, 0, 0);
    }
}
