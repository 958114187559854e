using Football.Physics.Yardsticks;

namespace Football.Physics.Tests.Laws;

/// <summary>Forces and torques by the yardsticks' laws, plainly and slowly: what the library's are compared with.</summary>
internal static class PlainLaws
{
    public const double CriticalSpeed = FittedLaws.CriticalSpeed;
    public const double CriticalSpin = FittedLaws.CriticalSpin;

    public static double WithoutSpin(double speed) => FittedLaws.WithoutSpin(speed);

    public static double Published(double speed, double sp) => FittedLaws.Published(speed, sp);

    public static double Regularised(double speed, double sp) => FittedLaws.Regularised(speed, sp);

    public static double Lift(double dragCoefficient, double sp) => FittedLaws.Lift(dragCoefficient, sp);

    /// <summary>F_D = −½ ρ C_D A |u| u.</summary>
    public static Vector3d Drag(Scene scene, double coefficient, Vector3d u)
    {
        double area = Math.PI * scene.Ball.Radius * scene.Ball.Radius;
        return -0.5 * scene.Air.Density * coefficient * area * Size(u) * u;
    }

    /// <summary>F_M = ½ ρ C_L A |u|² (ω̂ × û).</summary>
    public static Vector3d Magnus(Scene scene, double coefficient, Vector3d u, Vector3d w)
    {
        double area = Math.PI * scene.Ball.Radius * scene.Ball.Radius;
        return 0.5 * scene.Air.Density * coefficient * area * Size(u) * Size(u) * Vector3d.Cross(w / Size(w), u / Size(u));
    }

    /// <summary>F_M = C_M π ρ r³ (ω × u).</summary>
    public static Vector3d ConstantMagnus(Scene scene, double coefficient, Vector3d u, Vector3d w) =>
        coefficient * Math.PI * scene.Air.Density * Math.Pow(scene.Ball.Radius, 3) * Vector3d.Cross(w, u);

    /// <summary>|T_D| = (r/2) ρ π r² (U₊² C₊ + U₋² C₋).</summary>
    public static double DecayTorque(Scene scene, double speed, double spin)
    {
        double r = scene.Ball.Radius;
        return r / 2 * scene.Air.Density * Math.PI * r * r * (Plate(scene, speed + (r * spin / 2)) + Plate(scene, Math.Abs(speed - (r * spin / 2))));
    }

    private static double Plate(Scene scene, double u) => FittedLaws.Plate(u, 2 * scene.Ball.Radius / scene.Air.KinematicViscosity);

    private static double Size(Vector3d v) => Math.Sqrt((v.X * v.X) + (v.Y * v.Y) + (v.Z * v.Z));
}
