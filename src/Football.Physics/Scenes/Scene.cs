namespace Football.Physics;

/// <summary>Everything a flight depends on but the kick: ball, air, gravity, forces, ground. Built once; immutable.</summary>
public sealed record Scene
{
    /// <summary>The ball. Default <see cref="BallProperties.Football"/>.</summary>
    public BallProperties Ball { get; init; } = BallProperties.Football;

    /// <summary>The air. Default still air at sea level.</summary>
    public Air Air { get; init; } = new();

    /// <summary>Gravitational acceleration g, m/s². Not negative; default 9.81.</summary>
    public double Gravity { get; init; } = 9.81;

    /// <summary>Which forces act, and by which law. Default all of them, as published.</summary>
    public ForceSet Forces { get; init; } = new();

    /// <summary>The ground. Default <see cref="Ground.Turf"/>.</summary>
    public Ground Ground { get; init; } = Ground.Turf;

    /// <summary>A football over turf in still air at sea level, with all forces.</summary>
    public static Scene Default { get; } = new();

    /// <summary>The same by the laws and numbers of the thesis, as published.</summary>
    public static Scene Published => Default;

    /// <summary>The same by the measured laws of the air.</summary>
    public static Scene Measured { get; } = new() { Forces = ForceSet.Measured };

    /// <summary>The same without air: no buoyancy, drag, Magnus force or spin decay.</summary>
    public static Scene Vacuum { get; } = new() { Forces = ForceSet.None };

    /// <summary>A stadium at 2 240 m (Mexico City) at 20 °C and 40 % humidity: air of 0.913 kg/m³, kinematic viscosity 1.99e-5 m²/s.</summary>
    public static Scene HighAltitude { get; } = new() { Air = Weather.AtAltitude(2240, 20, 0.4).ToAir() };

    /// <summary>Default scene with a steady wind.</summary>
    /// <param name="wind">Wind velocity, m/s.</param>
    public static Scene Windy(Vector3d wind) => new() { Air = new Air { Wind = wind } };

    /// <summary>Checks every number of the scene.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public void Validate()
    {
        Ball.Validate();
        Air.Validate();
        Check.NotNegative("gravity", Gravity);
        Forces.Validate();
        Check.Within("ground.normalRestitution", Ground.NormalRestitution, 0, 1);
        Check.Within("ground.tangentialRestitution[0]", Ground.TangentialRestitutionX, -1, 1);
        Check.Within("ground.tangentialRestitution[1]", Ground.TangentialRestitutionZ, -1, 1);
        Check.Within("ground.spinRestitution", Ground.SpinRestitution, 0, 1);
        Check.NotNegative("ground.slidingFriction", Ground.SlidingFriction);
        Check.NotNegative("ground.rollingFriction", Ground.RollingFriction);
        Check.NotNegative("ground.spinDamping", Ground.SpinDamping);
        Check.AtLeast("ground.minimumBounceSpeed", Ground.MinimumBounceSpeed, 0.001);
        Check.Positive("ground.restEnergy", Ground.RestEnergy);
        Check.Within("ground.height", Ground.Height, -Limits.Length, Limits.Length);
        Check.Defined("ground.aerodynamics", Ground.Aerodynamics, (int)Ground.Aerodynamics, 2);
    }
}
