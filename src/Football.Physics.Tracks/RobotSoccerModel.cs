using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The ball of a scene in the terms of robot soccer (RoboCup Small Size League): the two-phase model of a straight kick and the fixed-loss model of a chip.</summary>
/// <remarks>
/// The definitions are those of the league's vision software, in <c>messages_robocup_ssl_geometry.proto</c> of RoboCup-SSL/ssl-vision. Accelerations are
/// negative and in m/s². TIGERs Mannheim's <c>BallParameters</c> use mm/s²: multiply by 1000.
/// <para>The numbers come from a simulated kick and a simulated chip. The air is included, so the numbers depend on the speed: use the typical speed of your
/// kicks. Wind, obstacles, bodies, goals and nets of the scene are left out, and the ground is level.</para>
/// </remarks>
public sealed record RobotSoccerModel
{
    /// <summary>The step and the longest time of a simulation, in s.</summary>
    private const double Step = 1.0 / 60;
    private const double Longest = 60;

    /// <summary>The minimum height of a hop that counts, in m: that of TIGERs.</summary>
    private const double LeastHop = 0.01;

    private RobotSoccerModel()
    {
    }

    /// <summary>The mean acceleration while the ball slides, in m/s²; negative (<c>acc_slide</c>).</summary>
    public double SlideAcceleration { get; private init; }

    /// <summary>The constant acceleration with which the ball would roll the same distance, in m/s²; negative (<c>acc_roll</c>).</summary>
    public double RollAcceleration { get; private init; }

    /// <summary>The fraction of the initial speed at which the ball begins to roll (<c>k_switch</c>).</summary>
    /// <remarks>Without air it is 1/(1 + α), where α is <see cref="BallProperties.InertiaFactor"/>: 5/7 for a solid sphere, 3/5 for a thin shell.</remarks>
    public double SwitchFraction { get; private init; }

    /// <summary>The fraction of the horizontal speed that the first hop of a chip keeps (<c>damping_xy_first_hop</c>).</summary>
    public double FirstHopDamping { get; private init; }

    /// <summary>The fraction of the horizontal speed that each later hop keeps (<c>damping_xy_other_hops</c>): the geometric mean, or 1 without later
    /// hops.</summary>
    public double OtherHopsDamping { get; private init; }

    /// <summary>The fraction of the vertical speed that a hop keeps (<c>damping_z</c>): the geometric mean of the hops of a chip.</summary>
    public double VerticalDamping { get; private init; }

    /// <summary>Computes the numbers of a scene's ball, air and ground.</summary>
    /// <param name="scene">The scene, such as <see cref="MatchFitResult.Scene"/>.</param>
    /// <param name="straightSpeed">The speed of the straight kick, without spin, in m/s; 0.5 … 100; default 6.</param>
    /// <param name="chipSpeed">The speed of the chip, without spin, in m/s; 2 … 100; default 6.</param>
    /// <param name="chipElevationDegrees">The elevation of the chip, in degrees; 20 … 80; default 45.</param>
    /// <returns>The model; null if the ball does not begin to roll within a minute, or the chip does not come down.</returns>
    /// <exception cref="ArgumentNullException">The scene is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A speed or the elevation is out of range.</exception>
    public static RobotSoccerModel? Of(Scene scene, double straightSpeed = 6, double chipSpeed = 6, double chipElevationDegrees = 45)
    {
        Check.Given(nameof(scene), scene);
        Check.Within(nameof(straightSpeed), straightSpeed, 0.5, 100);
        Check.Within(nameof(chipSpeed), chipSpeed, 2, 100);
        Check.Within(nameof(chipElevationDegrees), chipElevationDegrees, 20, 80);
        Ground ground = scene.Ground;
        if (ground.IsNone)
        {
            return null;
        }

        var simulator = new Simulator(new Scene
        {
            Ball = scene.Ball,
            Air = scene.Air with { Wind = Vector3d.Zero, WindField = null },
            Forces = scene.Forces,
            Gravity = scene.GravityVector.Length,
            Ground = ground with { Heights = null, Normal = Vector3d.Up, Height = 0, Pattern = null },
        });
        Elementary.SinCos(chipElevationDegrees * (Math.PI / 180), out double sine, out double cosine);
        List<BallEvent> hops = Hops(simulator, new Vector3d(0, chipSpeed * sine, -chipSpeed * cosine));
        return hops.Count > 0 && Straight(simulator, straightSpeed) is { } straight
            ? straight with
            {
                FirstHopDamping = Along(hops[0]),
                OtherHopsDamping = MeanOf(hops.Skip(1), Along),
                VerticalDamping = MeanOf(hops, hop => hop.Velocity.Y / -hop.VelocityBefore.Y),
            }
            : null;
    }

    /// <summary>Kicks the ball along the ground, and measures the slide and the roll.</summary>
    private static RobotSoccerModel? Straight(Simulator simulator, double speed)
    {
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), new Vector3d(0, 0, -speed), Vector3d.Zero);
        simulator.Run(ref ball, Step, Longest, StopAt.Rest, log);
        foreach (BallEvent happened in log.Events)
        {
            if (happened.Kind == BallEventKind.Roll && happened.Time > 0)
            {
                double rolls = happened.Velocity.Length;
                double ends = ball.Velocity.Length;
                double distance = (ball.Position - happened.Position).Length;
                return new RobotSoccerModel
                {
                    SlideAcceleration = (rolls - speed) / happened.Time,
                    RollAcceleration = distance > 0 ? ((ends * ends) - (rolls * rolls)) / (2 * distance) : 0,
                    SwitchFraction = rolls / speed,
                };
            }
        }

        return null;
    }

    /// <summary>Chips the ball, and returns its impacts after hops that are high enough.</summary>
    private static List<BallEvent> Hops(Simulator simulator, Vector3d velocity)
    {
        var log = new StepLog();
        double least = Math.Sqrt(2 * simulator.Scene.Gravity * LeastHop);
        BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), velocity, Vector3d.Zero);
        simulator.Run(ref ball, Step, Longest, StopAt.Rest, log);
        List<BallEvent> hops = [];
        foreach (BallEvent happened in log.Events)
        {
            if (happened.Kind == BallEventKind.Impact && -happened.VelocityBefore.Y >= least && happened.Velocity.Y > 0)
            {
                hops.Add(happened);
            }
        }

        return hops;
    }

    private static double Along(BallEvent hop) => hop.Velocity.Horizontal.Length / hop.VelocityBefore.Horizontal.Length;

    /// <summary>Returns the geometric mean of the fraction that a hop keeps; 1 without hops.</summary>
    private static double MeanOf(IEnumerable<BallEvent> hops, Func<BallEvent, double> kept)
    {
        double product = 1;
        int count = 0;
        foreach (BallEvent hop in hops)
        {
            product *= kept(hop);
            count++;
        }

        return count == 0 ? 1 : product > 0 ? Elementary.Pow(product, 1.0 / count) : 0;
    }
}
