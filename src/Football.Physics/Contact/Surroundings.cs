namespace FootballPhysics;

/// <summary>Forces on a ball wherever it is: the constants of a scene, shared by all phases of a step.</summary>
internal sealed class Surroundings
{
    /// <summary>The air. Not readonly: a call through a type parameter would copy it first.</summary>
    public SceneAir Air;

    /// <summary>True when the air acts at all.</summary>
    public readonly bool AirActs;

    /// <summary>Wind, m/s.</summary>
    public readonly Vector3d Wind;

    /// <summary>Acceleration by gravity and buoyancy, m/s²; straight down, but in a tilted world.</summary>
    public readonly Vector3d Weight;

    /// <summary>Its upward part, m/s².</summary>
    public readonly double Upward;

    /// <summary>Ball radius, m.</summary>
    public readonly double Radius;

    /// <summary>Its square, m².</summary>
    public readonly double RadiusSquared;

    /// <summary>All that can be met.</summary>
    public readonly World World;

    public Surroundings(Scene scene, in SceneAir air)
    {
        Air = air;
        AirActs = Air.Drags || Air.Lifts || Air.SpinDecays || Air.Varies;
        Wind = scene.Air.Wind;
        World = new World(scene);
        Weight = FootballPhysics.Weight.Of(scene);
        Upward = Weight.Y;
        Radius = scene.Ball.Radius;
        RadiusSquared = scene.Ball.Radius * scene.Ball.Radius;
    }
}
