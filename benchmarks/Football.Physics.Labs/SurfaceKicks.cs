namespace FootballPhysics.Labs;

/// <summary>The ground and the largest wind of a set of known kicks.</summary>
/// <param name="Name">The name of the ground.</param>
/// <param name="Slope">The slope, as a share.</param>
/// <param name="IsUneven">True for hills with this steepness.</param>
/// <param name="Wind">Largest wind, m/s.</param>
internal sealed record SurfaceCondition(string Name, double Slope, bool IsUneven, double Wind)
{
    /// <summary>The grounds in still air, and level and sloping ground in winds.</summary>
    public static SurfaceCondition[] All { get; } =
    [
        new("level", 0, false, 0), new("level", 0, false, 10), new("level", 0, false, 20), new("0.5 %", 0.005, false, 0), new("1 %", 0.01, false, 0),
        new("2 %", 0.02, false, 0), new("3 %", 0.03, false, 0), new("5 %", 0.05, false, 0), new("10 %", 0.1, false, 0), new("5 %", 0.05, false, 20),
        new("hills", 0.05, true, 0), new("hills", 0.05, true, 20),
    ];

    /// <summary>Returns a scene with the slope in a random direction, and a random wind.</summary>
    public Scene Scene(Random random)
    {
        double down = random.Between(0, 2 * Math.PI);
        double wind = random.Between(0, 2 * Math.PI);
        (double x, double z) = (Slope * Math.Cos(down), Slope * Math.Sin(down));
        var ground = new Ground { Material = SurfaceMaterial.DryTurf };
        return new Scene
        {
            Air = new Air { Wind = random.Between(0, Wind) * new Vector3d(Math.Cos(wind), 0, Math.Sin(wind)) },
            Ground = IsUneven ? ground with { Heights = LabMath.Hills(-90, -90, 2, 91, (i, k) => 5 * ((x * Math.Sin(0.4 * i)) + (z * Math.Cos(0.4 * k)))) }
                : Slope > 0 ? ground with { Normal = new Vector3d(x, 1, z).Normalized() }
                : ground,
        };
    }
}

/// <summary>Flies a kick in steps of 4 ms, which err by less than a micrometre, and states where it was: the judge of the answers of a search.</summary>
/// <param name="simulator">The scene.</param>
internal sealed class ArrivalJudge(Simulator simulator)
{
    private static readonly LookAheadRequest s_look = new() { TimeStep = 4e-3, Duration = 30, StopAt = StopAt.Impact };
    private readonly Trajectory _path = new(65_536);

    /// <summary>The path of the last kick, up to its first impact.</summary>
    public Trajectory Path => _path;

    /// <summary>Flies a kick.</summary>
    public Trajectory Fly(Vector3d from, Vector3d velocity, Vector3d spin, double duration = 30)
    {
        BallState ball = simulator.Launch(from, velocity, spin);
        simulator.LookAhead(in ball, s_look with { Duration = duration }, _path);
        return _path;
    }

    /// <summary>Returns the closest approach of a kick to a target before its first impact, m; and its speed there, m/s.</summary>
    public (double Miss, double Speed) Of(AimRequest request, in AimResult kick)
    {
        Trajectory path = Fly(request.From, kick.Velocity, kick.Spin, Math.Min(30, kick.Time + 0.5));
        if (path.Pieces.Length == 0)
        {
            return (Vector3d.Distance(request.From, request.Target), kick.Speed);
        }

        PathPoint closest = path.ClosestApproach(request.Target);
        return (closest.Distance, closest.Velocity.Length);
    }

    /// <summary>Returns the distance of a kick from a target at a time, m.</summary>
    public double At(AimRequest request, in AimResult kick, double time)
    {
        Trajectory path = Fly(request.From, kick.Velocity, kick.Spin, time);
        return path.Pieces.Length == 0 ? Vector3d.Distance(request.From, request.Target) : Vector3d.Distance(path.PositionAt(Math.Min(time, path.EndTime)), request.Target);
    }
}

/// <summary>Counts the known kicks on a surface that the searches do not find again, and the hits that do not hit.</summary>
internal static class SurfaceKickCounts
{
    public static readonly string[] Columns =
        ["kicks", "false out of reach", "Find", "FindSlowest", "FindAtSpeed", "FindAtTime", "false hits", "not the slowest", "worst hit, mm"];

    private const int PerScene = 10;
    private const double Degree = Math.PI / 180;

    /// <summary>The speed by which an arrival may be off, m/s; the slowest kick may be slower by this share than the one found.</summary>
    private const double LargestSpeedError = 0.02;
    private const double LargestExcess = 1.01;

    /// <summary>The distance from the ground at which a ball counts as on it, m; a path over hills is a little off between its ends.</summary>
    private const double OnGround = 1e-3;

    /// <summary>The kinds of kicks: to a point of a flight, to the place where it lands, and along the ground.</summary>
    private enum Kind
    {
        Flight,
        Landing,
        Ground,
    }

    /// <summary>Aims kicks, on all processors.</summary>
    /// <param name="seed">Seed of the kicks.</param>
    /// <param name="count">The number of kicks.</param>
    /// <param name="condition">Ground and wind.</param>
    public static LabCounts Of(int seed, int count, SurfaceCondition condition) => LabCounts.Of(count, PerScene, (counts, index, kicks) =>
    {
        var random = new Random((seed * 100_003) + index);
        var simulator = new Simulator(condition.Scene(random));
        var aimer = new Aimer(simulator);
        var judge = new ArrivalJudge(simulator);
        for (int i = 0; i < kicks; i++)
        {
            Kind kind = (i % 4) switch { 1 => Kind.Landing, 2 => Kind.Ground, _ => Kind.Flight };
            (AimRequest request, double time, double speed) = Draw(random, simulator, judge, kind);
            AimRequest faster = request with { Speed = random.Between(1, 1.3) * request.Speed };
            AimResult found = aimer.Find(request);
            AimResult slowest = aimer.FindSlowest(faster);
            AimResult fast = aimer.FindAtSpeed(faster, speed);
            AimResult timed = aimer.FindAtTime(faster, time);
            counts.Add("kicks");
            Judge("Find", in found, judge.Of(request, in found).Miss);
            Judge("FindSlowest", in slowest, judge.Of(request, in slowest).Miss);
            (double miss, double arrival) = judge.Of(request, in fast);
            Judge("FindAtSpeed", in fast, Math.Abs(arrival - speed) <= LargestSpeedError ? miss : double.PositiveInfinity);
            Judge("FindAtTime", in timed, judge.At(request, in timed, time));
            Require(!(slowest.HitsTarget && slowest.Speed > LargestExcess * request.Speed), "not the slowest", in slowest, 0);

            void Judge(string search, in AimResult result, double miss)
            {
                Require(result.HitsTarget, search, in result, miss);
                Require(result.Status != AimStatus.OutOfReach, "false out of reach", in result, miss);
                Require(!result.HitsTarget || miss <= TrueMiss.Rounding * request.Tolerance, "false hits", in result, miss);
                counts.Most("worst hit, mm", result.HitsTarget ? 1e3 * miss : 0);
            }

            void Require(bool holds, string column, in AimResult result, double miss) => counts.Require(
                holds,
                column,
                $"{column}, {kind} {index}.{i}: {result}, in truth {miss:0.00000} m; known: {time} s, {speed} m/s; {request}");
        }
    });

    /// <summary>True if the counts are within their bounds.</summary>
    public static bool Holds(LabCounts counts, SurfaceCondition condition)
    {
        double most = (condition is { Slope: 0, Wind: 0 } ? 0.005 : 0.01) * counts["kicks"];
        return counts["false out of reach"] == 0 && counts["false hits"] == 0
            && new[] { "Find", "FindSlowest", "FindAtSpeed", "FindAtTime", "not the slowest" }.All(column => counts[column] <= most);
    }

    /// <summary>Draws a kick, and a point of its path with the time and the speed there.</summary>
    private static (AimRequest Request, double Time, double Speed) Draw(Random random, Simulator simulator, ArrivalJudge judge, Kind kind)
    {
        while (true)
        {
            double azimuth = random.Between(0, 2 * Math.PI);
            var ahead = new Vector3d(Math.Cos(azimuth), 0, Math.Sin(azimuth));
            Vector3d lying = Lying(simulator, 0, 0);
            Vector3d from = lying + ((kind == Kind.Flight && random.Next(3) == 0 ? random.Between(0.1, 2) : 0) * Vector3d.Up);
            Vector3d along = Lying(simulator, 0.01 * ahead.X, 0.01 * ahead.Z) - lying;
            double level = (Math.Atan2(along.Y, 0.01) / Degree) + 1e-4;
            double elevation = kind == Kind.Ground ? level : random.Between(level + 2, 80);
            double speed = kind == Kind.Ground ? random.Between(4, 25) : random.Between(6, 33);
            bool spins = random.Next(2) == 0;
            double top = spins ? random.Between(-30, 30) : 0;
            double side = spins ? random.Between(-30, 30) : 0;
            (double sine, double cosine) = Math.SinCos(elevation * Degree);
            Vector3d velocity = speed * new Vector3d(cosine * ahead.X, sine, cosine * ahead.Z);
            Trajectory path = judge.Fly(from, velocity, KickVectors.Spin(velocity, top, side), 12);
            if (path.Pieces.Length == 0 || !path.IsComplete || (kind != Kind.Ground) == (simulator.Launch(from, velocity, Vector3d.Zero).Motion != MotionState.Airborne))
            {
                continue;
            }

            double time = kind == Kind.Landing ? path.EndTime : random.Between(0.1, kind == Kind.Ground ? 0.9 : 0.98) * path.EndTime;
            Vector3d target = path.PositionAt(time);
            Vector3d below = Lying(simulator, target.X, target.Z);
            bool touches = Vector3d.Distance(target, below) < OnGround;
            target = kind == Kind.Flight ? target : below;
            double arrival = (kind == Kind.Landing ? path.Events[path.Events.Count - 1].VelocityBefore : path.VelocityAt(time)).Length;
            if ((target - from).Horizontal.Length < 2 || target.Horizontal.Length > 80 || touches != (kind != Kind.Flight) || arrival < 0.5)
            {
                continue;
            }

            var request = new AimRequest
            {
                From = from,
                Target = target,
                Speed = speed,
                TopSpin = top,
                SideSpin = side,
                MinimumElevationDegrees = Math.Min(0, Math.Floor(level)),
                MaximumElevationDegrees = elevation > 45 ? 85 : 45,
            };
            return (request, time, arrival);
        }
    }

    private static Vector3d Lying(Simulator simulator, double x, double z) => simulator.Launch(new Vector3d(x, -30, z), Vector3d.Zero, Vector3d.Zero).Position;
}

/// <summary>Counts the verdicts on targets that a dense scan puts well beyond the reach.</summary>
internal static class FarTargetCounts
{
    public static readonly string[] Columns = ["targets", "out of reach", "not converged", "hits"];

    private const int PerScene = 10;
    private const int Elevations = 181;

    /// <summary>The miss of the closest kick, as a share of the distance, from which on a target counts as beyond the reach.</summary>
    private const double Beyond = 0.05;

    /// <summary>Aims at far targets, on all processors.</summary>
    public static LabCounts Of(int seed, int count) => LabCounts.Of(count, PerScene, (counts, index, requests) =>
    {
        var random = new Random((seed * 100_003) + index);
        var scene = new Scene();
        var aimer = new Aimer(scene);
        var scan = new AimScan(scene);
        for (int i = 0; i < requests; i++)
        {
            var request = new AimRequest
            {
                From = new Vector3d(0, 0.11, 0),
                Target = new Vector3d(random.Between(10, 60), random.Next(2) == 0 ? 0.11 : random.Between(0.2, 6), 0),
                Speed = random.Between(6, 24),
                TopSpin = i % 2 == 0 ? 0 : random.Between(-40, 40),
                SideSpin = i % 2 == 0 ? 0 : random.Between(-40, 40),
                MaximumElevationDegrees = i % 3 == 0 ? 80 : 45,
            };
            if (scan.Best(request, Elevations) < Beyond * request.Target.X)
            {
                continue;
            }

            AimResult result = aimer.Find(request);
            counts.Add("targets");
            counts.AddIf(result.HitsTarget, "hits");
            counts.AddIf(result.Status == AimStatus.NotConverged, "not converged");
            counts.Require(result.Status != AimStatus.NotConverged, "far", $"{result}: {request}");
            counts.AddIf(result.Status == AimStatus.OutOfReach, "out of reach");
        }
    });
}
