namespace FootballPhysics.Labs;

/// <summary>Counts the kicks found for a requested arrival speed, and those that arrive with it when simulated.</summary>
internal static class ArrivalCounts
{
    public static readonly string[] Columns = ["requests", "hits", "out of reach", "not converged", "known kicks", "not found again", "hits at another speed", "worst, m/s"];

    /// <summary>The number of requests per aimer.</summary>
    private const int PerAimer = 20;

    /// <summary>A kick whose arrival speed is off by more than this, m/s, does not count.</summary>
    private const double LargestError = 0.1;

    /// <summary>The kinds of targets: in the air, low for volleys, on the ground.</summary>
    public enum Kind
    {
        Air,
        Volley,
        Ground,
    }

    public static LabCounts Of(int seed, int count, Kind kind) => LabCounts.Of(count, PerAimer, (counts, index, requests) =>
    {
        var random = new Random((seed * 100_003) + index);
        var simulator = new Simulator();
        var aimer = new Aimer(simulator);
        for (int i = 0; i < requests; i++)
        {
            double height = kind switch { Kind.Air => random.Between(0.5, 2.2), Kind.Volley => random.Between(0.2, 0.6), _ => 0.11 };
            double away = kind switch { Kind.Air => random.Between(8, 25), Kind.Volley => random.Between(4, 9), _ => random.Between(20, 45) };
            var request = new AimRequest
            {
                From = new Vector3d(0, kind == Kind.Volley ? 1 : 0.11, 0),
                Target = new Vector3d(random.Between(-3, 3), height, -away),
                Speed = kind == Kind.Volley ? random.Between(10, 20) : random.Between(20, 32),
                TopSpin = i % 3 == 0 ? random.Between(-20, 20) : 0,
                SideSpin = i % 4 == 0 ? random.Between(-30, 30) : 0,
            };

            // Request the arrival speed of a kick that hits, or any speed.
            AimResult witness = aimer.Find(request);
            bool isKnown = i % 2 == 0 && witness.Status == AimStatus.Hit;
            double wanted = isKnown ? Played(simulator, request, in witness) : random.Between(4, 25);
            AimResult kick = aimer.FindAtSpeed(request with { Speed = 35 }, wanted);
            double error = kick.Status == AimStatus.Hit ? Math.Abs(Played(simulator, request, in kick) - wanted) : 0;
            FormattableString example = $"{request}, {wanted} m/s: {kick}, {error} m/s off";
            counts.Add("requests");
            counts.AddIf(isKnown, "known kicks");
            counts.Require(!isKnown || kick.Status == AimStatus.Hit, "not found again", example);
            counts.AddIf(kick.Status == AimStatus.Hit, "hits");
            counts.AddIf(kick.Status == AimStatus.OutOfReach, "out of reach");
            counts.AddIf(kick.Status is not (AimStatus.Hit or AimStatus.OutOfReach), "not converged");
            counts.Require(error <= LargestError, "hits at another speed", example);
            counts.Most("worst, m/s", error);
        }
    });

    /// <summary>Returns the speed of a kick at its target, simulated in short steps. For a kick that comes down there, it is the speed before it touches the ground.</summary>
    private static double Played(Simulator simulator, AimRequest request, in AimResult kick)
    {
        BallState ball = simulator.Launch(request.From, kick.Velocity, kick.Spin);
        var log = new StepLog();
        bool touches = simulator.Run(ref ball, 2e-3, Math.Max(kick.Time, 1e-6), kick.Rolls ? StopAt.Time : StopAt.Impact, log);
        return (touches ? log.Events[log.Events.Count - 1].VelocityBefore : ball.Velocity).Length;
    }
}

/// <summary>Aims at targets on and over slopes, and checks that hits pass the target when they are simulated.</summary>
internal static class SlopeCounts
{
    public static readonly string[] Columns = ["requests", "hits", "false hits", "worst, mm"];

    private const int PerScene = 20;

    /// <summary>The error that the chords of the simulated path may add, m.</summary>
    private const double Room = 1e-3;

    private const double TimeStep = 1e-3;

    /// <summary>Aims kicks.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="steepest">The steepest slope, as a share.</param>
    /// <param name="isUneven">True if the ground is a height field.</param>
    public static LabCounts Of(int seed, int count, double steepest, bool isUneven) => LabCounts.Of(count, PerScene, (counts, index, requests) =>
    {
        var random = new Random((seed * 100_003) + index);
        var simulator = new Simulator(new Scene { Ground = GroundOf(random, steepest, isUneven) });
        var aimer = new Aimer(simulator);
        for (int i = 0; i < requests; i++)
        {
            double away = random.Between(5, 28);
            double angle = random.Between(-Math.PI, Math.PI);
            Vector3d from = Lying(simulator, 0, 0);
            Vector3d target = Lying(simulator, away * Math.Cos(angle), away * Math.Sin(angle)) + ((i % 3 == 0 ? random.Between(0, 2) : 0) * Vector3d.Up);
            var request = new AimRequest { From = from, Target = target, Speed = random.Between(10, 28) };
            AimResult kick = i % 5 == 4 ? aimer.FindSlowest(request) : aimer.Find(request);
            double passes = kick.Status == AimStatus.Hit ? Closest(simulator, from, target, in kick) : 0;
            counts.Add("requests");
            counts.AddIf(kick.Status == AimStatus.Hit, "hits");
            counts.Require(passes <= request.Tolerance + Room, "false hits", $"{simulator.Scene.Ground.Normal}: {request}: {kick}, passes {passes} m off");
            counts.Most("worst, mm", 1e3 * passes);
        }
    });

    private static Ground GroundOf(Random random, double steepest, bool isUneven)
    {
        double x = random.Between(-steepest, steepest);
        double z = random.Between(-steepest, steepest);
        if (!isUneven)
        {
            return new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(x, 1, z).Normalized() };
        }

        // Long waves with the same steepness.
        return new Ground { Material = SurfaceMaterial.DryTurf, Heights = LabMath.Hills(-40, -40, 2, 40, (i, j) => 5 * ((x * Math.Sin(0.4 * i)) + (z * Math.Cos(0.4 * j)))) };
    }

    private static Vector3d Lying(Simulator simulator, double x, double z) => simulator.Launch(new Vector3d(x, -20, z), Vector3d.Zero, Vector3d.Zero).Position;

    /// <summary>Returns the closest distance of the ball on chords of its path.</summary>
    private static double Closest(Simulator simulator, Vector3d from, Vector3d target, in AimResult kick)
    {
        BallState ball = simulator.Launch(from, kick.Velocity, kick.Spin);
        var log = new StepLog();
        double closest = Vector3d.Distance(ball.Position, target);
        while (ball.Time < kick.Time + 0.1)
        {
            Vector3d before = ball.Position;
            log.Clear();
            simulator.Step(ref ball, TimeStep, log);
            Vector3d way = ball.Position - before;
            double share = way.LengthSquared > 0 ? Math.Clamp(Vector3d.Dot(target - before, way) / way.LengthSquared, 0, 1) : 0;
            closest = Math.Min(closest, Vector3d.Distance(before + (share * way), target));
        }

        return closest;
    }
}

/// <summary>Counts the simulated passes along the ground that are found again: at their time, and no faster than they were.</summary>
internal static class GroundPassCounts
{
    public static readonly string[] Columns = ["passes", "found", "at their time", "no slower one", "false hits"];

    private const int PerScene = 10;

    /// <summary>Aims passes, on all processors.</summary>
    /// <param name="seed">Seed of the passes.</param>
    /// <param name="count">The number of passes.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="balls">The number of different balls to use.</param>
    public static LabCounts Of(int seed, int count, double wind, int balls) => LabCounts.Of(count, PerScene, (counts, index, passes) =>
    {
        var random = new Random((seed * 100_019) + index);
        Scene scene = KnownKick.Scene(random, index % balls, wind);
        var simulator = new Simulator(scene);
        var aimer = new Aimer(scene);
        var truth = new TrueMiss(scene);
        var path = new Trajectory(16384);
        for (int i = 0; i < passes; i++)
        {
            (AimRequest request, double time) = Draw(random, simulator, path);
            AimResult found = aimer.Find(request);
            AimResult timed = aimer.FindAtTime(request with { Speed = random.Between(1, 1.3) * request.Speed }, time);
            AimResult slowest = aimer.FindSlowest(request with { Speed = 30, MaximumElevationDegrees = 45 });
            counts.Add("passes");
            Require(found.Status == AimStatus.Hit, "found", "pass", in found);
            Require(timed.Status == AimStatus.Hit, "at their time", "timed", in timed);
            Require(slowest.Status == AimStatus.Hit && slowest.Speed <= 1.001 * request.Speed, "no slower one", "slowest", in slowest);
            foreach (AimResult result in (AimResult[])[found, slowest])
            {
                bool isFalse = result.HitsTarget && truth.Of(request, result.Velocity, result.Spin) > TrueMiss.Rounding * request.Tolerance;
                Require(!isFalse, "false hits", "false hit", in result);
            }

            void Require(bool holds, string column, string question, in AimResult result) => counts.Require(
                holds, column, $"ground, {question} {index}: {result.Status}, {result.Speed:0.000} m/s, miss {result.Miss:0.000000} m; at {time} s; {request}");
        }
    });

    /// <summary>Draws a pass, and a point on its path with the time.</summary>
    private static (AimRequest Request, double Time) Draw(Random random, Simulator simulator, Trajectory path)
    {
        while (true)
        {
            double azimuth = random.Between(0, 2 * Math.PI);
            double speed = random.Between(3, 28);
            double top = random.Next(2) == 0 ? 0 : random.Between(-30, 30);
            double side = random.Next(2) == 0 ? 0 : random.Between(-30, 30);
            Vector3d direction = new(Math.Cos(azimuth), 0, Math.Sin(azimuth));
            BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), speed * direction, KickVectors.Spin(direction, top, side));
            simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = 0.01, Duration = 10, StopAt = StopAt.Impact }, path);
            double time = random.Between(0.1, 0.9) * path.EndTime;
            Vector3d target = path.PositionAt(time);
            if (!path.IsComplete || target.Horizontal.Length < 1 || target.Y > simulator.ContactHeight)
            {
                continue;
            }

            var request = new AimRequest
            {
                From = new Vector3d(0, simulator.ContactHeight, 0),
                Target = target,
                Speed = speed,
                TopSpin = top,
                SideSpin = side,
                MaximumElevationDegrees = random.Next(2) == 0 ? 0 : 45,
            };
            return (request, time);
        }
    }
}

/// <summary>Counts the hits of batch aims that miss when they are simulated: low drives with backspin, which the ground blocks, and any kick.</summary>
internal static class BatchHitCounts
{
    public static readonly string[] Columns = ["requests", "hits", "false hits", "worst, mm"];

    private const int PerScene = 400;

    /// <summary>Aims kicks, on all processors.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="drives">True for low drives with backspin.</param>
    public static LabCounts Of(int seed, int count, double wind, bool drives) => LabCounts.Of(count, PerScene, (counts, index, requests) =>
    {
        var random = new Random((seed * 100_043) + index);
        Scene scene = KnownKick.Scene(random, index % KnownKick.Balls.Length, wind);
        double contact = scene.Ball.Radius;
        var aims = new BatchAims(requests) { MaximumElevationDegrees = 60, Tolerance = 1e-3 };
        for (int i = 0; i < requests; i++)
        {
            double distance = random.Between(5, 30);
            double angle = random.Between(0, 2 * Math.PI);
            double height = contact + (drives ? random.Between(0, 0.5) : random.Between(0, 3));
            var from = new Vector3d(0, contact + (drives || random.Next(2) == 0 ? 0 : random.Between(0, 2)), 0);
            double top = drives ? random.Between(-60, -20) : random.Between(-60, 60);
            aims.Set(i, from, new Vector3d(distance * Math.Cos(angle), height, distance * Math.Sin(angle)), random.Between(15, 35), top, random.Between(-30, 30));
        }

        var kicks = new BatchKicks(requests);
        new BatchAimer(scene).Find(aims, kicks, requests);
        var truth = new TrueMiss(scene);
        for (int i = 0; i < requests; i++)
        {
            bool hit = kicks.Status[i] == AimStatus.Hit;
            double miss = hit ? truth.Of(new AimRequest { From = aims.From[i], Target = aims.Target[i] }, kicks.Velocity[i], kicks.Spin[i]) : 0;
            counts.Add("requests");
            counts.AddIf(hit, "hits");
            counts.AddIf(miss > TrueMiss.Rounding * aims.Tolerance, "false hits");
            counts.Most("worst, mm", 1e3 * miss);
        }
    });
}

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
        var exact = new Trajectory(new PathSegment[pieces]);
        simulator.LookAhead(in ball, request, exact);
        bool fits = exact.IsComplete && exact.Pieces.Length == pieces && exact.EndTime == whole.EndTime;
        if (pieces > 1)
        {
            var small = new Trajectory(new PathSegment[pieces - 1]);
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
