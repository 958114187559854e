namespace Football.Physics;

/// <summary>What acts on a ball wherever it is: shared by the motion systems, so that a system is a small value.</summary>
internal sealed class Surroundings<TAir>
    where TAir : struct, IAerodynamics
{
    /// <summary>The aerodynamic laws. Not readonly: a call through a type parameter would copy them first.</summary>
    public TAir Air;

    /// <summary>The game's own forces.</summary>
    public readonly CustomForces Custom;

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

    public Surroundings(Scene scene, in TAir air)
    {
        Air = air;
        Custom = new CustomForces(scene);
        Ground = GroundForces.Of(scene);
        Wind = scene.Air.Wind;
        AirActsOnGround = scene.Ground.Aerodynamics == GroundAerodynamics.Horizontal;
        Upward = Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
        Radius = scene.Ball.Radius;
    }
}
