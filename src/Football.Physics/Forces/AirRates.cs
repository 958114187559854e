namespace Football.Physics;

/// <summary>Aerodynamic accelerations for a spin vector: what the general systems share.</summary>
internal static class AirRates
{
    /// <summary>Accelerations of drag, Magnus force and spin decay.</summary>
    /// <param name="air">The laws.</param>
    /// <param name="u">Velocity relative to the air, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="fallback">Direction that a spin of zero is about to take, or zero: the decay acts against it.</param>
    /// <param name="branch">Branch of the drag law.</param>
    public static MotionRates Of<TAir>(ref TAir air, in Vector3d u, in Vector3d spin, in Vector3d fallback, DragBranch branch)
        where TAir : struct, IAerodynamics
    {
        double rate = spin.Length;
        air.Begin(rate, branch, out AirStep step);
        air.Evaluate(in step, u.LengthSquared, rate, out double drag, out double lift, out double decay);
        Vector3d axis = rate > 0 ? spin / rate : fallback;
        Vector3d acceleration = air.Lifts ? lift * Vector3d.Cross(in axis, in u) : Vector3d.Zero;
        return new MotionRates(acceleration - (drag * u), -decay * axis);
    }
}
