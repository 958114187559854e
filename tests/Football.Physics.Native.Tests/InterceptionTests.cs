using System.Runtime.InteropServices;
using System.Text;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>Interceptions, chances to score and fits of tracks, called as C calls them, and compared with C#.</summary>
public sealed unsafe class InterceptionTests
{
    private const string Goal = """{"goals": [{"center": [0, 0, -20], "facing": [0, 0, 1]}]}""";

    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_free = &Exports.SceneFree;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, NativeState*, NativeStatus> s_launch = &Exports.Launch;
    private static readonly delegate* unmanaged<NativePlayer*, NativeStatus> s_default = &Exports.PlayerDefault;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, NativePlayer*, int, NativeInterception*, NativeStatus> s_intercept = &Exports.Intercept;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, NativePlayer*, int, NativeWindow*, int, int*, NativeStatus> s_windows = &Exports.InterceptWindows;
    private static readonly delegate* unmanaged<NativeScene*, byte*, long, NativeGoalChanceResult*, NativeStatus> s_chance = &Exports.GoalChance;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, long, byte*, long, NativeFitResult*, NativeStatus> s_fit = &Exports.Fit;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, long, byte*, long, NativePiece*, int, int*, NativeFitMatchResult*, NativeScene**, NativeStatus> s_fitMatch
        = &Exports.FitMatch;

    private static readonly delegate* unmanaged<NativeScene*, byte*, long, NativeGoalChanceResult*, NativeWatch*, NativeStatus> s_chanceWatched = &Exports.GoalChanceWatched;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, long, byte*, long, NativeFitResult*, NativeWatch*, NativeStatus> s_fitWatched = &Exports.FitWatched;

    private static readonly delegate* unmanaged<
        NativeScene*, double*, double*, double*, long, byte*, long, NativePiece*, int, int*, NativeFitMatchResult*, NativeScene**, NativeWatch*, NativeStatus> s_fitMatchWatched = &Exports.FitMatchWatched;

    [Fact]
    public void Players_reach_the_ball_as_in_CSharp()
    {
        NativeScene* scene = Scene("{}");
        NativeState state = Launched(scene);
        NativePlayer* players = stackalloc NativePlayer[22];
        var same = new Player[22];
        for (int i = 0; i < 22; i++)
        {
            Assert.Equal(NativeStatus.Ok, s_default(players + i));
            players[i].Position[0] = (i * 7 % 23) - 11;
            players[i].Position[2] = -(i * 11 % 37);
            players[i].Velocity[2] = i % 3;
            players[i].Speed = 6 + (i % 3);
            same[i] = new Player { Position = new((i * 7 % 23) - 11, 0, -(i * 11 % 37)), Velocity = new(0, 0, i % 3), Speed = 6 + (i % 3) };
        }

        var simulator = new Simulator();
        var path = new Trajectory(1024);
        var interception = new Interception();
        simulator.LookAhead(in *(BallState*)&state, new LookAheadRequest { Duration = 12 }, path);
        interception.Find(path, same, until: 12);
        NativeInterception first;
        Assert.Equal(NativeStatus.Ok, s_intercept(scene, &state, 12, players, 22, &first));
        ReadOnlySpan<InterceptWindow> windows = interception.Windows;
        InterceptWindow one = interception.WindowsOf(interception.First)[0];
        Assert.Equal((interception.First, interception.TimeMargin, one.From, one.Position), (first.Player, first.Margin, first.Time, At(first.Position)));
        NativeWindow* found = stackalloc NativeWindow[200];
        int count;
        Assert.Equal(NativeStatus.Ok, s_windows(scene, &state, 12, players, 22, found, 200, &count));
        Assert.Equal(windows.Length, count);
        Assert.True(count > 5);
        for (int i = 0; i < count; i++)
        {
            Assert.Equal((windows[i].Player, windows[i].From, windows[i].To, windows[i].Velocity), (found[i].Player, found[i].From, found[i].To, At(found[i].Velocity)));
        }

        Assert.Equal(NativeStatus.Buffer, s_windows(scene, &state, 12, players, 22, found, 2, &count));
        Assert.Equal($"capacity is 2; there are {windows.Length} intervals.", Error());

        // Nobody, and no room for what is wrong; then again without allocating.
        Assert.Equal(NativeStatus.Ok, s_intercept(scene, &state, 12, null, 0, &first));
        Assert.Equal((-1, 0), (first.Player, first.Time));
        Refused("n is -1", s_intercept(scene, &state, 12, players, -1, &first));
        Refused("players is null", s_intercept(scene, &state, 12, null, 1, &first));
        Refused("seconds is 0", s_intercept(scene, &state, 0, players, 1, &first));
        Refused("out is null", s_intercept(scene, &state, 12, players, 1, null));
        players[3].Reach = double.NaN;
        Refused("players[3].reach is NaN; allowed: 0 … 1000000.", s_intercept(scene, &state, 12, players, 22, &first));
        players[3].Reach = 1;
        Assert.Equal(NativeStatus.Ok, s_intercept(scene, &state, 12, players, 22, &first));
        long before = GC.GetAllocatedBytesForCurrentThread();
        NativeStatus status = s_intercept(scene, &state, 12, players, 22, &first);
        Assert.Equal((before, NativeStatus.Ok), (GC.GetAllocatedBytesForCurrentThread(), status));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Theory]
    [InlineData("""{"position": [0, 0.11, 0], "velocity": [1, 5, -24], "spin": [0, 30, 0]}""", false, 2000)]
    [InlineData("""{"position": [0, 0.11, 0], "velocity": [1, 5, -24], "spin": [0, 30, 0], "keeper": {"position": [0, 0, -20], "heights": [0, 2.7]}, "kicks": 500, "seed": 3, "alwaysSimulate": true}""", true, 500)]
    public void Chances_to_score_are_those_of_CSharp(string json, bool hasKeeper, int kicks)
    {
        NativeScene* scene = Scene(Goal);
        var goal = new Goal { Center = new(0, 0, -20), Facing = new(0, 0, 1) };
        GoalChanceResult expected = new GoalChance(new Scene { Goals = [goal] }).Find(new GoalChanceRequest
        {
            Position = new(0, 0.11, 0),
            Velocity = new(1, 5, -24),
            Spin = new(0, 30, 0),
            Spread = new KickSpread(),
            Goal = goal,
            Keeper = hasKeeper ? new Player { Position = new(0, 0, -20), MaximumHeight = 2.7 } : null,
            Kicks = kicks,
            Seed = hasKeeper ? 3 : 0,
            AlwaysSimulate = hasKeeper,
        });
        NativeGoalChanceResult found;
        for (int i = 0; i < 2; i++)
        {
            Assert.True(Chance(scene, json, &found) == NativeStatus.Ok, Error());
            Assert.Equal(
                (expected.Scores, expected.OnTarget, expected.Covered, expected.Aside, expected.Height, expected.Time, expected.Correlation, expected.StandardError),
                (found.Scores, found.OnTarget, found.Covered, found.Aside, found.Height, found.Time, found.Correlation, found.StandardError));
            Assert.Equal(((int)expected.Method, expected.Kicks), (found.Method, found.Kicks));
        }

        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Theory]
    [InlineData("{}", "position is missing")]
    [InlineData("""{"position": [0, 0, 0], "velocity": [0, 5, -20], "goal": 1}""", "goal is 1; allowed: 0 … 0.")]
    [InlineData("""{"position": [0, 0, 0], "velocity": [0, 5, -20], "kicks": 1}""", "kicks is 1; allowed: 2 … 100000000.")]
    [InlineData("""{"position": [0, 0, 0], "velocity": [0, 5, -20], "spread": {"spedPercent": 3}}""", "spread.spedPercent is unknown")]
    [InlineData("""{"position": [0, 0, 0], "velocity": [0, 5, -20], "spread": {"speedPercent": -3}}""", "spread.speedPercent is -3; allowed: 0 … 100.")]
    public void A_request_for_a_chance_is_rejected_by_name(string json, string sentence)
    {
        NativeScene* scene = Scene(Goal);
        NativeGoalChanceResult found;
        Assert.Equal(NativeStatus.Scene, Chance(scene, json, &found));
        Assert.StartsWith(sentence, Error());
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Fact]
    public void A_fit_is_that_of_CSharp()
    {
        NativeScene* scene = Scene("{}");
        TrackPoint[] track = Track(1.4);
        TrackFitResult expected = new TrackFit().Find(track, new TrackFitRequest { Lift = true, Restitution = true, SpinDeviation = 50 });
        NativeFitResult found;
        Assert.True(Fit(scene, track, """{"also": ["lift", "restitution"], "spinDeviation": 50}""", &found) == NativeStatus.Ok, Error());
        Assert.Equal((expected.Time, expected.Position, expected.Velocity, expected.Spin), (found.Time, At(found.Position), At(found.Velocity), At(found.Spin)));
        Assert.Equal((expected.ChiSquared, expected.Probability, expected.DegreesOfFreedom, (int)expected.Verdict), (found.ChiSquared, found.Probability, found.DegreesOfFreedom, found.Verdict));
        Assert.Equal(((int)expected.GoodFor, (int)expected.Suspicions), (found.GoodFor, found.Suspicions));
        Assert.Equal((1, expected.Value(9), expected.Value(10), 1), (found.Factors[0], found.Factors[1], found.Factors[2], found.Factors[3]));
        Assert.Equal((0, expected.StandardError(9), expected.StandardError(10), 0), (found.FactorDeviations[0], found.FactorDeviations[1], found.FactorDeviations[2], found.FactorDeviations[3]));
        Assert.Equal((expected.StandardError(2), expected.StandardError(3), expected.StandardError(7)), (found.PositionDeviation[2], found.VelocityDeviation[0], found.SpinDeviation[1]));
        int identified = 0;
        int[] bits = [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11];
        for (int i = 0; i < bits.Length; i++)
        {
            identified |= expected.IsIdentified(i) ? 1 << bits[i] : 0;
        }

        Assert.Equal((identified, expected.Converged ? 1 : 0), (found.Identified, found.Converged));
        Assert.Equal(NativeStatus.Scene, Fit(scene, track, """{"also": ["mass"]}""", &found));
        Assert.StartsWith("also is", Error());
        Assert.Equal(NativeStatus.Argument, Fit(scene, track[..3], "{}", &found));
        Assert.StartsWith("track's points is 3", Error());
        Refused("times is null", s_fit(scene, null, null, null, 9, null, 0, &found));
        Refused("n is -1", s_fit(scene, null, null, null, -1, null, 0, &found));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Fact]
    public void A_fit_of_a_match_is_that_of_CSharp_and_its_scene_can_be_used()
    {
        NativeScene* scene = Scene("{}");
        TrackPoint[] track = Track(6);
        MatchFitResult expected = new MatchFit().Find(track, new MatchFitRequest { Lift = true, WindDeviation = 2 });
        NativePiece* pieces = stackalloc NativePiece[40];
        NativeFitMatchResult found;
        NativeScene* fitted;
        int count;
        byte[] text = Encoding.UTF8.GetBytes("""{"free": ["wind", "drag", "lift", "surface", "height"], "windDeviation": 2}""");
        (double[] times, double[] positions) = Arrays(track);
        fixed (double* t = times, p = positions)
        fixed (byte* json = text)
        {
            NativeStatus status = s_fitMatch(scene, t, p, null, track.Length, json, text.Length, pieces, 40, &count, &found, &fitted);
            Assert.True(status == NativeStatus.Ok, Error());
            Assert.Equal(NativeStatus.Buffer, s_fitMatch(scene, t, p, null, track.Length, json, text.Length, pieces, 1, null, null, null));
            Assert.Equal($"capacity is 1; there are {count} pieces.", Error());
            Refused("pieces is null", s_fitMatch(scene, t, p, null, track.Length, json, text.Length, null, 1, null, null, null));
        }

        Assert.Equal(expected.Pieces.Count, count);
        Assert.True(count > 3);
        for (int i = 0; i < count; i++)
        {
            MatchPiece piece = expected.Pieces[i];
            Assert.Equal(
                ((int)piece.Kind, piece.Points, piece.StartTime, piece.EndTime, piece.Rms, piece.Velocity, piece.SpinDeviation, piece.Restitution ?? 0, piece.Restitution is null ? 0 : 1),
                (pieces[i].Kind, pieces[i].Points, pieces[i].StartTime, pieces[i].EndTime, pieces[i].Rms, At(pieces[i].Velocity), At(pieces[i].SpinDeviation), pieces[i].Restitution, pieces[i].HasRestitution));
        }

        int estimated = 0;
        for (int i = 0; i < expected.Names.Count; i++)
        {
            int parameter = (int)Requests.Parameter(expected.Names[i]);
            estimated |= 1 << parameter;
            Assert.Equal((expected.Value(i), expected.StandardError(i)), (found.Values[parameter], found.Deviations[parameter]));
        }

        Assert.Equal((estimated, expected.Flights, expected.Impacts, expected.Rms, expected.Noise), (found.Estimated, found.Flights, found.Impacts, found.Rms, found.Noise));
        Assert.Equal(new Simulator(expected.Scene).SceneHash, Guard.SceneOf(fitted).Simulator.SceneHash);
        Assert.Equal(NativeStatus.Ok, s_free(fitted));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Fact]
    public void A_watched_call_has_the_same_result_and_a_cancelled_one_writes_nothing()
    {
        NativeScene* scene = Scene(Goal);
        (double[] times, double[] positions) = Arrays(Track(3));
        byte[] request = Encoding.UTF8.GetBytes("{}");
        byte[] chance = Encoding.UTF8.GetBytes("""{"position": [0, 0, 0], "velocity": [0, 4, -20], "kicks": 600, "alwaysSimulate": true}""");
        NativeFitResult plain, launch;
        NativeFitMatchResult match;
        NativeGoalChanceResult goal;
        NativeScene* fitted;
        int count;
        fixed (double* t = times, p = positions)
        fixed (byte* json = request, shot = chance)
        {
            Assert.Equal(NativeStatus.Ok, s_fit(scene, t, p, null, times.Length, json, 2, &plain));
            NativeWatch watch = New();
            Assert.Equal(NativeStatus.Ok, s_fitWatched(scene, t, p, null, times.Length, json, 2, &launch, &watch));
            Assert.Equal((1, At(plain.Velocity), At(plain.Spin)), (watch.Progress, At(launch.Velocity), At(launch.Spin)));
            Assert.Equal(NativeStatus.Ok, s_fitWatched(scene, t, p, null, times.Length, json, 2, &launch, null));
            watch = New();
            Assert.Equal(NativeStatus.Buffer, s_fitMatchWatched(scene, t, p, null, times.Length, json, 2, null, 0, null, &match, null, &watch));
            Assert.Equal(1, watch.Progress);
            watch = New();
            Assert.Equal(NativeStatus.Ok, s_chanceWatched(scene, shot, chance.Length, &goal, &watch));
            Assert.Equal((1, 600), (watch.Progress, goal.Kicks));

            watch.Cancel = 1;
            launch.Time = match.Rms = goal.Scores = -7;
            count = -7;
            fitted = scene;
            Assert.Equal(NativeStatus.Cancelled, s_fitWatched(scene, t, p, null, times.Length, json, 2, &launch, &watch));
            Assert.Equal("watch.cancel is set. The call was cancelled, and wrote no result.", Error());
            Assert.Equal(NativeStatus.Cancelled, s_fitMatchWatched(scene, t, p, null, times.Length, json, 2, null, 0, &count, &match, &fitted, &watch));
            Assert.Equal(NativeStatus.Cancelled, s_chanceWatched(scene, shot, chance.Length, &goal, &watch));
            Assert.Equal((-7, -7, -7, -7, true), (launch.Time, match.Rms, goal.Scores, count, fitted is null));

            watch.Bytes = 12;
            Refused("watch.bytes is 12; allowed: 16", s_fitWatched(scene, t, p, null, times.Length, json, 2, &launch, &watch));
        }

        Assert.Equal(NativeStatus.Ok, s_free(scene));

        static NativeWatch New() => new() { Bytes = sizeof(NativeWatch) };
    }

    [Fact]
    public void Another_thread_cancels_a_fit_that_runs()
    {
        NativeScene* scene = Scene("{}");
        (double[] times, double[] positions) = Arrays(Track(600));
        byte[] request = Encoding.UTF8.GetBytes("{}");
        NativeFitMatchResult match;
        NativeWatch* watch = (NativeWatch*)NativeMemory.AllocZeroed((nuint)sizeof(NativeWatch));
        watch->Bytes = sizeof(NativeWatch);
        nint shared = (nint)watch;
        var other = new Thread(() =>
        {
            while (Volatile.Read(ref ((NativeWatch*)shared)->Progress) < 0.01)
            {
                Thread.Sleep(1);
            }

            Volatile.Write(ref ((NativeWatch*)shared)->Cancel, 1);
        });
        other.Start();
        fixed (double* t = times, p = positions)
        fixed (byte* json = request)
        {
            Assert.Equal(NativeStatus.Cancelled, s_fitMatchWatched(scene, t, p, null, times.Length, json, 2, null, 0, null, &match, null, watch));
        }

        other.Join();
        Assert.InRange(watch->Progress, 0.01, 0.9);
        NativeMemory.Free(watch);
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    /// <summary>A ball at 50 Hz that is kicked every second, with errors of up to 2 cm.</summary>
    private static TrackPoint[] Track(double seconds)
    {
        var simulator = new Simulator();
        var log = new StepLog();
        var random = new Random(5);
        double Error() => 0.02 * ((2 * random.NextDouble()) - 1);
        BallState ball = simulator.Launch(new(0, 0.11, 0), new(1, 7, -14), new(20, 30, 0));
        var track = new List<TrackPoint>();
        for (int i = 0; i < seconds * 50; i++)
        {
            if (i % 75 == 74)
            {
                simulator.Kick(ref ball, new(3 - (i % 7), 6 + (i % 3), (i % 2 == 0 ? 1 : -1) * (12 + (i % 5))), new(10, 20, 0));
            }

            track.Add(new TrackPoint(ball.Time, ball.Position + new Vector3d(Error(), Error(), Error())));
            simulator.Step(ref ball, 0.02, log);
        }

        return [.. track];
    }

    private static (double[] Times, double[] Positions) Arrays(TrackPoint[] track) =>
        ([.. track.Select(point => point.Time)], [.. track.SelectMany(point => new[] { point.Position.X, point.Position.Y, point.Position.Z })]);

    private static NativeStatus Fit(NativeScene* scene, TrackPoint[] track, string request, NativeFitResult* into)
    {
        byte[] text = Encoding.UTF8.GetBytes(request);
        (double[] times, double[] positions) = Arrays(track);
        double[] noise = [.. track.Select(point => point.Noise)];
        fixed (double* t = times, p = positions, s = noise)
        fixed (byte* json = text)
        {
            return s_fit(scene, t, p, s, track.Length, json, text.Length, into);
        }
    }

    private static NativeStatus Chance(NativeScene* scene, string request, NativeGoalChanceResult* into)
    {
        byte[] text = Encoding.UTF8.GetBytes(request);
        fixed (byte* json = text)
        {
            return s_chance(scene, json, text.Length, into);
        }
    }

    private static NativeState Launched(NativeScene* scene)
    {
        NativeState state;
        double* numbers = stackalloc double[9] { 0, 0.11, 0, 2, 9, -18, 0, 30, 10 };
        Assert.Equal(NativeStatus.Ok, s_launch(scene, numbers, numbers + 3, numbers + 6, &state));
        return state;
    }

    private static Vector3d At(double* v) => new(v[0], v[1], v[2]);

    private static void Refused(string sentence, NativeStatus status) =>
        Assert.Equal((NativeStatus.Argument, sentence), (status, Error()[..Math.Min(sentence.Length, Error().Length)]));
}
