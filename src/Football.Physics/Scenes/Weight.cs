namespace Football.Physics;

/// <summary>What gravity and buoyancy come to together: they are the same everywhere, whatever the ball does.</summary>
internal static class Weight
{
    /// <summary>Upward acceleration, m/s²; negative for what is heavier than air.</summary>
    public static double UpwardAcceleration(Scene scene) => Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
}

/// <summary>Gravity, F_G = −m g ŷ.</summary>
internal static class Gravity
{
    /// <summary>Upward acceleration, m/s².</summary>
    public static double Acceleration(Scene scene) => -scene.Gravity;
}

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
