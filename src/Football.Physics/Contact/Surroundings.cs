namespace Football.Physics;

/// <summary>What acts on a ball wherever it is: the constants of a scene, shared by all phases of a step.</summary>
internal sealed class Surroundings<TAir>
    where TAir : struct, IAir
{
    /// <summary>The air. Not readonly: a call through a type parameter would copy it first.</summary>
    public TAir Air;

    /// <summary>Whether the air acts at all.</summary>
    public readonly bool AirActs;

    /// <summary>The ground's forces.</summary>
    public readonly GroundForces Ground;

    /// <summary>Wind, m/s.</summary>
    public readonly Vector3d Wind;

    /// <summary>Whether the air pushes a ball on the ground.</summary>
    public readonly bool AirActsOnGround;

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public readonly double Upward;

    /// <summary>Ball radius, m.</summary>
    public readonly double Radius;

    /// <summary>Its square, m².</summary>
    public readonly double RadiusSquared;

    /// <summary>All that can be met where there is more than a level pitch; else null.</summary>
    public readonly World? World;

    /// <summary>Height of the centre of a ball on the level pitch, m; −∞ where there is none, or where the ground is one of many things.</summary>
    public readonly double ContactHeight;

    /// <summary>Height of the centre of a ball on level ground, whatever else there is, m; −∞ where there is no level ground.</summary>
    public readonly double LevelContact;

    public Surroundings(Scene scene, in TAir air)
    {
        Air = air;
        AirActs = Air.Drags || Air.Lifts || Air.SpinDecays || Air.Varies;
        Ground = GroundForces.Of(scene);
        Wind = scene.Air.Wind;
        AirActsOnGround = scene.Ground.Aerodynamics != GroundAerodynamics.None;
        World = World.Of(scene);
        Upward = Weight.UpwardAcceleration(scene);
        Radius = scene.Ball.Radius;
        RadiusSquared = scene.Ball.Radius * scene.Ball.Radius;
        ContactHeight = World is null ? scene.Ground.Height + scene.Ball.Radius : double.NegativeInfinity;
        LevelContact = World?.LevelContact ?? ContactHeight;
    }
}
