using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Stability;

/// <summary>Scenes of the stress matrix with the measured laws: one of the balls, and ground with impact friction, drilling friction and the complete air force.</summary>
internal static class MeasuredStress
{
    /// <summary>The drag curves, by the names that scenarios use for their balls.</summary>
    public static IReadOnlyList<(string Type, DragCurve Curve)> Curves { get; } =
    [
        ("generic", DragCurve.Generic), ("tango12", DragCurve.Tango12), ("teamgeist", DragCurve.Teamgeist), ("jabulani", DragCurve.Jabulani),
        ("brazuca", DragCurve.Brazuca),
    ];

    /// <summary>Returns the same shot in a scene of the measured profile.</summary>
    public static StressScene Of(StressScene scene, long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, ~index));
        Ground ground = scene.Scene.Ground;
        if (scene.Kind != StressKind.ComesToRest)
        {
            // If rest is guaranteed, keep the numbers that the guarantee depends on.
            ground = ground with
            {
                Material = ground.Material with
                {
                    RestitutionSpeedScale = random.Any(30, double.PositiveInfinity, random.Log(0.1, 1000)),
                    ImpactFriction = random.Any(0, double.PositiveInfinity, random.Log(0.01, 3)),
                    RollingResistancePerSpeed = random.Any(0, random.Log(1e-4, 0.1)),
                    TorsionalPatchRadius = random.Any(0, random.Log(1e-4, 0.1)),
                },
                Aerodynamics = GroundAerodynamics.Full,
                TangentialRestitutionZ = null,
            };
        }

        return scene with
        {
            Scene = scene.Scene with
            {
                Ball = scene.Scene.Ball with { DragCurve = Curves[random.Below(Curves.Count)].Curve },
                Forces = scene.Scene.Forces with { Coefficients = AerodynamicModel.Measured },
                Ground = ground,
            },
        };
    }
}
