namespace FootballPhysics;

/// <summary>Sum of gravity and buoyancy, equal everywhere, whatever the ball does.</summary>
internal static class Weight
{
    /// <summary>Upward acceleration, m/s²; negative for what is heavier than air.</summary>
    public static double UpwardAcceleration(Scene scene) => Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);

    /// <summary>Acceleration, m/s². Buoyancy is opposite to gravity, also where that is not straight down.</summary>
    public static Vector3d Of(Scene scene)
    {
        double share = 1.0 - (scene.Forces.Buoyancy ? Buoyancy.DisplacedMass(scene.Ball, scene.Air) / scene.Ball.Mass : 0);
        return new Vector3d(share * scene.Sideways.X, UpwardAcceleration(scene), share * scene.Sideways.Z);
    }
}

/// <summary>Gravity, F_G = −m g ŷ.</summary>
internal static class Gravity
{
    /// <summary>Upward acceleration, m/s².</summary>
    public static double Acceleration(Scene scene) => -scene.Gravity;
}

/// <summary>Buoyancy, F_B = +4/3 π r³ ρ g ŷ: the weight of the air displaced (thesis 2.2).</summary>
internal static class Buoyancy
{
    /// <summary>Upward acceleration, m/s².</summary>
    public static double Acceleration(Scene scene) =>
        scene.Forces.Buoyancy ? DisplacedMass(scene.Ball, scene.Air) * scene.Gravity / scene.Ball.Mass : 0;

    /// <summary>The force on the ball, N: opposite to gravity, also if that is not straight down.</summary>
    public static Vector3d Force(Scene scene) =>
        scene.Forces.Buoyancy ? -DisplacedMass(scene.Ball, scene.Air) * scene.GravityVector : Vector3d.Zero;

    /// <summary>Mass of the air that a ball displaces, 4/3 π r³ ρ, kg.</summary>
    public static double DisplacedMass(BallProperties ball, Air air) => 4.0 / 3.0 * Math.PI * ball.Radius * ball.Radius * ball.Radius * air.Density;
}
