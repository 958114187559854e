namespace FootballPhysics.Tests.Laws;

/// <summary>
/// The aerodynamic laws written down once more, plainly and slowly, from the equations: what the library's are compared with. The numbers
/// are the library's, which <see cref="AirLawTests"/> holds to the published ones.
/// </summary>
internal static class PlainLaws
{
    public const double CriticalSpeed = FittedDrag.CriticalSpeed;
    public const double CriticalSpin = FittedDrag.CriticalSpin;

    public static double AtRest => WithoutSpin(0);

    public static double WithoutSpin(double speed) =>
        FittedDrag.A + (FittedDrag.B / (1 + Math.Exp((speed - CriticalSpeed) / FittedDrag.SpeedScale)));

    public static double WithSpin(double sp) => FittedDrag.C * Math.Pow(sp, FittedDrag.D);

    public static double Published(double speed, double sp) => speed > CriticalSpeed && sp > CriticalSpin ? WithSpin(sp) : WithoutSpin(speed);

    public static double Regularised(double speed, double sp)
    {
        double w = Sigma((speed - CriticalSpeed) / RegularisedDragFit.SpeedWidth) * Sigma((sp - CriticalSpin) / RegularisedDragFit.SpinWidth);
        return (w * WithSpin(sp)) + ((1 - w) * WithoutSpin(speed));
    }

    public static double Lift(double dragCoefficient, double sp) =>
        EmpiricalMagnus.Alpha * Math.Pow(sp, EmpiricalMagnus.Beta) * (AtRest - Math.Min(dragCoefficient, AtRest)) / (AtRest - FittedDrag.A);

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

    private static double Plate(Scene scene, double u) =>
        u == 0 ? 0 : u * u * EmpiricalSpinDecay.SkinFriction
        * Math.Pow(u * 2 * scene.Ball.Radius / scene.Air.KinematicViscosity, -(double)EmpiricalSpinDecay.ReynoldsExponent);

    private static double Sigma(double x) => 1 / (1 + Math.Exp(-x));

    private static double Size(Vector3d v) => Math.Sqrt((v.X * v.X) + (v.Y * v.Y) + (v.Z * v.Z));
}
