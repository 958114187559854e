using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>The tube along a ball's way in which no body is: for how long, how wide, how fast a ball it is good.</summary>
public sealed class BodyTubeTests
{
    private const double Step = 0.01;
    private const double Ahead = 0.16;
    private const double Bend = 0.4;
    private const double Width = 0.1 + (0.5 * Bend);
    private const double Around = 0.26;
    private const double AirSpeed = 12;
    private const double Spin = 30;
    private const double Friction = 1.4;

    private static readonly Simulator Nowhere = new(Scene.Default with { Ground = Ground.None });
    private static readonly Vector3d From = new(1, 2, 3);
    private static readonly Vector3d Velocity = new(5, -4, 3);

    [Fact]
    public void A_ball_on_its_way_stays_in_it_to_its_end_and_no_longer()
    {
        BodyTube tube = Made(new KinematicBodies());
        Assert.True(Holds(tube, 0, Step));
        Assert.True(Holds(tube, Ahead - Step - 1e-12, Step));
        Assert.False(Holds(tube, Ahead - Step + 1e-9, Step));
        Assert.False(Holds(tube, -1e-9, Step));
        Assert.True(Holds(tube, 0.05, Step / 2));
        Assert.False(Holds(tube, 0.05, Step * 1.001));
        BallState s = At(0.05, default, default);
        Assert.True(tube.Holds(in s, Step, AirSpeed * AirSpeed, Spin, Friction));
        Assert.False(tube.Holds(in s, Step, (AirSpeed * AirSpeed) + 1e-9, Spin, Friction));
        Assert.False(tube.Holds(in s, Step, AirSpeed * AirSpeed, Spin + 1e-9, Friction));
        Assert.False(tube.Holds(in s, Step, AirSpeed * AirSpeed, Spin, Friction + 1e-9));
    }

    /// <summary>How far it is off the way, and how far its velocity takes it off in the step: each direction counts, and the sum of them is the width at most.</summary>
    [Fact]
    public void A_ball_off_the_way_is_in_it_up_to_its_width()
    {
        BodyTube tube = Made(new KinematicBodies());
        Vector3d[] ways = [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1), new(0.5, 0.5, 0), new(0.2, -0.3, 0.5), new(-0.5, 0, 0.5)];
        foreach (Vector3d way in ways)
        {
            foreach ((double share, bool holds) in new[] { (0.999, true), (1.001, false) })
            {
                foreach (double time in new[] { 0, 0.1 })
                {
                    BallState off = At(time, share * Width * way, default);
                    Assert.Equal(holds, tube.Holds(in off, Step, 0, 0, 1));
                    BallState turned = At(time, default, share * Width / Step * way);
                    Assert.Equal(holds, tube.Holds(in turned, Step, 0, 0, 1));
                    BallState both = At(time, 0.5 * share * Width * way, 0.5 * share * Width / Step * way);
                    Assert.Equal(holds, tube.Holds(in both, Step, 0, 0, 1));
                }
            }
        }
    }

    /// <summary>Every move of a body may bring it into the tube, so the tube ends; a motion that is restored as it was does not end it.</summary>
    [Fact]
    public void A_move_or_a_push_of_a_body_ends_it()
    {
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("far", new SphereShape(default, 0.2));
        body.MoveTo(new Vector3d(50, 50, 50), default, 0);
        Action[] moves =
        [
            () => body.MoveTo(new Vector3d(50, 50, 50.001), default, 0), () => body.MoveTo(new Vector3d(50, 50, 50), default, 0),
            () => body.MoveTo(new Vector3d(50, 50, 50), Quaterniond.Identity, default, new Vector3d(0, 1, 0), 0),
            () => body.Push(new Vector3d(1, 0, 0), 0.01), () => body.Motion = body.Motion with { Time = 3 },
        ];
        foreach (Action move in moves)
        {
            BodyTube tube = Made(bodies);
            BallState s = At(0, new Vector3d(Width / 2, 0, 0), default);
            Assert.True(tube.Holds(in s, Step, 0, 0, 1));
            body.Motion = body.Motion;
            Assert.True(tube.Holds(in s, Step, 0, 0, 1));
            Assert.True(tube.IsWorthwhile);
            move();
            Assert.False(tube.Holds(in s, Step, 0, 0, 1));
            Assert.False(tube.IsWorthwhile);
        }
    }

    /// <summary>Up to a body in its way it is free; how near one may be beside it: the margin of a step, its width and the rounding.</summary>
    [Theory]
    [InlineData(0.26)]
    [InlineData(0.43)]
    public void It_ends_where_a_body_comes_near(double ofStep)
    {
        var push = new FlightPush(AirSpeed * AirSpeed, 0, 1);
        double around = ofStep + Width + 1e-6;
        foreach ((double extra, bool free) in new[] { (1e-7, true), (-1e-7, false) })
        {
            // A slab beside the way: at the start of it, for the whole time.
            var bodies = new KinematicBodies();
            KinematicBody slab = bodies.Add("slab", new BoxShape(default, new Vector3d(20, 1, 20)));
            slab.MoveTo(new Vector3d(0, -1 - around - extra, 0), default, 0);
            var tube = new BodyTube(bodies, ignores: 0);
            BallState s = Nowhere.Launch(default, new Vector3d(5, 0, 0), default);
            Assert.Equal(free, tube.Renew(in s, in push, Step, Step, Ahead, Width, ofStep));
            Assert.Equal(free, tube.Holds(in s, Step, 0, 0, 1));
        }

        // A wall that the way reaches after 0.05 s.
        var walls = new KinematicBodies();
        KinematicBody wall = walls.Add("wall", new BoxShape(default, new Vector3d(1, 20, 20)));
        wall.MoveTo(new Vector3d(1 + around + (5 * 0.05), 0, 0), default, 0);
        var way = new BodyTube(walls, ignores: 0);
        BallState ball = Nowhere.Launch(default, new Vector3d(5, 0, 0), default);
        Assert.True(way.Renew(in ball, in push, 0.05 - 1e-6, 0.05, Ahead, Width, ofStep));
        Assert.True(way.Holds(in ball, 0.05 - 1e-6, 0, 0, 1));
        Assert.False(way.Renew(in ball, in push, 0.05 + 1e-6, 0.06, Ahead, Width, ofStep));
        Assert.False(way.Holds(in ball, 0.05 + 1e-6, 0, 0, 1));

        // A search for one step is good for no other one.
        Assert.True(way.Renew(in ball, in push, Step, Step, Ahead, Width, ofStep));
        Assert.True(way.IsFree(in ball, Step, ofStep));
        Assert.False(way.Holds(in ball, Step, 0, 0, 1));
        Assert.False(way.Holds(in ball, 0, 0, 0, 1));
        Assert.False(way.IsFree(in ball, 0.2, ofStep));
    }

    private static bool Holds(BodyTube tube, double time, double dt)
    {
        BallState s = At(time, default, default);
        return tube.Holds(in s, dt, AirSpeed * AirSpeed, Spin, Friction);
    }

    private static BallState At(double time, Vector3d off, Vector3d faster)
    {
        BallState s = Nowhere.Launch(From + (time * Velocity) + off, Velocity + faster, default);
        s.Time = 2 + time;
        return s;
    }

    private static BodyTube Made(KinematicBodies bodies)
    {
        var tube = new BodyTube(bodies, ignores: 0);
        BallState s = At(0, default, default);
        Assert.True(tube.Renew(in s, new FlightPush(AirSpeed * AirSpeed, Spin, Friction), Step, Step, Ahead, Width, Around));
        return tube;
    }
}
