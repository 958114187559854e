namespace Football.Physics;

/// <summary>Gravity, F_G = −m g ŷ.</summary>
internal static class Gravity
{
    /// <summary>Upward acceleration, m/s².</summary>
    public static double Acceleration(Scene scene) => -scene.Gravity;
}
