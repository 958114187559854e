namespace Football.Physics;

/// <summary>What gravity and buoyancy come to together: they are the same everywhere, whatever the ball does.</summary>
internal static class Weight
{
    /// <summary>Upward acceleration, m/s²; negative for what is heavier than air.</summary>
    public static double UpwardAcceleration(Scene scene) => Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
}
