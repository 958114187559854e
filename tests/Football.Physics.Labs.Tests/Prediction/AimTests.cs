using FootballPhysics.Aiming;

namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>The solvers on many random requests.</summary>
public sealed class AimTests
{
    [Theory]
    [InlineData(AimMethod.Direct)]
    [InlineData(AimMethod.Angle)]
    [InlineData(AimMethod.Bisection)]
    public void Every_kick_is_what_it_says(AimMethod method)
    {
        var random = new Shots(1);
        var aimer = new ThesisAimer(Scene.Published, timeStep: 0.02);
        int hits = 0;
        for (int i = 0; i < 300; i++)
        {
            AimRequest request = AimCheck.Any(random);
            AimResult result = aimer.Find(request, method);
            AimCheck.Holds(request, in result);
            hits += result.Status == AimStatus.Hit ? 1 : 0;
        }

        Assert.InRange(hits, 100, 299);
    }

    [Fact]
    public void Direct_hits_whatever_another_method_hits()
    {
        var random = new Shots(2);
        var aimer = new Aimer(Scene.Published);
        var thesis = new ThesisAimer(Scene.Published);
        int hits = 0;
        for (int i = 0; i < 300; i++)
        {
            AimRequest request = AimCheck.Any(random);
            AimResult other = thesis.Find(request, AimMethod.Bisection);
            AimResult direct = aimer.Find(request);
            hits += other.Status == AimStatus.Hit ? 1 : 0;
            Assert.True(other.Status != AimStatus.Hit || direct.Status == AimStatus.Hit, $"{direct.Status} {direct.Miss}: {request}");
            Assert.True(direct.Status != AimStatus.OutOfReach || direct.Miss <= other.Miss + 1e-3, $"{direct.Miss} > {other.Miss}: {request}");
        }

        Assert.InRange(hits, 100, 299);
    }

    [Fact]
    public void The_high_arc_is_the_higher_of_two_hits()
    {
        var random = new Shots(3);
        var aimer = new Aimer(Scene.Published);
        int both = 0;
        for (int i = 0; i < 200; i++)
        {
            AimRequest request = AimCheck.Any(random) with { MaximumElevationDegrees = 85, Speed = random.Uniform(14, 20) };
            AimResult low = aimer.Find(request);
            AimResult high = aimer.Find(request with { Arc = AimArc.High });
            Assert.Equal(low.Status, high.Status);
            if (low.Status == AimStatus.Hit)
            {
                both += high.Velocity.Y > low.Velocity.Y + 1 ? 1 : 0;
                Assert.True(high.Velocity.Y >= low.Velocity.Y - 1e-2 && high.Time >= low.Time - 1e-2, $"{request}");
            }
        }

        Assert.InRange(both, 50, 200);
    }

    [Fact]
    public void A_mirrored_request_has_the_mirrored_kick()
    {
        var random = new Shots(4);
        var aimer = new Aimer(Scene.Published);
        static Vector3d Mirror(Vector3d v) => new(v.X, v.Y, -v.Z);
        for (int i = 0; i < 200; i++)
        {
            AimRequest request = AimCheck.Any(random);
            AimResult one = aimer.Find(request);
            AimResult other = aimer.Find(request with { Target = Mirror(request.Target), SideSpin = -request.SideSpin });
            Assert.Equal(one.Status, other.Status);
            Assert.True(Vector3d.Distance(one.Velocity, Mirror(other.Velocity)) < 1e-6 * request.Speed, $"{request}");
        }
    }

    [Fact]
    public void Without_measuring_the_estimate_of_a_hit_is_a_hit()
    {
        var random = new Shots(5);
        var aimer = new Aimer(Scene.Published);
        for (int i = 0; i < 200; i++)
        {
            AimRequest request = AimCheck.Any(random);
            AimResult measured = aimer.Find(request);
            AimResult estimated = aimer.Find(request, measure: false);
            Assert.Equal(measured.Velocity, estimated.Velocity);
            Assert.Equal(measured.Status == AimStatus.Hit, estimated.Status == AimStatus.Hit);
        }
    }

    [Fact]
    public void Direct_takes_one_flight_and_a_bit()
    {
        var aimer = new Aimer(Scene.Published);
        AimResult[] results = [.. AimSets.Thesis(1, 200).Select(request => aimer.Find(request))];
        Assert.All(results, result => Assert.InRange(result.Miss, 0, 1e-3));
        Assert.InRange(results.Average(result => result.Simulations), 1, 1.2);
    }

    [Theory]
    [InlineData(AimMethod.Direct)]
    [InlineData(AimMethod.Angle)]
    [InlineData(AimMethod.Bisection)]
    [InlineData(AimMethod.TwoPoint)]
    public void A_search_allocates_nothing(AimMethod method)
    {
        var random = new Shots(6);
        var aimer = new ThesisAimer(Scene.Published, timeStep: 0.02);
        AimRequest[] requests = [.. Enumerable.Range(0, 100).Select(i =>
        {
            AimRequest request = AimCheck.Any(random);
            return method == AimMethod.TwoPoint || (method == AimMethod.Direct && i % 2 == 0)
                ? request with { Waypoint = (0.5 * request.Target) + new Vector3d(0, random.Uniform(0, 2), random.Uniform(-1, 1)) }
                : request;
        })];
        foreach (AimRequest request in requests)
        {
            AimResult result = default;
            long allocated = Allocation.Of(() => result = aimer.Find(request, method));
            Assert.True(allocated == 0, $"{allocated} bytes, {result.Status}: {request}");
        }
    }

    [Fact]
    public void A_moving_target_is_met_where_it_is_then()
    {
        var random = new Shots(7);
        var aimer = new Aimer(Scene.Published);
        int hits = 0;
        for (int i = 0; i < 300; i++)
        {
            AimRequest request = AimCheck.Any(random) with { TargetVelocity = random.Uniform(0, 8) * random.Direction().Horizontal };
            AimResult result = aimer.Find(request);
            AimCheck.Holds(request, in result);
            Vector3d then = request.Target + (result.Time * request.TargetVelocity);
            Assert.True(Math.Abs(Vector3d.Distance(then, result.Closest) - result.Miss) < 1e-6, $"{request}");
            hits += result.Status == AimStatus.Hit ? 1 : 0;
        }

        Assert.InRange(hits, 150, 300);
    }

    [Fact]
    public void The_slowest_kick_hits_and_a_slower_one_does_not()
    {
        var random = new Shots(8);
        var aimer = new Aimer(Scene.Published);
        int hits = 0;
        for (int i = 0; i < 200; i++)
        {
            AimRequest request = AimCheck.Any(random);
            AimResult slowest = aimer.FindSlowest(request);
            AimResult fastest = aimer.Find(request);
            double speed = slowest.Velocity.Length;
            Assert.True(speed <= request.Speed * (1 + 1e-9));
            if (slowest.Status == AimStatus.Hit)
            {
                hits++;
                AimCheck.Holds(request, in slowest, speed: speed);
                if (speed > 0.02)
                {
                    AimResult slower = aimer.Find(request with { Speed = 0.995 * speed });
                    Assert.True(slower.Status != AimStatus.Hit, $"{speed} hits, and so does {0.995 * speed}: {request}");
                }
            }
            else
            {
                Assert.True(fastest.Status != AimStatus.Hit, $"{request}");
            }
        }

        Assert.InRange(hits, 100, 200);
    }

    [Fact]
    public void A_kick_for_a_time_is_there_then()
    {
        var random = new Shots(9);
        var aimer = new Aimer(Scene.Published);
        int hits = 0;
        int grazes = 0;
        for (int i = 0; i < 200; i++)
        {
            AimRequest request = AimCheck.Any(random);
            AimResult fastest = aimer.Find(request);
            AimResult slowest = aimer.FindSlowest(request);
            if (fastest.Status != AimStatus.Hit || slowest.Status != AimStatus.Hit || slowest.Time < fastest.Time)
            {
                continue;
            }

            double time = random.Uniform(fastest.Time, slowest.Time);
            AimResult timely = aimer.FindAtTime(request, time);
            if (timely.Status != AimStatus.Hit && timely.Miss < 0.02)
            {
                // Where kicks begin to graze the drag law's jump, their time jumps with their speed.
                grazes++;
                continue;
            }

            Assert.True(timely.Status == AimStatus.Hit, $"{timely.Status} {timely.Miss} at {time}: {request}");
            Assert.True(Math.Abs(timely.Time - time) < 1e-3, $"{timely.Time} for {time}: {request}");
            Assert.InRange(timely.Velocity.Length, slowest.Velocity.Length * (1 - 1e-6), request.Speed * (1 + 1e-9));
            Assert.NotEqual(AimStatus.Hit, aimer.FindAtTime(request, 0.8 * fastest.Time).Status);
            hits++;
        }

        Assert.InRange(hits, 80, 200);
        Assert.InRange(grazes, 0, 6);
    }
}
