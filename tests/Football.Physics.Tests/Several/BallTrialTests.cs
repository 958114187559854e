using FootballPhysics.Numerics;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>The ways of two balls, piece by piece, and when they meet: against fine sampling and closed forms.</summary>
public sealed class BallTrialTests
{
    private const double Distance = 0.22;

    /// <summary>f = |p₁ − p₂| − d of random paths of random pieces, with pauses: sampled finely the balls touch nowhere before the time that is found, and there they do.</summary>
    [Fact]
    public void Two_ways_meet_when_a_fine_sampling_says_so()
    {
        int met = 0;
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new Random(seed);
            BallTrial a = Way(random, 1 + (seed % 3), out double end);
            BallTrial b = Way(random, 1 + (seed % 4), out double its);
            double until = Math.Max(end, its) + 0.05;
            double time = a.Meets(b, Distance, 0, until, atEnd: false);
            Assert.Equal(time, b.Meets(a, Distance, 0, until, atEnd: false));
            const int Samples = 1500;
            double found = double.PositiveInfinity;
            for (int k = 0; k < Samples && double.IsPositiveInfinity(found); k++)
            {
                double t = until * k / Samples;
                found = Gap(a, b, t) < -1e-5 ? t : found;
            }

            met += time < until ? 1 : 0;
            Assert.True(time <= found, $"{seed}: found {time}, sampled {found}");
            if (time < until)
            {
                double gap = Gap(a, b, time);
                Assert.True(gap <= 1e-10, $"{seed}: gap {gap} at {time}");
                Assert.True(time == 0 || gap > -2e-6, $"{seed}: so deep at once as {gap}");
            }
        }

        Assert.InRange(met, 15, 55);
    }

    /// <summary>Head on at u, from g apart: g/u; under a relative acceleration the root of g − u t − ½ a t².</summary>
    [Theory]
    [InlineData(2, 0)]
    [InlineData(2, 3)]
    [InlineData(4, -3)]
    [InlineData(0, 5)]
    public void They_meet_at_the_root_of_the_gap(double speed, double acceleration)
    {
        BallTrial a = Of((0, 1, default, new Vector3d(speed, 0, 0), new Vector3d(acceleration, 0, 0)));
        BallTrial b = Of((0, 1, new Vector3d(1, 0, 0), default, default));
        double g = 1 - Distance;
        double root = acceleration == 0 ? g / speed : (-speed + Math.Sqrt((speed * speed) + (2 * acceleration * g))) / acceleration;
        Assert.Equal(root, a.Meets(b, Distance, 0, 1, atEnd: false), 1.1e-7);
        Assert.Equal(root, a.Meets(b, Distance, 0.1, 1, atEnd: false), 1.1e-7);
        Assert.Equal(double.PositiveInfinity, a.Meets(b, Distance, 0, root - 1e-6, atEnd: true));
    }

    /// <summary>Nothing happens before the start of a search, at its end only where that counts, and not at all where the balls part.</summary>
    [Fact]
    public void The_end_of_a_search_counts_where_it_is_said_to()
    {
        BallTrial a = Of((0, 1, default, new Vector3d(1, 0, 0), default));
        BallTrial b = Of((0, 1, new Vector3d(0.5 + Distance, 0, 0), default, default));
        Assert.Equal(0.5, a.Meets(b, Distance, 0, 1, atEnd: false), 1e-9);
        Assert.Equal(0.5, a.Meets(b, Distance, 0.5, 0.5, atEnd: true));
        Assert.Equal(double.PositiveInfinity, a.Meets(b, Distance, 0.5, 0.5, atEnd: false));
        Assert.Equal(double.PositiveInfinity, a.Meets(b, Distance, 0.6, 0.5, atEnd: true));
        BallTrial away = Of((0, 1, new Vector3d(0.5, 0, 0), new Vector3d(1, 0, 0), default));
        BallTrial from = Of((0, 1, new Vector3d(0.5 - Distance, 0, 0), default, default));
        Assert.Equal(double.PositiveInfinity, away.Meets(from, Distance, 0, 0.9, atEnd: true));

        // Overlapping by more than a millionth they are met though they part, or stand still; by less they are not.
        BallTrial deep = Of((0, 1, new Vector3d(0.5 - 2e-6, 0, 0), default, default));
        BallTrial flat = Of((0, 1, new Vector3d(0.5 - 5e-7, 0, 0), default, default));
        Assert.Equal(0, deep.Meets(from, Distance, 0, 0.01, atEnd: false));
        Assert.Equal(double.PositiveInfinity, flat.Meets(from, Distance, 0, 0.0001, atEnd: false));
        BallTrial same = Of((0, 1, new Vector3d(0.5 - Distance, 0, 0), default, default));
        Assert.Equal(0, same.Meets(from, Distance, 0, 1, atEnd: false));
    }

    /// <summary>Where a ball is between its pieces, before the first and after the last: where the next begins, and at its end.</summary>
    [Fact]
    public void Between_its_pieces_a_ball_stays_where_it_is()
    {
        BallTrial way = Of((1, 1, new Vector3d(1, 0, 0), new Vector3d(1, 0, 0), default), (3, 0.5, new Vector3d(2, 0, 0), new Vector3d(-2, 0, 0), default));
        way.End.Position = new Vector3d(9, 0, 0);
        (double Time, double X, double Start, double Until)[] expected =
        [
            (0.5, 1, 0.5, 1), (1, 1, 1, 2), (1.25, 1.25, 1, 2), (2, 2, 2, 3), (2.5, 2, 2.5, 3), (3, 2, 3, 3.5), (3.25, 1.5, 3, 3.5), (3.5, 9, 3.5, double.PositiveInfinity), (7, 9, 7, double.PositiveInfinity),
        ];
        int index = 0;
        foreach ((double time, double x, double start, double until) in expected)
        {
            PathCubic path = way.At(time, ref index, out double begins, out double ends);
            Assert.Equal((start, until), (begins, ends));
            Assert.Equal(x, path.At(time - begins).X, 1e-14);
        }

        Assert.Equal(2, index);
    }

    /// <summary>The reach: fastest speed times length of each piece, and what lies between them.</summary>
    [Fact]
    public void Its_reach_is_its_length_with_all_jumps()
    {
        BallTrial way = Of((0, 0.5, new Vector3d(0.25, 0, 0), new Vector3d(3, 0, 0), default), (0.5, 2, new Vector3d(1.75, 2, 0), new Vector3d(0, 0, -1), default));
        Assert.Equal(0.25 + 1.5 + 2 + 2, way.Reach, 1e-14);
        for (int k = 0; k < 20; k++)
        {
            way.Add(Piece((2.5 + k, 1, new Vector3d(1.75, 2, -2 - (k * 0.5)), new Vector3d(0, 0, -0.5), default)));
        }

        Assert.Equal(5.75 + 10, way.Reach, 1e-13);
        int index = 0;
        Assert.Equal(-2 - 9.75, way.At(22, ref index, out double start, out _).At(22 - start).Z, 1e-13);
    }

    /// <summary>A trial flies as the step would, up to what it pushes; it can be taken again, and nothing is left of the one before.</summary>
    [Fact]
    public void A_trial_goes_as_the_step_goes_up_to_what_is_pushed()
    {
        var simulator = new Simulator(Scene.Default with { Obstacles = [new Obstacle { Name = "bin", Shape = new BoxShape(new Vector3d(5, 1, 0), new Vector3d(1, 5, 5)), Mass = 2 }] });
        BallState start = simulator.Launch(new Vector3d(2, 0.3, 0), new Vector3d(10, 2, 0), new Vector3d(0, 9, 0));
        var trial = new BallTrial();
        trial.Run(simulator, in start, 1, StopAt.Time, haltsAtPush: true, default);
        Assert.Equal(trial.End.Time, trial.HaltsAt);
        Assert.Equal(3.89, trial.End.Position.X, 1e-9);
        Assert.Equal(1, trial.Log.Events.Count);
        double reach = trial.Reach;
        Assert.InRange(reach, (trial.End.Position - start.Position).Length, 1.1 * (trial.End.Position - start.Position).Length);
        simulator.ResetObstacles();
        trial.Run(simulator, in start, 1, StopAt.Time, haltsAtPush: true, default);
        Assert.Equal(reach, trial.Reach);
        Assert.Equal(1, trial.Log.Events.Count);

        BallState away = simulator.Launch(new Vector3d(2, 0.3, 0), new Vector3d(-10, 2, 0), default);
        BallState stepped = away;
        simulator.Step(ref stepped, 0.1, new StepLog());
        trial.Run(simulator, in away, 0.1, StopAt.Time, haltsAtPush: true, default);
        Assert.True(Snapshot.Same(in stepped, in trial.End));
        Assert.Equal((0, double.PositiveInfinity, 0), (trial.From, trial.HaltsAt, trial.Log.Events.Count));
        int index = 0;
        Assert.InRange((trial.At(0.1 - 1e-12, ref index, out double begins, out _).At(0.1 - begins) - stepped.Position).Length, 0, 1e-9);

        // Raised out of the ground at the start: that is part of its way, as what it is put to at the end.
        BallState low = away;
        low.Position = new Vector3d(2, -0.39, 0);
        trial.Run(simulator, in low, 0, StopAt.Time, haltsAtPush: true, default);
        Assert.Equal(0.5, trial.Reach, 1e-14);
        low.Velocity = Vector3d.Zero;
        trial.Run(simulator, in low, 1e-6, StopAt.Time, haltsAtPush: true, default);
        Assert.Equal(0.5, trial.Reach, 1e-5);
    }

    private static double Gap(BallTrial a, BallTrial b, double time) => (Place(a, time) - Place(b, time)).Length - Distance;

    private static Vector3d Place(BallTrial way, double time)
    {
        int index = 0;
        return way.At(time, ref index, out double start, out _).At(time - start);
    }

    private static BallTrial Way(Random random, int pieces, out double end)
    {
        Vector3d Draw() => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        var all = new (double, double, Vector3d, Vector3d, Vector3d)[pieces];
        Vector3d place = 0.5 * Draw();
        end = 0;
        for (int k = 0; k < pieces; k++)
        {
            double length = 0.1 + (0.3 * random.NextDouble());
            Vector3d velocity = (-3 * place) + Draw();
            Vector3d acceleration = 12 * Draw();
            all[k] = (end, length, place, velocity, acceleration);
            place += (length * velocity) + (0.5 * length * length * acceleration);
            end += length + (k % 2 == 0 ? 0 : 0.04);
        }

        BallTrial way = Of(all);
        way.End.Position = place;
        return way;
    }

    private static BallTrial Of(params (double Time, double Length, Vector3d Place, Vector3d Velocity, Vector3d Acceleration)[] pieces)
    {
        var trial = new BallTrial();
        foreach ((double, double, Vector3d, Vector3d, Vector3d) piece in pieces)
        {
            Assert.False(trial.Add(Piece(piece)));
        }

        return trial;
    }

    private static PathSegment Piece((double Time, double Length, Vector3d Place, Vector3d Velocity, Vector3d Acceleration) at) => new(
        at.Time,
        at.Length,
        at.Place,
        at.Velocity,
        at.Acceleration,
        at.Place + (at.Length * at.Velocity) + (0.5 * at.Length * at.Length * at.Acceleration),
        at.Velocity + (at.Length * at.Acceleration),
        at.Acceleration,
        MotionState.Airborne,
        3);
}
