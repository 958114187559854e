namespace Football.Physics;

/// <summary>A = ∂ẏ/∂y along a piece: how the rates change with the motion, by difference quotients of one evaluation of them.</summary>
internal static class MotionJacobian
{
    /// <summary>Share of the scale on which the rates change by which a number is changed: what is cut off and what is rounded are then about 1e-9 of the rates.</summary>
    private const double Share = 1e-4;
    private const double LargestVelocity = 3e-4;
    private const double LeastVelocity = 1e-9;
    private const double LargestSpin = 1e-3;
    private const double LeastSpin = 1e-6;
    private const double LargestRoll = 0.02;
    private const double RollShare = 0.005;

    /// <summary>A at a motion.</summary>
    public static void At<TAir>(LocalMotion<TAir> local, double time, in Motion at, double[] a)
        where TAir : struct, IAir
    {
        Array.Clear(a, 0, a.Length);
        for (int i = 0; i < 3; i++)
        {
            a[(i * MotionVector.Size) + MotionVector.Velocity + i] = 1;
        }

        // Where the ball slips or rolls, friction turns with the slip or the velocity: the smaller that is, the faster.
        bool carried = local.Motion is MotionState.Sliding or MotionState.Rolling;
        double scale = !carried ? double.PositiveInfinity : local.Motion == MotionState.Sliding ? local.SlipAt(time, in at) : at.Velocity.Length;
        bool rolls = local.Motion == MotionState.Rolling;
        double velocityWidth = rolls ? Math.Max(LeastVelocity, Math.Min(LargestRoll, RollShare * scale)) : Math.Max(LeastVelocity, Math.Min(LargestVelocity, Share * scale));
        double spinWidth = rolls ? 10.0 * velocityWidth
            : local.Motion == MotionState.Sliding ? Math.Max(LeastVelocity, Math.Min(LargestSpin, Share * scale))
            : Math.Max(LeastSpin, Math.Min(LargestSpin, Share * at.Spin.Length));
        for (int i = local.DependsOnPlace ? 0 : MotionVector.Velocity; i < (local.DependsOnPlace ? MotionVector.Size : MotionVector.AirDistance); i++)
        {
            double width = i < MotionVector.Velocity || i == MotionVector.AirDistance ? MotionVector.Width(in at, i) : i < MotionVector.Spin ? velocityWidth : spinWidth;
            Difference(local, time, in at, i, width, out MotionRates near);
            if (local.Motion == MotionState.Rolling)
            {
                // Rolling lies on the edge of the tables of the laws, where they meet the laws to nine digits: wide differences of fourth order, (4 q(h) − q(2h))/3.
                Difference(local, time, in at, i, 2.0 * width, out MotionRates far);
                near = new MotionRates(
                    near.Acceleration + ((1.0 / 3.0) * (near.Acceleration - far.Acceleration)),
                    near.SpinAcceleration + ((1.0 / 3.0) * (near.SpinAcceleration - far.SpinAcceleration)),
                    near.AirSpeed);
            }

            MotionVector.Write(a, MotionVector.Velocity, i, near.Acceleration);
            MotionVector.Write(a, MotionVector.Spin, i, near.SpinAcceleration);
            a[(MotionVector.AirDistance * MotionVector.Size) + i] = near.AirSpeed;
        }
    }

    private static void Difference<TAir>(LocalMotion<TAir> local, double time, in Motion at, int index, double width, out MotionRates quotient)
        where TAir : struct, IAir
    {
        local.Rates(time, MotionVector.Changed(in at, index, width), out MotionRates high);
        local.Rates(time, MotionVector.Changed(in at, index, -width), out MotionRates low);
        double perWidth = 0.5 / width;
        quotient = new MotionRates(
            perWidth * (high.Acceleration - low.Acceleration), perWidth * (high.SpinAcceleration - low.SpinAcceleration), perWidth * (high.AirSpeed - low.AirSpeed));
    }
}
