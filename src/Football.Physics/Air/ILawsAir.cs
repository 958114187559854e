namespace Football.Physics;

/// <summary>An air that is made of laws alone, whose constants are a scene's.</summary>
internal interface ILawsAir : IAir
{
    /// <summary>Reads the constants of all laws from the scene.</summary>
    void Prepare(Scene scene);
}
