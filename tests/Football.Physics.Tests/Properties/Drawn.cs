using CsCheck;

namespace FootballPhysics.Tests.Properties;

/// <summary>What the properties draw. CsCheck makes a failing draw smaller, and prints it with its seed: <c>CsCheck_Seed=… dotnet test</c> draws it again.</summary>
internal static class Drawn
{
    public static Gen<Vector3d> Direction { get; } = Gen.Select(Gen.Double[-1, 1], Gen.Double[0, 2 * Math.PI], (y, turn) =>
    {
        double across = Math.Sqrt(1 - (y * y));
        return new Vector3d(across * Math.Cos(turn), y, across * Math.Sin(turn));
    });

    public static Gen<BallProperties> Ball { get; } = Gen.Select(Gen.Double[0.05, 2], Gen.Double[0.03, 0.3], Gen.Double[0.3, 0.7], (mass, radius, inertia) =>
        new BallProperties { Mass = mass, Radius = radius, InertiaFactor = inertia });

    /// <summary>A surface that adds no energy; one in four has no limit of friction.</summary>
    public static Gen<SurfaceMaterial> Surface { get; } = Gen.Select(
        Gen.Double[0, 1], Gen.Double[-1, 1], Gen.Double[0, 1], Gen.Double[0, 2], Gen.Double[0, 1], Gen.Double[0, 0.03], Gen.Int[0, 3],
        (restitution, tangential, spin, friction, grazing, patch, grip) => SurfaceMaterial.GoalFrame with
        {
            NormalRestitution = restitution,
            TangentialRestitution = tangential,
            SpinRestitution = spin,
            ImpactFriction = grip == 0 ? double.PositiveInfinity : friction,
            SlidingFriction = friction,
            GrazingRestitutionGain = grazing,
            TorsionalPatchRadius = patch,
        });

    public static Gen<Vector3d> Vector(double most) => Gen.Select(Direction, Gen.Double[0, most], (direction, size) => size * direction);
}
