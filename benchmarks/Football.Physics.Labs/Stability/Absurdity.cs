namespace FootballPhysics.Labs.Stability;

/// <summary>Measures by how many decades a scene lies outside the numbers of ordinary balls, grounds and kicks.</summary>
internal static class Absurdity
{
    public static double Of(StressScene scene)
    {
        BallProperties ball = scene.Scene.Ball;
        Air air = scene.Scene.Air;
        Ground ground = scene.Scene.Ground;
        ForceSet forces = scene.Scene.Forces;
        SolverSettings settings = scene.Settings;
        double decades = Outside(ball.Mass, 0.05, 5) + Outside(ball.Radius, 0.05, 0.3) + Outside(ball.InertiaFactor, 0.3, 1)
            + Outside(scene.Scene.Gravity, 1, 30)
            + Outside(air.Density, 0.5, 2) + Outside(air.KinematicViscosity, 1e-5, 3e-5) + Outside(air.Wind.Length, 1e-6, 30)
            + Outside(scene.Velocity.Length, 1e-3, 60) + Outside(scene.Spin.Length, 1e-3, 200)
            + (scene.HasOwnForces ? 2 : 0)
            + (settings.Integrator != Integrator.Rk4 ? 0.5 : 0)
            + (settings.CollisionTiming == CollisionTiming.Bisection ? 0.5 + Outside(settings.CollisionTolerance, 1e-9, 1e-3) : 0);
        decades += forces.Drag == ForceLaw.Constant ? Outside(forces.DragCoefficient, 0.01, 2) : 0;
        decades += forces.Magnus == ForceLaw.Constant ? Outside(forces.MagnusCoefficient, 0.01, 2) : 0;
        decades += forces.SpinDecay == ForceLaw.Constant ? Outside(forces.SpinDecayCoefficient, 1e-6, 1e-2) : 0;
        decades += 0.2 * (Outside(ground.Height, 1e-9, 1e4) + Outside(scene.Position.Length, 1e-9, 1e4));
        decades += 0.3 * (Outside(ground.Material.SlidingFriction, 0.01, 2) + Outside(ground.Material.RollingResistance, 0.001, 1) + Outside(ground.MinimumBounceSpeed, 0.001, 1));
        return decades;
    }

    /// <summary>Returns the decades by which a value lies outside a range; 0 is always ordinary.</summary>
    public static double Outside(double value, double low, double high)
    {
        double size = Math.Abs(value);
        return size == 0 ? 0 : size < low ? Math.Log10(low / size) : size > high ? Math.Log10(size / high) : 0;
    }
}
