namespace FootballPhysics.Labs.Obstacles;

/// <summary>Drops on a board in vacuum.</summary>
internal static class BoardDrops
{
    private const double Radius = 0.11;

    /// <summary>Returns the least and the greatest measured restitution.</summary>
    /// <param name="step">The time step, s.</param>
    /// <param name="drops">The number of heights.</param>
    public static (double Least, double Greatest) Measure(double step, int drops)
    {
        var board = new Obstacle { Shape = new BoxShape(new Vector3d(0, 1, 0), new Vector3d(1, 0.1, 1)), Surface = SurfaceMaterial.PublishedGoalFrame with { NormalRestitution = 0.6 } };
        var simulator = new Simulator(Scene.Vacuum with { Obstacles = [board], Ground = Ground.None });
        double least = double.PositiveInfinity;
        double greatest = 0;
        for (int i = 0; i <= drops; i++)
        {
            double height = 0.5 + ((double)i / drops);
            BallState state = simulator.Launch(new Vector3d(0, 1.1 + Radius + height, 0), Vector3d.Zero, Vector3d.Zero);
            var path = new Trajectory();
            simulator.LookAhead(in state, new LookAheadRequest { Duration = 1, TimeStep = step, StopAt = StopAt.Impact }, path);
            simulator.LookAhead(path.Final, new LookAheadRequest { Duration = 1, TimeStep = step, StopAt = StopAt.Impact }, path);
            double restitution = Math.Sqrt((path.Apex - 1.1 - Radius) / height);
            least = Math.Min(least, restitution);
            greatest = Math.Max(greatest, restitution);
        }

        return (least, greatest);
    }
}
