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
