using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>The forces on a ball anywhere in the scene: constants shared by all phases of a step.</summary>
internal sealed class Surroundings
{
    /// <summary>The air. Not readonly: a call through a type parameter would copy it first.</summary>
    public SceneAir Air;

    /// <summary>True if air forces act.</summary>
    public readonly bool AirActs;

    /// <summary>Wind, m/s.</summary>
    public readonly Vector3d Wind;

    /// <summary>Acceleration by gravity and buoyancy, m/s²; straight down unless the world is tilted.</summary>
    public readonly Vector3d Weight;

    /// <summary>Its upward part, m/s².</summary>
    public readonly double Upward;

    /// <summary>Ball radius, m.</summary>
    public readonly double Radius;

    /// <summary>Its square, m².</summary>
    public readonly double RadiusSquared;

    /// <summary>The colliders, nets and goals of the scene.</summary>
    public readonly World World;

    /// <summary>Returns the branch of the drag law for a motion; unknown if the law does not jump.</summary>
    public DragBranch BranchAt(in Motion at) => DragJump.BranchAt(Air.Jumps, (at.Velocity - Wind).LengthSquared, RadiusSquared * at.Spin.LengthSquared);

    public Surroundings(Scene scene, in SceneAir air)
    {
        Air = air;
        AirActs = Air.Drags || Air.Lifts || Air.SpinDecays || Air.Varies;
        Wind = scene.Air.Wind;
        World = new World(scene);
        Weight = Scenes.Weight.Of(scene);
        Upward = Weight.Y;
        Radius = scene.Ball.Radius;
        RadiusSquared = scene.Ball.Radius * scene.Ball.Radius;
    }
}
