using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The air for a spin vector: what any motion but plain flight asks.</summary>
internal static class AirRates
{
    /// <summary>Below this, rad/s, there is no spin: a reciprocal of it would overflow.</summary>
    private const double NoSpin = 1e-100;

    /// <summary>The factors of a = Lift (ω × u) − Drag u + Side, ω̇ = −Decay ω.</summary>
    /// <param name="air">The air.</param>
    /// <param name="time">When, s.</param>
    /// <param name="position">Where, m.</param>
    /// <param name="u">Velocity relative to the air, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="branch">Branch of the drag law.</param>
    /// <param name="factors">Lift without unit, decay in 1/s; without spin the angular deceleration itself, rad/s².</param>
    /// <returns>|ω|.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Factors<TAir>(
        ref TAir air, double time, in Vector3d position, in Vector3d u, in Vector3d spin, DragBranch branch, out AirFactors factors)
        where TAir : struct, IAir
    {
        double rate = Math.Sqrt((spin.X * spin.X) + (spin.Y * spin.Y) + (spin.Z * spin.Z));
        rate = rate > NoSpin ? rate : 0;
        factors = default;
        if (air.Drags || air.Lifts || air.SpinDecays || air.Varies)
        {
            AirFlow flow = default;
            flow.SpeedSquared = (u.X * u.X) + (u.Y * u.Y) + (u.Z * u.Z);
            flow.SpinRate = rate;
            double perRate = rate > 0 ? 1.0 / rate : 0;
            flow.AlongSpin = perRate * Vector3d.Dot(in spin, in u);
            if (air.Varies)
            {
                flow.Position = position;
                flow.Time = time;
            }

            air.Evaluate(in flow, branch, out factors);
            if (rate > 0)
            {
                factors.Lift *= perRate;
                factors.Decay *= perRate;
            }
        }

        return rate;
    }
}
