namespace Football.Physics;

/// <summary>Buoyancy, F_B = +4/3 π r³ ρ g ŷ: the weight of the air displaced (thesis 2.2).</summary>
internal static class Buoyancy
{
    /// <summary>Upward acceleration, m/s².</summary>
    public static double Acceleration(Scene scene)
    {
        double r = scene.Ball.Radius;

        // F_B / m = 4/3 π r³ ρ g / m
        return scene.Forces.Buoyancy
            ? 4.0 / 3.0 * Math.PI * r * r * r * scene.Air.Density * scene.Gravity / scene.Ball.Mass
            : 0;
    }
}
