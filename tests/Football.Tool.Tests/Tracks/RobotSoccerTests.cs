namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>The numbers of robot soccer, against the formulas that hold without air.</summary>
public sealed class RobotSoccerTests(ITestOutputHelper output)
{
    private const double G = 9.81;

    /// <summary>A ball without air on a ground with constant restitution and friction.</summary>
    private static Scene Plain(double inertia, double restitution, double impactFriction, double sliding = 0.3, double rolling = 0.04) => new()
    {
        Ball = BallProperties.Modern with { Mass = 0.046, Radius = 0.0215, InertiaFactor = inertia },
        Air = new Air { Density = 0 },
        Ground = Ground.Of(new SurfaceMaterial
        {
            NormalRestitution = restitution,
            RestitutionSpeedScale = double.PositiveInfinity,
            GrazingRestitutionGain = 0,
            TangentialRestitution = 0,
            ImpactFriction = impactFriction,
            SlidingFriction = sliding,
            RollingResistance = rolling,
            RollingResistancePerSpeed = 0,
            TorsionalPatchRadius = 0,
        }),
    };

    [Theory]
    [InlineData(0.4, 5.0 / 7)]
    [InlineData(2.0 / 3, 3.0 / 5)]
    [InlineData(0.5, 2.0 / 3)]
    public void A_straight_kick_slides_then_rolls_as_the_formulas_say(double inertia, double switches)
    {
        RobotSoccerModel model = RobotSoccerModel.Of(Plain(inertia, 0.5, 0.3), straightSpeed: 6.5)!;
        output.WriteLine($"{model}");
        Assert.Equal(switches, model.SwitchFraction, 1e-6);
        Assert.Equal(-0.3 * G, model.SlideAcceleration, 1e-6);
        Assert.Equal(-0.04 * G, model.RollAcceleration, 1e-4);
    }

    /// <summary>With little friction in the impact, the first hop slips: it loses μ (1 + e) of the vertical speed.</summary>
    [Theory]
    [InlineData(0.1, 0.5, 45)]
    [InlineData(0.05, 0.6, 60)]
    public void A_chip_that_slips_loses_what_friction_takes(double friction, double restitution, double degrees)
    {
        RobotSoccerModel model = RobotSoccerModel.Of(Plain(0.4, restitution, friction), chipSpeed: 5, chipElevationDegrees: degrees)!;
        Assert.Equal(restitution, model.VerticalDamping, 1e-6);
        Assert.Equal(1 - (friction * (1 + restitution) * Math.Tan(degrees * Math.PI / 180)), model.FirstHopDamping, 1e-6);
    }

    /// <summary>With much friction, the first hop grips, and keeps as much as a slide does; then the ball rolls, and loses nothing more.</summary>
    [Theory]
    [InlineData(0.4)]
    [InlineData(2.0 / 3)]
    public void A_chip_that_grips_keeps_as_much_as_a_slide(double inertia)
    {
        RobotSoccerModel model = RobotSoccerModel.Of(Plain(inertia, 0.6, 1), chipSpeed: 6)!;
        Assert.Equal(1 / (1 + inertia), model.FirstHopDamping, 1e-6);
        Assert.Equal(1, model.OtherHopsDamping, 1e-6);
        Assert.Equal(model.SwitchFraction, model.FirstHopDamping, 1e-6);
    }

    /// <summary>With air, a fast kick slows more: drag adds to both accelerations. Wind and goals do not count.</summary>
    [Fact]
    public void Air_counts_and_wind_does_not()
    {
        Scene plain = Plain(0.4, 0.5, 0.3);
        Scene airy = plain with { Air = new Air() };
        RobotSoccerModel without = RobotSoccerModel.Of(plain)!;
        RobotSoccerModel with = RobotSoccerModel.Of(airy)!;
        Assert.True(with.SlideAcceleration < without.SlideAcceleration - 0.05 && with.RollAcceleration < without.RollAcceleration - 0.02, $"{without}\n{with}");
        Assert.Equal(with, RobotSoccerModel.Of(airy with { Air = new Air { Wind = new Vector3d(3, 0, 8) }, Goals = [new Goal { Center = new Vector3d(0, 0, -2), Facing = new Vector3d(0, 0, 1) }] }));
    }

    [Fact]
    public void A_ball_that_never_rolls_has_no_model()
    {
        Assert.Null(RobotSoccerModel.Of(Plain(0.4, 0.5, 0.3, sliding: 0)));
        Assert.Null(RobotSoccerModel.Of(new Scene { Ground = Ground.None }));
        Assert.Throws<ArgumentOutOfRangeException>(() => RobotSoccerModel.Of(new Scene(), chipElevationDegrees: 5));
    }

    /// <summary>A track of the league's own model, with its own numbers: the fit finds them again.</summary>
    [Fact]
    public void The_fit_of_a_track_of_that_league_finds_its_numbers()
    {
        Scene scene = Plain(0.4, 0.67, 0.42) with { Ground = new Ground() };
        MatchFitResult fit = new MatchFit(scene).Find(LeagueTrack(slide: -3, roll: -0.35, switches: 5.0 / 7, first: 0.75, others: 0.95, vertical: 0.55));
        RobotSoccerModel model = RobotSoccerModel.Of(fit.Scene)!;
        output.WriteLine($"{fit.Flights} flights, {fit.Windows.Count} slides and rolls: {model}");
        Assert.InRange(model.SlideAcceleration, -3.15, -2.85);
        Assert.InRange(model.SwitchFraction, 0.70, 0.73);
        Assert.InRange(model.RollAcceleration, -0.5, -0.25);
        Assert.InRange(model.FirstHopDamping, 0.7, 0.8);
        Assert.InRange(model.OtherHopsDamping, 0.9, 1);

        // The bounce depends on speed and angle, for which a few chips are not enough.
        Assert.InRange(model.VerticalDamping, 0.45, 0.65);
    }

    /// <summary>Six straight kicks of 6 m/s and six chips of 45° at 60 Hz, with noise of 1 mm: two phases, and fixed losses.</summary>
    private static TrackPoint[] LeagueTrack(double slide, double roll, double switches, double first, double others, double vertical)
    {
        const double Wait = 1.0 / 60;
        const double Radius = 0.0215;
        const double Speed = 6;
        const double Chip = 3;
        var random = new Random(2);
        List<TrackPoint> points = [];
        double Noise() => 0.001 * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
        void Add(double along, double up) => points.Add(new TrackPoint(points.Count * Wait, new Vector3d(along + Noise(), Radius + up + Noise(), Noise()), 0.001));

        double x = 0;
        for (int kick = 0; kick < 6; kick++)
        {
            // Out along the ground, and back through the air.
            double way = kick % 2 == 0 ? 1 : -1;
            double slides = (switches - 1) * Speed / slide;
            double from = x;
            for (int i = 0; i < 150; i++)
            {
                double t = i * Wait;
                double rolls = Math.Max(0, t - slides);
                double slid = Math.Min(t, slides);
                x = from + (way * ((Speed * slid) + (0.5 * slide * slid * slid) + (switches * Speed * rolls) + (0.5 * roll * rolls * rolls)));
                Add(x, 0);
            }

            double at = 0;
            double along = Chip;
            from = x;
            for (double up = Chip; up > 0.45; up *= vertical)
            {
                double time = 2 * up / G;
                for (; at < time; at += Wait)
                {
                    Add(from - (way * along * at), (up * at) - (0.5 * G * at * at));
                }

                from -= way * along * time;
                at -= time;
                along *= up == Chip ? first : others;
            }

            x = from;
        }

        return [.. points];
    }
}
