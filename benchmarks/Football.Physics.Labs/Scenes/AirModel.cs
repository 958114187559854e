namespace FootballPhysics.Labs.Scenes;

/// <summary>The measured laws of the air for the generic ball, as documented: drag, lift and the torque on a ball.</summary>
/// <param name="Density">Density of the air, kg/m³.</param>
/// <param name="Viscosity">Kinematic viscosity, m²/s.</param>
/// <param name="Wind">Wind, m/s.</param>
internal sealed record AirModel(double Density, double Viscosity, Vector3d Wind)
{
    private const double Radius = 0.11;
    private const double Mass = 0.43;
    private const double Inertia = 2.0 / 3 * Mass * Radius * Radius;
    private const double Area = Math.PI * Radius * Radius;

    /// <summary>The buoyancy, as an acceleration per m/s² of gravity.</summary>
    public double Lifts => 4.0 / 3 * Math.PI * Radius * Radius * Radius * Density / Mass;

    /// <summary>Returns force over mass, m/s², and torque, N m.</summary>
    public (Vector3d Acceleration, Vector3d Torque) Act(in Vector3d velocity, in Vector3d spin)
    {
        Vector3d u = velocity - Wind;
        double speed = u.Length;
        if (Density == 0 || speed < 1e-9)
        {
            return (default, -0.004 * Density / 1.2 * Inertia * spin);
        }

        double reynolds = 2 * Radius * speed / Viscosity;
        double across = Vector3d.Cross(spin, u).Length / speed;
        double s = Radius * across / speed;
        double slow = 1 / (1 + Math.Exp((reynolds - 186_000) / 17_000));
        double rise = (reynolds - 230_000) / (1 + Math.Exp(-(reynolds - 230_000) / 17_000)) * (0.185 - 0.155) / (510_000 - 230_000);
        double drag = ((0.49 - 0.155) * slow) + 0.155 + rise + (0.30 * s / Math.Sqrt((s * s) + (0.577 * 0.577)) * (1 - (0.5 * slow)));
        Vector3d lift = 0.5 * Density * Area * 0.32 * (1 - (0.6 * slow)) * Radius * speed
            / Math.Sqrt((Radius * Radius * across * across) + (0.14 * 0.14 * speed * speed)) * Vector3d.Cross(spin, u);
        Vector3d force = (-0.5 * Density * Area * drag * speed * u) + lift;
        return (force / Mass, -((0.0096 * Math.PI * Density * Math.Pow(Radius, 4) * speed) + (0.004 * Density / 1.2 * Inertia)) * spin);
    }
}
