namespace FootballPhysics.Benchmarks;

/// <summary>The rows of the chance of a goal: by derivatives, and by the default number of simulated kicks.</summary>
internal static class GoalChanceRows
{
    /// <summary>The rows. The goal is 20 m away. The third kick goes to a corner, so that most kicks are near the frame.</summary>
    public static IReadOnlyList<TargetRow> All { get; } =
    [
        new("chance of a goal, spread of 0.5°, by derivatives (20 ms are to be reached), of a 3 s look-ahead of 80 ms", () => Chance(2.5, 1.2, 0.5), QueryRows.LookAhead),
        new("chance of a goal, spread of 3°, 2 000 kicks (20 ms are to be reached), of a 3 s look-ahead of 80 ms", () => Chance(2, 1, 3), QueryRows.LookAhead),
        new("the same, aimed at a lower corner", () => Chance(3.2, 0.4, 3), QueryRows.LookAhead),
    ];

    /// <summary>Returns the chance of a goal for a kick from 20 m at a point of the goal.</summary>
    public static Workload Chance(double aside, double height, double degrees)
    {
        var goal = new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };
        AimResult aim = new Aimer().Find(new AimRequest { From = Shot.Spot, Target = new Vector3d(aside, height, -20), Speed = 24 });
        var request = new GoalChanceRequest
        {
            Position = Shot.Spot,
            Velocity = aim.Velocity,
            Spin = aim.Spin,
            Spread = new KickSpread { SpeedPercent = 2 * degrees, ElevationDegrees = degrees, AzimuthDegrees = degrees },
            Goal = goal,
            Keeper = new Player { Position = new Vector3d(0, 0, -19.6), Reaction = 0.2, Acceleration = 6, Speed = 3, Reach = 1.9, MaximumHeight = 2.6 },
        };
        var chance = new GoalChance();
        return new Workload(() => chance.Find(request).Scores, 1);
    }
}
