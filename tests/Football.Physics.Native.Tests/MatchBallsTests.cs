using System.Runtime.InteropServices;
using System.Text;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>Matches whose balls differ in size, mass and drag, called as C calls them, and compared with C#.</summary>
public sealed unsafe class MatchBallsTests
{
    private const string Json = """
        {"balls": [{"ball": {"type": "beachBall"}}, {}, {"ball": {"mass": 0.8}}], "ballContact": {"normalRestitution": 0.5},
         "bodies": [{"name": "wall", "shape": "box", "center": [0, 0, 0], "halfSize": [3, 2, 0.1]}]}
        """;

    private static readonly delegate* unmanaged<byte*, long, int, double, NativeMatch**, NativeStatus> s_create = &Exports.MatchCreate;
    private static readonly delegate* unmanaged<NativeMatch*, NativeStatus> s_free = &Exports.MatchFree;
    private static readonly delegate* unmanaged<NativeMatch*, int, double*, NativeStatus> s_place = &Exports.MatchPlace;
    private static readonly delegate* unmanaged<NativeMatch*, int, double*, double*, NativeStatus> s_kick = &Exports.MatchKick;
    private static readonly delegate* unmanaged<NativeMatch*, int, int, NativeBody*, NativeStatus> s_move = &Exports.MatchMoveBodies;
    private static readonly delegate* unmanaged<NativeMatch*, int, int, NativeBody*, NativeStatus> s_bodies = &Exports.MatchReadBodies;
    private static readonly delegate* unmanaged<NativeMatch*, NativeMatchEvent*, int, int*, NativeStatus> s_step = &Exports.MatchStep;
    private static readonly delegate* unmanaged<NativeMatch*, int, NativeScene*, NativeState*, NativeStatus> s_state = &Exports.MatchState;
    private static readonly delegate* unmanaged<NativeMatch*, ulong> s_hash = &Exports.MatchHash;
    private static readonly delegate* unmanaged<NativeMatch*, CByte*, long, long*, NativeStatus> s_save = &Exports.MatchSave;
    private static readonly delegate* unmanaged<NativeMatch*, CByte*, long, NativeStatus> s_restore = &Exports.MatchRestore;
    private static readonly delegate* unmanaged<byte*, long, NativeScene**, NativeStatus> s_createScene = &Exports.SceneCreate;
    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_freeScene = &Exports.SceneFree;

    private static readonly BallProperties[] s_kinds = [BallProperties.BeachBall, BallProperties.Modern, BallProperties.Modern with { Mass = 0.8 }];

    [Fact]
    public void Different_balls_have_the_bits_of_CSharp_and_impulses_by_their_own_mass()
    {
        NativeMatch* match = Create(Json, 3);
        var bodies = new KinematicBodies();
        KinematicBody wall = bodies.Add("wall", new FootballPhysics.Shapes.BoxShape(Vector3d.Zero, new Vector3d(3, 2, 0.1)), SurfaceMaterial.Boot);
        var scene = new Scene { Bodies = bodies };
        var runner = new FixedStepRunner(new BallGroup(scene, s_kinds, null, SurfaceMaterial.Ball with { NormalRestitution = 0.5 }), 1.0 / 60, 1.0 / 60);
        NativeMatchEvent* events = stackalloc NativeMatchEvent[64];
        NativeBody body;
        Assert.Equal(NativeStatus.Ok, s_bodies(match, 0, 1, &body));
        body.Position[2] = -8;
        Assert.Equal(NativeStatus.Ok, s_move(match, 0, 1, &body));
        wall.MoveTo(new Vector3d(0, 0, -8), Vector3d.Zero, 0);
        Kick(match, runner, 1, new Vector3d(-8, 0.5, -0.5));
        Kick(match, runner, 2, new Vector3d(0, 3, -16));
        var pairs = new Dictionary<double, Vector3d>();
        int hits = 0;
        for (int tick = 0; tick < 180; tick++)
        {
            int count;
            Assert.Equal(NativeStatus.Ok, s_step(match, events, 64, &count));
            runner.Step();
            Assert.Equal(Snapshot.Hash([runner.StateOf(0), runner.StateOf(1), runner.StateOf(2)]), s_hash(match));
            for (int i = 0; i < count; i++)
            {
                var before = new Vector3d(events[i].Event.VelocityBefore[0], events[i].Event.VelocityBefore[1], events[i].Event.VelocityBefore[2]);
                var after = new Vector3d(events[i].Event.Velocity[0], events[i].Event.Velocity[1], events[i].Event.Velocity[2]);
                var impulse = new Vector3d(events[i].Impulse[0], events[i].Impulse[1], events[i].Impulse[2]);
                bool isImpact = events[i].Event.Kind == (int)BallEventKind.Impact;
                Assert.Equal(isImpact ? s_kinds[events[i].Ball].Mass * (after - before) : Vector3d.Zero, impulse);
                hits += events[i].Body == 0 ? 1 : 0;
                if (isImpact && events[i].OtherBall >= 0)
                {
                    // The two events of an impact between balls have opposite impulses.
                    pairs[events[i].Event.Time] = pairs.GetValueOrDefault(events[i].Event.Time) + impulse;
                }
            }
        }

        Assert.NotEmpty(pairs);
        Assert.All(pairs.Values, sum => Assert.InRange(sum.Length, 0, 1e-12));
        Assert.True(hits > 0);
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    [Fact]
    public void A_saved_match_is_restored_only_with_the_same_balls()
    {
        NativeMatch* match = Create(Json, 3);
        NativeMatch* equal = Create("""{"bodies": [{"name": "wall", "shape": "box", "center": [0, 0, 0], "halfSize": [3, 2, 0.1]}]}""", 3);
        double* velocity = stackalloc double[3] { 0, 8, -20 };
        double* spin = stackalloc double[3];
        Assert.Equal(NativeStatus.Ok, s_kick(match, 0, velocity, spin));
        long size;
        Assert.Equal(NativeStatus.Buffer, s_save(match, null, 0, &size));
        byte[] bytes = new byte[size];
        fixed (byte* at = bytes)
        {
            Assert.Equal(NativeStatus.Ok, s_save(match, (CByte*)at, size, null));
            for (int tick = 0; tick < 30; tick++)
            {
                Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
            }

            ulong hash = s_hash(match);
            Assert.Equal(NativeStatus.Ok, s_restore(match, (CByte*)at, size));
            for (int tick = 0; tick < 30; tick++)
            {
                Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
            }

            Assert.Equal(hash, s_hash(match));
            Assert.Equal(NativeStatus.Argument, s_restore(equal, (CByte*)at, size));
            Assert.StartsWith("bytes belong to another match.", Error());
        }

        Assert.Equal(NativeStatus.Ok, s_free(match));
        Assert.Equal(NativeStatus.Ok, s_free(equal));
    }

    [Fact]
    public void A_ball_in_a_scene_is_where_it_is_in_the_match()
    {
        NativeMatch* match = Create(Json, 3);
        NativeScene* scene;
        fixed (byte* at = "{\"ball\": {\"type\": \"beachBall\"}}"u8)
        {
            Assert.Equal(NativeStatus.Ok, s_createScene(at, 31, &scene));
        }

        NativeState state;
        double* place = stackalloc double[3] { 1, 5, 2 };
        Assert.Equal(NativeStatus.Ok, s_place(match, 0, place));
        Assert.Equal(NativeStatus.Ok, s_state(match, 0, scene, &state));
        Assert.Equal(new Vector3d(1, 5, 2), ((BallState*)&state)->Position);
        Assert.Equal(NativeStatus.Argument, s_state(match, 3, scene, &state));
        Assert.StartsWith("ball is 3; allowed: 0 … 2.", Error());
        Assert.Equal(NativeStatus.Ok, s_freeScene(scene));
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    [Theory]
    [InlineData("""{"balls": [{}, {}]}""", "balls is 2 balls; allowed: 3, the number of balls of the match; or leave it out.")]
    [InlineData("""{"balls": []}""", "balls is []; allowed: one ball or more")]
    [InlineData("""{"balls": [{}, {"bal": 1}, {}]}""", "balls[1].bal is unknown")]
    [InlineData("""{"balls": [{}, {}, {"ball": {"mass": -1}}]}""", "balls[2].ball.mass is -1; allowed: ")]
    [InlineData("""{"ballContact": {"normalRestitution": 2}}""", "ballContact.normalRestitution is 2; allowed: ")]
    public void Balls_that_are_refused_have_a_sentence(string json, string sentence)
    {
        byte[] text = Encoding.UTF8.GetBytes(json);
        NativeMatch* match;
        fixed (byte* at = text)
        {
            Assert.Equal(NativeStatus.Scene, s_create(at, text.Length, 3, 1.0 / 60, &match));
        }

        Assert.True(match is null);
        Assert.StartsWith(sentence, Error());
    }

    private static void Kick(NativeMatch* match, FixedStepRunner runner, int ball, Vector3d velocity)
    {
        double* v = stackalloc double[3] { velocity.X, velocity.Y, velocity.Z };
        double* spin = stackalloc double[3];
        Assert.Equal(NativeStatus.Ok, s_kick(match, ball, v, spin));
        runner.QueueKick(velocity, default, ball);
    }

    private static NativeMatch* Create(string json, int balls)
    {
        byte[] text = Encoding.UTF8.GetBytes(json);
        NativeMatch* match;
        fixed (byte* at = text)
        {
            NativeStatus status = s_create(at, text.Length, balls, 1.0 / 60, &match);
            Assert.True(status == NativeStatus.Ok, Error());
        }

        return match;
    }
}
