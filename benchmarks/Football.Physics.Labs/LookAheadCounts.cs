namespace FootballPhysics.Labs;

/// <summary>Counts wrong results of look-aheads: crossings that are not found, paths that end too early, stiff forces that diverge.</summary>
internal static class LookAheadCounts
{
    public static readonly string[] Columns =
        ["paths", "crossings", "not found", "ended before passing", "wrongly complete or not", "with a stiff force", "refused", "diverged"];

    private const int PerScene = 20;
    private const double Closeness = 1e-6;

    /// <summary>The largest distance, m, between a look-ahead at its default step and one at 0.1 ms steps, if a custom force is stiff.</summary>
    private const double StiffBound = 0.01;

    /// <summary>Runs look-aheads, on all processors.</summary>
    /// <param name="seed">Seed of the kicks.</param>
    /// <param name="count">The number of kicks.</param>
    public static LabCounts Of(int seed, int count) => LabCounts.Of(count, PerScene, (counts, index, paths) =>
    {
        var random = new Random((seed * 100_057) + index);
        Scene scene = KnownKick.Scene(random, index % KnownKick.Balls.Length, index % 2 == 0 ? 0 : 20);
        var simulator = new Simulator(scene);
        var path = new Trajectory(16384);
        var other = new Trajectory(16384);
        for (int i = 0; i < paths; i++)
        {
            double angle = random.Between(0, 2 * Math.PI);
            var direction = new Vector3d(Math.Cos(angle), random.Between(-0.2, 2), Math.Sin(angle));
            Vector3d velocity = random.Between(4, 30) / direction.Length * direction;
            BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight + (i % 2), 0), velocity, KickVectors.Spin(velocity, random.Between(-40, 40), random.Between(-40, 40)));
            StopAt end = i % 3 == 0 ? StopAt.Rest : StopAt.Impact;
            simulator.LookAhead(in ball, new LookAheadRequest { StopAt = end, Duration = 12 }, path);
            if (path.Pieces.Length == 0)
            {
                continue; // kicked into the ground
            }

            counts.Add("paths");
            Cross(counts, random, path);
            EndEarly(counts, random, simulator, in ball, end, path, other);
            counts.AddIf(!FitsExactly(simulator, in ball, end, path), "wrongly complete or not");
        }

        Push(counts, random, scene, path, other);
    });

    /// <summary>Tests planes just below the apex, planes through the path, and planes across it.</summary>
    private static void Cross(LabCounts counts, Random random, Trajectory path)
    {
        double start = path.Pieces[0].StartPosition.Y;
        for (int k = 0; k < 3; k++)
        {
            double depth = Math.Pow(10, random.Between(-9, -1));
            Vector3d through = path.PositionAt(random.Between(0, 1) * path.EndTime);
            double angle = random.Between(0, 2 * Math.PI);
            var across = new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            (Plane3d plane, bool must) = k switch
            {
                0 => (new Plane3d(new Vector3d(0, path.Apex - depth, 0), Vector3d.Up), path.Apex - depth > start),
                1 => (new Plane3d(through, across), Math.Abs(Vector3d.Dot(through - path.Pieces[0].StartPosition, across)) > Closeness && IsCrossed(path, through, across)),
                _ => (new Plane3d(new Vector3d(0, start + (random.Between(0, 1) * (path.Apex - start)), 0), Vector3d.Up), path.Apex > start + Closeness),
            };
            bool found = path.TryGetCrossing(in plane, out PathPoint at);
            bool right = !found || Math.Abs(Vector3d.Dot(at.Position - plane.Point, plane.Normal)) < Closeness;
            counts.AddIf(must, "crossings");
            counts.Require(
                (found || !must) && right,
                "not found",
                $"plane {k} through {plane.Point}, normal {plane.Normal}: {(found ? at.Position : null)}; apex {path.Apex}, from {path.Pieces[0].StartPosition} at {path.Pieces[0].StartVelocity} m/s");
        }
    }

    /// <summary>True if dense samples of a path change sides of a plane.</summary>
    private static bool IsCrossed(Trajectory path, Vector3d point, Vector3d normal)
    {
        double first = Vector3d.Dot(path.Pieces[0].StartPosition - point, normal);
        for (double time = 0; time < path.EndTime; time += 1e-3)
        {
            double side = Vector3d.Dot(path.PositionAt(time) - point, normal);
            if (side * first < 0 && Math.Abs(side) > Closeness)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Checks that a path that stops after passing a point does not end before its closest approach to the point.</summary>
    private static void EndEarly(LabCounts counts, Random random, Simulator simulator, in BallState ball, StopAt end, Trajectory whole, Trajectory until)
    {
        double angle = random.Between(0, 2 * Math.PI);
        Vector3d aside = new(Math.Cos(angle), random.Between(-1, 1), Math.Sin(angle));
        Vector3d point = random.Next(2) == 0
            ? whole.Final.Position
            : whole.PositionAt(random.Between(0, whole.EndTime)) + (random.Between(0, 2) * aside);
        simulator.LookAhead(in ball, new LookAheadRequest { StopAt = end, Duration = 12, UntilPassing = point }, until);
        double off = until.ClosestApproach(point).Distance - whole.ClosestApproach(point).Distance;
        counts.Require(
            off <= Closeness,
            "ended before passing",
            $"until passing {point}: ends at {until.EndTime} s, {off} m further than at {whole.ClosestApproach(point).Time} s; {ball.Velocity} m/s, wind {simulator.Scene.Air.Wind}");
    }

    /// <summary>True if a buffer of exactly the right size is complete, and a buffer one piece smaller is not.</summary>
    private static bool FitsExactly(Simulator simulator, in BallState ball, StopAt end, Trajectory whole)
    {
        var request = new LookAheadRequest { StopAt = end, Duration = 12 };
        int pieces = whole.Pieces.Length;
        var exact = new Trajectory(pieces);
        simulator.LookAhead(in ball, request, exact);
        bool fits = exact.IsComplete && exact.Pieces.Length == pieces && exact.EndTime == whole.EndTime;
        if (pieces > 1)
        {
            var small = new Trajectory(pieces - 1);
            simulator.LookAhead(in ball, request, small);
            fits &= !small.IsComplete && small.Pieces.Length == pieces - 1;
        }

        return fits;
    }

    /// <summary>Tests a damper and a net as custom forces, from soft to very stiff: the library must follow or reject them.</summary>
    private static void Push(LabCounts counts, Random random, Scene scene, Trajectory path, Trajectory fine)
    {
        double damping = Math.Pow(10, random.Between(-2, 3));
        double stiffness = random.Next(2) == 0 ? 0 : Math.Pow(10, random.Between(1, 5));
        double friction = stiffness > 0 ? 0.1 * damping : damping;
        IForce net = IForce.From(ball =>
        {
            double depth = -11 - ball.Position.Z;
            return stiffness > 0
                ? depth > 0 ? (-friction * ball.Velocity) + (stiffness * new Vector3d(0, 0, depth)) : Vector3d.Zero
                : -friction * ball.Velocity;
        });
        var simulator = new Simulator(scene with { Forces = scene.Forces with { CustomForces = [net] } });
        BallState ball = simulator.Launch(new Vector3d(0, 1.5, 0), new Vector3d(1, 3, -20), default);
        var request = new LookAheadRequest { Duration = 1, StopAt = StopAt.Impact };
        bool refused = false;
        double off = 0;
        try
        {
            simulator.LookAhead(in ball, request, path);
            simulator.LookAhead(in ball, request with { TimeStep = 1e-4 }, fine);
            for (double time = 0; time < Math.Min(path.EndTime, fine.EndTime); time += 0.01)
            {
                off = Math.Max(off, Vector3d.Distance(path.PositionAt(time), fine.PositionAt(time)));
            }
        }
        catch (InvalidOperationException)
        {
            refused = true;
        }

        counts.Add("with a stiff force");
        counts.AddIf(refused, "refused");
        counts.Require(off <= StiffBound, "diverged", $"own force: {friction} N s/m, {stiffness} N/m, {scene.Ball.Mass} kg: {off} m off");
    }
}
