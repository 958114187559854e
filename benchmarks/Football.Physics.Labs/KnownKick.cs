namespace FootballPhysics.Labs;

/// <summary>A simulated kick, and the request that it solves.</summary>
/// <param name="Request">The request: its target is a point of the kick's path, its speed and spins are the kick's.</param>
/// <param name="Time">The time at which the kick is at the target, s.</param>
/// <param name="Between">A point of the path before the target, m.</param>
/// <param name="Elevation">Its elevation, degrees.</param>
internal sealed record KnownKick(AimRequest Request, double Time, Vector3d Between, double Elevation)
{
    private const double Degree = Math.PI / 180;

    /// <summary>The balls of the kicks.</summary>
    public static BallProperties[] Balls { get; } =
        [BallProperties.Tunnel, BallProperties.YouthFootball, BallProperties.Futsal, BallProperties.BeachBall, BallProperties.MedicineBall];

    /// <summary>The request with a waypoint, and with unknown spins.</summary>
    public AimRequest TwoPoint => Request with
    {
        Waypoint = Between,
        TopSpin = 0,
        SideSpin = 0,
        MaximumTopSpin = Math.Max(40, 1.05 * Math.Abs(Request.TopSpin)),
        MaximumSideSpin = Math.Max(40, 1.05 * Math.Abs(Request.SideSpin)),
    };

    /// <summary>Returns a scene with one of the balls and a wind from any direction.</summary>
    /// <param name="random">The random numbers.</param>
    /// <param name="ball">The index in <see cref="Balls"/>.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    public static Scene Scene(Random random, int ball, double wind)
    {
        double angle = random.Between(0, 2 * Math.PI);
        return FootballPhysics.Scene.Published with
        {
            Ball = Balls[ball],
            Air = new Air { Wind = random.Between(0, wind) * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle)) },
        };
    }

    /// <summary>Draws kicks until one is at least 1 m away before it touches the ground.</summary>
    /// <param name="random">The random numbers.</param>
    /// <param name="simulator">The scene.</param>
    /// <param name="path">The buffer for a flight.</param>
    /// <param name="steepest">Largest elevation, degrees.</param>
    public static KnownKick Draw(Random random, Simulator simulator, Trajectory path, double steepest = 85)
    {
        while (true)
        {
            double height = simulator.ContactHeight + (random.Next(3) > 0 ? 0 : random.Between(0, 2.5));
            double elevation = random.Between(height > simulator.ContactHeight ? -20 : 1, steepest);
            double azimuth = random.Between(0, 2 * Math.PI);
            double speed = random.Between(5, 35);
            bool spins = random.Next(4) > 0;
            double top = spins ? random.Between(-50, 50) : 0;
            double side = spins ? random.Between(-50, 50) : 0;
            bool narrow = random.Next(3) == 0;
            (double sine, double cosine) = Math.SinCos(elevation * Degree);
            Vector3d direction = new(cosine * Math.Cos(azimuth), sine, cosine * Math.Sin(azimuth));
            BallState ball = simulator.Launch(new Vector3d(0, height, 0), speed * direction, KickVectors.Spin(direction, top, side));
            simulator.LookAhead(in ball, new LookAheadRequest { TimeStep = 0.005, Duration = 12, StopAt = StopAt.Impact }, path);
            double time = random.Between(0.1, 0.98) * path.EndTime;
            double part = random.Between(0.3, 0.7);
            Vector3d target = path.PositionAt(time);
            if (ball.Motion != MotionState.Airborne || !path.IsComplete || target.Horizontal.Length < 1)
            {
                continue;
            }

            var request = new AimRequest
            {
                From = new Vector3d(0, height, 0),
                Target = target,
                Speed = speed,
                TopSpin = top,
                SideSpin = side,
                MinimumElevationDegrees = narrow ? elevation - 8 : Math.Min(0, elevation),
                MaximumElevationDegrees = narrow ? Math.Min(90, elevation + 8) : Math.Max(steepest, 45),
                Tolerance = 1e-3,
            };
            return new KnownKick(request, time, path.PositionAt(part * time), elevation);
        }
    }
}

/// <summary>Computes the true miss of a kick: its closest approach to the target before its first impact, by a look-ahead in RK4 at 5 ms.</summary>
/// <param name="scene">The scene.</param>
internal sealed class TrueMiss(Scene scene)
{
    /// <summary>The factor by which a hit may exceed its tolerance: its miss was measured with other steps.</summary>
    public const double Rounding = 1.01;

    private static readonly LookAheadRequest s_look = new() { TimeStep = 0.005, Duration = 30, StopAt = StopAt.Impact };

    private readonly Simulator _simulator = new(scene);
    private readonly Trajectory _path = new(8192);

    /// <summary>Returns the closest approach of a kick, m.</summary>
    /// <param name="request">The request.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="spin">Its spin, rad/s.</param>
    public double Of(AimRequest request, Vector3d velocity, Vector3d spin)
    {
        BallState ball = _simulator.Launch(request.From, velocity, spin);
        _simulator.LookAhead(in ball, s_look, _path);

        // A target below contact height is raised to it, like a ball.
        return _path.ClosestApproach(new Vector3d(request.Target.X, Math.Max(request.Target.Y, _simulator.ContactHeight), request.Target.Z)).Distance;
    }
}

/// <summary>Counts the simulated kicks that are found again, by every query that has a solution then.</summary>
internal static class KnownKickCounts
{
    public static readonly string[] Columns =
        ["kicks", "low arc", "high arc", "at their time", "no slower one", "below 45°", "two points below 45°", "false hits", "most simulations"];

    /// <summary>The number of kicks per scene.</summary>
    private const int PerScene = 10;

    /// <summary>Aims kicks, on all processors.</summary>
    /// <param name="seed">Seed of the kicks.</param>
    /// <param name="count">The number of kicks.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="balls">The number of different balls to use.</param>
    public static LabCounts Of(int seed, int count, double wind, int balls) => LabCounts.Of(count, PerScene, (counts, index, kicks) =>
    {
        var random = new Random((seed * 100_003) + index);
        Scene scene = KnownKick.Scene(random, index % balls, wind);
        var simulator = new Simulator(scene);
        var aimer = new Aimer(scene);
        var path = new Trajectory(16384);
        var truth = new TrueMiss(scene);
        for (int i = 0; i < kicks; i++)
        {
            KnownKick kick = KnownKick.Draw(random, simulator, path);
            AimRequest request = kick.Request;
            double more = random.Between(1, 1.3);
            AimResult low = aimer.Find(request);
            AimResult high = aimer.Find(request with { Arc = AimArc.High });
            AimResult timed = aimer.FindAtTime(request with { Speed = more * request.Speed }, kick.Time);
            AimResult exact = aimer.FindAtTime(request, kick.Time);
            AimResult slowest = aimer.FindSlowest(request with { Speed = more * request.Speed });
            AimResult two = aimer.Find(kick.TwoPoint);
            bool passes = two.Miss <= request.Tolerance && two.WaypointMiss <= request.WaypointTolerance;
            bool flat = kick.Elevation <= 45;
            counts.Add("kicks");
            counts.AddIf(flat, "below 45°");
            Require(low.Status == AimStatus.Hit, "low arc", "low", in low);
            Require(high.Status == AimStatus.Hit && high.Time >= low.Time - 0.01, "high arc", "high", in high);
            Require(timed.Status == AimStatus.Hit && exact.Status == AimStatus.Hit, "at their time", "timed", timed.Status == AimStatus.Hit ? exact : timed);
            Require(slowest.Status == AimStatus.Hit && slowest.Velocity.Length <= 1.001 * request.Speed, "no slower one", "slowest", in slowest);
            Require(passes, flat ? "two points below 45°" : "two points above 45°", flat ? "two points, flat" : "two points, steep", in two);
            RequireTruth(request, in low);
            RequireTruth(request, in high);
            RequireTruth(request, in slowest);
            RequireTruth(kick.TwoPoint, in two);
            counts.Most("most iterations", (long)Math.Max(low.Iterations, Math.Max(high.Iterations, two.Iterations)));
            counts.Most("most simulations", (long)Math.Max(low.Simulations, Math.Max(high.Simulations, two.Simulations)));

            void RequireTruth(AimRequest aim, in AimResult result) => Require(
                !result.HitsTarget || truth.Of(aim, result.Velocity, result.Spin) <= TrueMiss.Rounding * aim.Tolerance, "false hits", "false hit", in result);

            void Require(bool found, string column, string question, in AimResult result) => counts.Require(
                found,
                column,
                $"{question} {index}: {result.Status}, miss {result.Miss:0.000000} m; at {kick.Time} s, {kick.Elevation:0.00}°, through {kick.Between}; {scene.Ball.Mass} kg, wind {scene.Air.Wind}; {kick.Request}");
        }
    });
}
