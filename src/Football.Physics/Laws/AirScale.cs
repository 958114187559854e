namespace FootballPhysics.Laws;

/// <summary>The common factor of drag and Magnus force.</summary>
internal static class AirScale
{
    /// <summary>Returns ½ ρ A / m with A = π r², in 1/m.</summary>
    public static double DynamicArea(Scene scene) =>
        0.5 * scene.Air.Density * Math.PI * scene.Ball.Radius * scene.Ball.Radius / scene.Ball.Mass;
}
