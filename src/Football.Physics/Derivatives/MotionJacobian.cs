namespace Football.Physics;

/// <summary>
/// A = ∂ẏ/∂y along a piece: how the rates change with the motion, by difference quotients. What changes fast with the motion is taken apart: the direction of a
/// slide's friction, which turns with the slip, and the push of nets, which has kinks. The rest is smooth, and its differences are wide: where the laws are
/// asked by tables, those meet the laws to nine digits, and narrow differences would magnify that.
/// </summary>
internal static class MotionJacobian
{
    /// <summary>Share of a speed by which it is changed, and the largest and the least change, m/s.</summary>
    private const double Share = 0.005;
    private const double Largest = 0.02;
    private const double Least = 1e-9;

    /// <summary>A spin is changed by so much more, 1/m.</summary>
    private const double PerRadius = 10.0;

    /// <summary>Share of what is left up to a kink of the nets' push by which a motion is changed, and the least change of a place, m.</summary>
    private const double NetShare = 0.2;
    private const double LeastInPlace = 1e-8;

    /// <summary>Share of the slip by which it is changed.</summary>
    private const double SlipShare = 4e-3;

    /// <summary>A at a motion.</summary>
    public static void At<TAir>(LocalMotion<TAir> local, double time, in Motion at, double[] a)
        where TAir : struct, IAir => At(local, time, in at, in at, a);

    /// <summary>A at a motion, on that side of the kinks of the forces on which it is a moment later.</summary>
    public static void At<TAir>(LocalMotion<TAir> local, double time, in Motion at, in Motion soon, double[] a)
        where TAir : struct, IAir
    {
        Array.Clear(a, 0, a.Length);
        for (int i = 0; i < 3; i++)
        {
            a[(i * MotionVector.Size) + MotionVector.Velocity + i] = 1;
        }

        // The air's forces turn with the flow, a rolling ball's friction with its velocity: the smaller they are, the faster.
        double flow = local.FlowAt(in at);
        double scale = local.Motion == MotionState.Rolling ? Math.Min(flow, local.SpeedOnSurface(time, in at)) : flow;
        double narrow = Math.Max(Least, Math.Min(Largest, Share * scale));
        double inPlace = double.PositiveInfinity;
        bool taken = !local.IsGuided;
        if (local.Nets != 0 && !(taken && local.Motion == MotionState.Airborne))
        {
            // On one side of where the push of a net begins or ends.
            local.NetPush.Margins(in at, out double depth, out double speed);
            inPlace = Math.Max(LeastInPlace, NetShare * depth);
            narrow = Math.Max(Least, Math.Min(narrow, NetShare * speed));
        }

        Vector3d direction = local.Motion == MotionState.Sliding ? local.SlipDirection(time, in at) : Vector3d.Zero;
        for (int i = local.DependsOnPlace ? 0 : MotionVector.Velocity; i < (local.DependsOnPlace ? MotionVector.Size : MotionVector.AirDistance); i++)
        {
            double width = i < MotionVector.Velocity || i == MotionVector.AirDistance ? Math.Min(inPlace, MotionVector.Width(in at, i)) : i < MotionVector.Spin ? narrow : PerRadius * narrow;
            Difference(local, time, in at, i, width, taken, in direction, out MotionRates near);
            if (i >= MotionVector.Velocity && i < MotionVector.AirDistance)
            {
                // Of fourth order, (4 q(h) − q(2h))/3.
                Difference(local, time, in at, i, 2.0 * width, taken, in direction, out MotionRates far);
                near = new MotionRates(
                    near.Acceleration + ((1.0 / 3.0) * (near.Acceleration - far.Acceleration)),
                    near.SpinAcceleration + ((1.0 / 3.0) * (near.SpinAcceleration - far.SpinAcceleration)),
                    near.AirSpeed + ((1.0 / 3.0) * (near.AirSpeed - far.AirSpeed)));
            }

            MotionVector.Write(a, MotionVector.Velocity, i, near.Acceleration);
            MotionVector.Write(a, MotionVector.Spin, i, near.SpinAcceleration);
            a[(MotionVector.AirDistance * MotionVector.Size) + i] = near.AirSpeed;
        }

        if (taken && local.Motion == MotionState.Sliding)
        {
            AddFriction(local, time, in at, a);
        }
        else if (taken && local.Nets != 0 && local.Motion == MotionState.Airborne)
        {
            local.NetPush.Add(in at, in soon, a);
        }
    }

    private static void Difference<TAir>(LocalMotion<TAir> local, double time, in Motion at, int index, double width, bool taken, in Vector3d direction, out MotionRates quotient)
        where TAir : struct, IAir
    {
        Rates(local, time, MotionVector.Changed(in at, index, width), taken, in direction, out MotionRates high);
        Rates(local, time, MotionVector.Changed(in at, index, -width), taken, in direction, out MotionRates low);
        double perWidth = 0.5 / width;
        quotient = new MotionRates(
            perWidth * (high.Acceleration - low.Acceleration), perWidth * (high.SpinAcceleration - low.SpinAcceleration), perWidth * (high.AirSpeed - low.AirSpeed));
    }

    private static void Rates<TAir>(LocalMotion<TAir> local, double time, in Motion at, bool taken, in Vector3d direction, out MotionRates rates)
        where TAir : struct, IAir
    {
        if (taken)
        {
            local.SmoothRates(time, in at, in direction, out rates);
        }
        else
        {
            local.Rates(time, in at, out rates);
        }
    }

    /// <summary>How the friction of a slide turns with the slip.</summary>
    private static void AddFriction<TAir>(LocalMotion<TAir> local, double time, in Motion at, double[] a)
        where TAir : struct, IAir
    {
        double size = local.FrictionAt(time, in at);
        double slip = SlipShare * local.SpeedOnSurface(time, in at);
        for (int i = local.DependsOnPlace ? 0 : MotionVector.Velocity; i < MotionVector.AirDistance; i++)
        {
            double width = Math.Max(Least, i < MotionVector.Velocity ? Math.Min(slip, MotionVector.Width(in at, i)) : slip);
            Vector3d near = Turn(local, time, in at, i, width);
            Vector3d far = Turn(local, time, in at, i, 2.0 * width);
            MotionRates rates = local.Friction(time, in at, size, near + ((1.0 / 3.0) * (near - far)));
            MotionVector.Add(a, MotionVector.Velocity, i, rates.Acceleration);
            MotionVector.Add(a, MotionVector.Spin, i, rates.SpinAcceleration);
        }
    }

    /// <summary>How the direction of the slip turns with one number of the motion.</summary>
    private static Vector3d Turn<TAir>(LocalMotion<TAir> local, double time, in Motion at, int index, double width)
        where TAir : struct, IAir
    {
        Vector3d high = local.SlipDirection(time, MotionVector.Changed(in at, index, width));
        Vector3d low = local.SlipDirection(time, MotionVector.Changed(in at, index, -width));
        return (0.5 / width) * (high - low);
    }
}
