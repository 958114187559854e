using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tests.Queries;

/// <summary>The best pass of a fan against every kick of it, flown exactly and asked who meets it.</summary>
public sealed class PassFanReferenceTests
{
    private const int Fans = 32;

    public static TheoryData<string, double, bool> Scenes => new()
    {
        { "measured", 0, false },
        { "measured", 0, true },
        { "measured", 5, true },
        { "published", 0, false },
        { "published", 0, true },
        { "published", 5, true },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void The_answer_is_the_earliest_pass_of_all_that_hold(string profile, double wind, bool alongTheGround)
    {
        Scene scene = Of(profile, wind);
        var fan = new PassFan(scene);
        var random = new SeededRandom(21L);
        int found = 0;
        int rolled = 0;
        for (int i = 0; i < Fans; i++)
        {
            PassFanRequest request = Request(random, i, alongTheGround);
            Player[] mates = Players(random, 1 + (i % 5), 30);
            Player[] opponents = Players(random, i % 12, 40);
            PassResult choice = fan.Find(request, mates, opponents);
            double earliest = Earliest(scene, request, mates, opponents, out int open);
            Assert.Equal(!double.IsPositiveInfinity(earliest), choice.IsFound);
            Assert.InRange(choice.Open, open, choice.Kicks);
            if (choice.IsFound)
            {
                Assert.Equal(earliest, choice.Meeting.Time, 1e-9);
                Assert.True(choice.TimeMargin >= request.Margin);
                found++;
                rolled += choice.Velocity.Y < scene.Ground.MinimumBounceSpeed ? 1 : 0;
            }
        }

        Assert.InRange(found, Fans / 3, Fans);
        Assert.Equal(alongTheGround, rolled > 0);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Without_team_mates_it_ends_closest_to_the_target_of_all_that_no_opponent_meets(string profile, double wind, bool alongTheGround)
    {
        Scene scene = Of(profile, wind);
        var fan = new PassFan(scene);
        var random = new SeededRandom(22L);
        int found = 0;
        for (int i = 0; i < Fans; i++)
        {
            PassFanRequest request = Request(random, i, alongTheGround) with { Target = random.Uniform(5, 30) * random.Heading() };
            Player[] opponents = Players(random, i % 6, 50);
            PassResult choice = fan.Find(request, [], opponents);
            double closest = Closest(scene, request, opponents);
            Assert.Equal(!double.IsPositiveInfinity(closest), choice.IsFound);
            if (choice.IsFound)
            {
                Assert.Equal(closest, (choice.Meeting.Position - request.Target!.Value).Horizontal.Length, 1e-9);
                found++;
            }
        }

        Assert.InRange(found, Fans / 3, Fans);
    }

    [Fact]
    public void A_spin_beyond_what_lanes_know_is_judged_too()
    {
        var random = new SeededRandom(23L);
        PassFanRequest request = Request(random, 0, alongTheGround: true) with { TopSpin = -150, SideSpin = 90 };
        Player[] mates = Players(random, 4, 30);
        Player[] opponents = Players(random, 3, 40);
        PassResult choice = new PassFan(Scene.Measured).Find(request, mates, opponents);
        double earliest = Earliest(Scene.Measured, request, mates, opponents, out _);
        Assert.Equal(earliest, choice.IsFound ? choice.Meeting.Time : double.PositiveInfinity, 1e-9);
        Assert.True(choice.IsFound);
    }

    private static Scene Of(string profile, double wind)
    {
        Scene scene = profile == "measured" ? Scene.Measured : Scene.Published;
        return scene with { Air = scene.Air with { Wind = new Vector3d(wind, 0, -0.5 * wind) } };
    }

    private static PassFanRequest Request(SeededRandom random, int index, bool alongTheGround) => new()
    {
        From = new Vector3d(random.Uniform(-9, 9), index % 4 == 3 ? random.Uniform(0.11, 1.5) : 0.11, random.Uniform(-9, 9)),
        Direction = random.Heading(),
        FanDegrees = random.Uniform(60, 360),
        Directions = 7,
        MinimumElevationDegrees = alongTheGround ? 0 : random.Uniform(5, 20),
        MaximumElevationDegrees = random.Uniform(20, 60),
        Elevations = 4,
        MinimumSpeed = random.Uniform(4, 10),
        MaximumSpeed = random.Uniform(12, 30),
        Speeds = 5,
        TopSpin = random.Uniform(-60, 60),
        SideSpin = random.Uniform(-60, 60),
        Margin = index % 7 == 6 ? 2 : random.Uniform(0, 0.3),
        Duration = index % 5 == 4 ? random.Uniform(0.5, 3) : 8,
    };

    private static Player[] Players(SeededRandom random, int count, double within) =>
    [
        .. Enumerable.Range(0, count).Select(_ => new Player
        {
            Position = random.Uniform(6, within) * random.Heading(),
            Velocity = random.Uniform(0, 6) * random.Heading(),
            Reaction = random.Uniform(0, 0.6),
            MaximumHeight = random.Uniform(0.4, 2.6),
        }),
    ];

    private static double Earliest(Scene scene, PassFanRequest request, Player[] mates, Player[] opponents, out int open)
    {
        double earliest = double.PositiveInfinity;
        int holding = 0;
        Each(scene, request, path =>
        {
            var query = new FootballPhysics.Prediction.Interception();
            int mate = query.FindFirst(path, mates, out PathPoint at);
            int opponent = query.FindFirst(path, opponents, out PathPoint lost);
            bool holds = mate >= 0 && (opponent < 0 || lost.Time - at.Time >= request.Margin);
            earliest = holds ? Math.Min(earliest, at.Time) : earliest;
            holding += holds ? 1 : 0;
        });
        open = holding;
        return earliest;
    }

    private static double Closest(Scene scene, PassFanRequest request, Player[] opponents)
    {
        double closest = double.PositiveInfinity;
        Each(scene, request, path =>
        {
            bool ends = path.TryGetRest(out _) || path.TryGetTouchdown(0, out _);
            if (ends && new FootballPhysics.Prediction.Interception().FindFirst(path, opponents, out _) < 0)
            {
                closest = Math.Min(closest, (path.Final.Position - request.Target!.Value).Horizontal.Length);
            }
        });
        return closest;
    }

    private static void Each(Scene scene, PassFanRequest request, Action<Trajectory> look)
    {
        var simulator = new Simulator(scene);
        var path = new Trajectory();
        for (int i = 0; i < request.Count; i++)
        {
            request.Kick(i, out Vector3d velocity, out Vector3d spin);
            BallState ball = simulator.Launch(request.From, velocity, spin);
            StopAt end = ball.Motion == MotionState.Airborne ? StopAt.Impact : StopAt.Rest;
            simulator.LookAhead(in ball, new LookAheadRequest { Duration = request.Duration, StopAt = end }, path);
            look(path);
        }
    }
}
