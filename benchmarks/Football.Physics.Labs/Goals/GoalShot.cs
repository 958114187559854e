namespace FootballPhysics.Labs.Goals;

/// <summary>A random shot at a goal, or past it, from within 25 m: in flight, bouncing or along the ground, at the frame, and off a keeper.</summary>
/// <param name="Goal">The goal.</param>
/// <param name="Simulator">The simulator of its scene.</param>
/// <param name="TimeStep">The time step, s.</param>
/// <param name="Start">The ball at the kick.</param>
internal sealed record GoalShot(Goal Goal, Simulator Simulator, double TimeStep, BallState Start)
{
    private const double Farthest = 25;

    /// <summary>Draws a shot.</summary>
    public static GoalShot Draw(SeededRandom random)
    {
        Vector3d facing = random.Heading();
        Vector3d right = Vector3d.Cross(facing, Vector3d.Up);
        var goal = new Goal
        {
            Center = new Vector3d(random.Uniform(-40, 40), 0, random.Uniform(-40, 40)),
            Facing = facing,
            Width = random.Chance(0.7) ? 7.32 : random.Uniform(2, 8),
            Height = random.Chance(0.7) ? 2.44 : random.Uniform(1.5, 3),
            PostRadius = random.Chance(0.7) ? 0.06 : random.Uniform(0.02, 0.1),
            HasNet = random.Chance(0.85),
            Surface = SurfaceMaterial.GoalFrame,
        };
        Vector3d Place(double aside, double height, double before) => goal.Center + (aside * right) + new Vector3d(0, height, 0) + (before * facing);

        // Half of the shots have a keeper near the line.
        double stands = random.Uniform(-0.5, 0.5) * goal.Width;
        double ahead = random.Uniform(0, 1.5);
        Obstacle[] people = random.Chance(0.5) ? [] :
        [
            new Obstacle { Name = "keeper", Shape = new CapsuleShape(Place(stands, 0.25, ahead), Place(stands, 1.6, ahead), 0.25), Surface = SurfaceMaterial.PublishedGoalFrame },
        ];
        Scene scene = random.Chance(0.8) ? Scene.Default : Scene.Published;
        var simulator = new Simulator(
            scene with { Goals = [goal], Obstacles = people }, new SolverSettings { Integrator = random.Chance(0.5) ? Integrator.Rk2 : Integrator.Rk4 });
        double timeStep = random.Any(1.0 / 60, 0.01, 1.0 / 30, 0.04);

        // The start is before the line, or level with it outside the posts. The target is the opening, the frame, or past it, at any height.
        double angle = random.Uniform(-92, 92) * Math.PI / 180;
        double distance = random.Uniform(0.3, Farthest);
        bool low = random.Chance(0.4);
        double high = low ? 0.11 : random.Uniform(0.11, 3.5);
        Vector3d from = Place(distance * Math.Sin(angle), high, distance * Math.Cos(angle));
        while (goal.Frame(ForceSet.Measured).Concat(people).Any(thing => thing.Shape.At(from).Distance < 0.12))
        {
            // Do not start inside an object.
            distance += 0.3;
            from = Place(distance * Math.Sin(angle), high, distance * Math.Cos(angle));
        }

        double side = random.Uniform(-1, 1);
        double aside = random.Chance(0.4) ? Math.Sign(side) * ((0.5 * goal.Width) + random.Uniform(-0.5, 0.2)) : side * ((0.5 * goal.Width) + 1);
        double height = random.Chance(0.25) ? goal.Height + random.Uniform(-0.4, 0.2) : random.Chance(0.3) ? 0.11 : random.Uniform(0.11, goal.Height + 0.5);
        Vector3d way = Place(aside, height, 0) - from;
        double speed = random.Chance(0.25) ? random.Uniform(1, 9) : random.Uniform(9, 38);

        // Some shots compensate for the drop by gravity on their path.
        double lift = random.Chance(0.7) ? 0.5 * 9.81 * way.Length / speed : 0;
        Vector3d velocity = (speed * (way / way.Length)) + new Vector3d(0, low && height < 0.2 ? 0 : Math.Min(lift, 12), 0);
        return new GoalShot(goal, simulator, timeStep, simulator.Launch(from, velocity, random.Chance(0.3) ? Vector3d.Zero : random.Uniform(0, 70) * random.Direction()));
    }
}
