namespace FootballPhysics.Labs.Derivatives;

/// <summary>The scenes and launches of the flights whose derivatives are compared.</summary>
internal static class DerivativesScenes
{
    public static Scene Of(DerivativesKind kind) => kind switch
    {
        DerivativesKind.Published => Scene.Published with { Air = new Air { Wind = new Vector3d(1, 0, -2) } },
        DerivativesKind.Measured => Scene.Measured with { Air = new Air { Wind = new Vector3d(1, 0, -2) } },
        DerivativesKind.Goal => Scene.Measured with { Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1), Surface = SurfaceMaterial.GoalFrame }] },
        DerivativesKind.Slope => Scene.Published with
        {
            Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { TangentialRestitution = 0.5 }, Normal = new Vector3d(0.02, 1, 0.01) },
            Obstacles =
            [
                new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -14), new Vector3d(0, 0, 1)), Surface = SurfaceMaterial.PublishedGoalFrame },
                new Obstacle { Name = "player", Shape = new CapsuleShape(new Vector3d(-2, 0, -8), new Vector3d(-2, 1.6, -8), 0.25), Surface = SurfaceMaterial.PublishedGoalFrame, Velocity = new Vector3d(2, 0, 0) },
            ],
        },
        DerivativesKind.Hills => Scene.Measured with { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Heights = LabMath.Hills(-60, -60, 4, 31, (i, j) => 0.15 * Math.Sin(0.9 * i) * Math.Cos(0.7 * j)) } },
        _ => throw new ArgumentOutOfRangeException(nameof(kind)),
    };

    /// <summary>Draws a launch from the ground, or just above it.</summary>
    public static (Vector3d Position, Vector3d Velocity, Vector3d Spin) Launch(DerivativesKind kind, SeededRandom random)
    {
        Vector3d spin = random.Uniform(3, 60) * random.Direction();
        if (kind is DerivativesKind.Published or DerivativesKind.Measured)
        {
            return (new Vector3d(0, 0.11, 0), random.Velocity(5, 32, 3, 50), spin);
        }

        // Aim at the goal, the wall or the player.
        double speed = random.Uniform(8, 30);
        var target = new Vector3d(random.Uniform(-4.2, 4.2), random.Uniform(0, 2.7), kind == DerivativesKind.Slope ? -8 : -12);
        var from = new Vector3d(0, 0.5, 0);
        Vector3d way = target - from;
        double time = way.Length / speed;
        return (from, (way / time) + new Vector3d(0, 4.9 * time, 0), spin);
    }
}

/// <summary>The kinds of flights whose derivatives are compared.</summary>
internal enum DerivativesKind
{
    /// <summary>Air and level ground; the published profile.</summary>
    Published,

    /// <summary>Air and level ground; the measured profile.</summary>
    Measured,

    /// <summary>A goal with posts, bar and nets; the measured profile.</summary>
    Goal,

    /// <summary>A slope with standing and moving objects; the published profile.</summary>
    Slope,

    /// <summary>Hills; the measured profile.</summary>
    Hills,
}
