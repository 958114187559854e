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

    /// <summary>The same without air: no buoyancy, drag, Magnus force or spin decay.</summary>
    public static Scene Vacuum { get; } = new() { Forces = ForceSet.None };

    /// <summary>A stadium at 2 240 m (Mexico City): air of 0.96 kg/m³, kinematic viscosity 1.87e-5 m²/s.</summary>
    public static Scene HighAltitude { get; } = new() { Air = new Air { Density = 0.96, KinematicViscosity = 1.87e-5 } };

    /// <summary>Default scene with a steady wind.</summary>
    /// <param name="wind">Wind velocity, m/s.</param>
    public static Scene Windy(Vector3d wind) => new() { Air = new Air { Wind = wind } };

    /// <summary>Checks every number of the scene.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException">A part is null; the message names it.</exception>
    public void Validate()
    {
        Check.Given("ball", Ball);
        Check.Given("air", Air);
        Check.Given("forces", Forces);
        Check.Given("ground", Ground);
        Check.Positive("ball.mass", Ball.Mass);
        Check.Within("ball.radius", Ball.Radius, 0, Limits.Length, exclusiveLow: true);
        Check.Within("ball.inertiaFactor", Ball.InertiaFactor, 0, 1, exclusiveLow: true);
        Check.NotNegative("air.density", Air.Density);
        Check.Positive("air.kinematicViscosity", Air.KinematicViscosity);
        Check.Size("air.wind", Air.Wind, Limits.Speed, "m/s");
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
