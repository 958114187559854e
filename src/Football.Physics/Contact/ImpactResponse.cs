namespace Football.Physics;

/// <summary>What an impact with the ground does: impulses with four coefficients of restitution (thesis 2.16 to 2.18).</summary>
internal static class ImpactResponse
{
    /// <summary>Velocity and spin just after an impact.</summary>
    public static void Apply(BallProperties ball, Ground ground, in Vector3d v, in Vector3d w, out Vector3d velocity, out Vector3d spin)
    {
        double alpha = ball.InertiaFactor;
        double r = ball.Radius;
        double ex = ground.TangentialRestitutionX;
        double ez = ground.TangentialRestitutionZ;
        double scale = 1.0 / (1.0 + alpha);

        // v_x' = ((1 − α e_x) v_x − α(1 + e_x) r ω_z)/(1 + α)      v_z' = ((1 − α e_z) v_z + α(1 + e_z) r ω_x)/(1 + α)
        // v_y' = −e_y v_y
        velocity = new Vector3d(
            scale * (((1.0 - (alpha * ex)) * v.X) - (alpha * (1.0 + ex) * r * w.Z)),
            -ground.NormalRestitution * v.Y,
            scale * (((1.0 - (alpha * ez)) * v.Z) + (alpha * (1.0 + ez) * r * w.X)));

        // ω_x' = ((α − e_z) ω_x + (1 + e_z) v_z/r)/(1 + α)      ω_z' = ((α − e_x) ω_z − (1 + e_x) v_x/r)/(1 + α)
        // ω_y' = e_ω ω_y
        spin = new Vector3d(
            scale * (((alpha - ez) * w.X) + ((1.0 + ez) * v.Z / r)),
            ground.SpinRestitution * w.Y,
            scale * (((alpha - ex) * w.Z) - ((1.0 + ex) * v.X / r)));
    }
}
