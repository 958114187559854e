namespace FootballPhysics;

/// <summary>The scale that drag and Magnus force have in common.</summary>
internal static class AirScale
{
    /// <summary>½ ρ A / m with A = π r², 1/m.</summary>
    public static double DynamicArea(Scene scene) =>
        0.5 * scene.Air.Density * Math.PI * scene.Ball.Radius * scene.Ball.Radius / scene.Ball.Mass;
}
