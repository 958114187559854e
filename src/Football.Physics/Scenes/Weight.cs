namespace FootballPhysics.Scenes;

/// <summary>The sum of gravity and buoyancy: the same at every point and for every motion of the ball.</summary>
internal static class Weight
{
    /// <summary>Returns the upward acceleration, in m/s²; negative if the ball is heavier than the displaced air.</summary>
    public static double UpwardAcceleration(Scene scene) => Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);

    /// <summary>Returns the acceleration, in m/s². Buoyancy opposes gravity, even if gravity is not straight down.</summary>
    public static Vector3d Of(Scene scene)
    {
        Vector3d sideways = Sideways(scene);
        return new Vector3d(sideways.X, UpwardAcceleration(scene), sideways.Z);
    }

    /// <summary>Returns the horizontal part of this acceleration, in m/s²; zero unless gravity is tilted.</summary>
    public static Vector3d Sideways(Scene scene)
    {
        double share = 1.0 - (scene.Forces.Buoyancy ? Buoyancy.DisplacedMass(scene.Ball, scene.Air) / scene.Ball.Mass : 0);
        return share * scene.Sideways;
    }
}

/// <summary>Gravity, F_G = −m g ŷ.</summary>
internal static class Gravity
{
    /// <summary>Returns the upward acceleration, in m/s².</summary>
    public static double Acceleration(Scene scene) => -scene.Gravity;
}

/// <summary>Buoyancy, F_B = +4/3 π r³ ρ g ŷ: the weight of the air displaced (thesis 2.2).</summary>
internal static class Buoyancy
{
    /// <summary>Returns the upward acceleration, in m/s².</summary>
    public static double Acceleration(Scene scene) =>
        scene.Forces.Buoyancy ? DisplacedMass(scene.Ball, scene.Air) * scene.Gravity / scene.Ball.Mass : 0;

    /// <summary>Returns the force on the ball, opposite to gravity in any direction, in N.</summary>
    public static Vector3d Force(Scene scene) =>
        scene.Forces.Buoyancy ? -DisplacedMass(scene.Ball, scene.Air) * scene.GravityVector : Vector3d.Zero;

    /// <summary>Returns the mass of the air that a ball displaces, 4/3 π r³ ρ, in kg.</summary>
    public static double DisplacedMass(BallProperties ball, Air air) => 4.0 / 3.0 * Math.PI * ball.Radius * ball.Radius * ball.Radius * air.Density;
}
