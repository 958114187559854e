using System.Runtime.InteropServices;
using FootballPhysics.Scenes;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>What a moved body needs is computed only when the ball may reach it. No result depends on when that is.</summary>
public sealed class LazyBodyTests
{
    private const int Count = 9;

    private static readonly string[] s_fields = ["position", "position", "velocity", "velocity", "spin", "time", "time", "orientation", "orientation"];

    /// <summary>Two worlds get the same moves; in one, everything is read and prepared after each of them.</summary>
    [Theory]
    [ProfileData]
    public void A_world_whose_bodies_are_read_after_every_move_goes_the_same_way(Profile profile)
    {
        int events = 0;
        for (int seed = 0; seed < 40; seed++)
        {
            var lazy = new Played(profile.Scene(), seed, isRead: false);
            var read = new Played(profile.Scene(), seed, isRead: true);
            for (int tick = 0; tick < 100; tick++)
            {
                lazy.Play(tick);
                read.Play(tick);
                Assert.Equal(read.Seen, lazy.Seen);
                events += lazy.Events;
            }
        }

        Assert.InRange(events, 200, int.MaxValue);
    }

    /// <summary>A resimulation takes the same steps among bodies that nobody read as among those that were read.</summary>
    [Fact]
    public void A_rollback_among_moved_bodies_finds_no_difference()
    {
        foreach (bool isRead in new[] { false, true })
        {
            var played = new Played(Scene.Default, 3, isRead);
            var runner = new FixedStepRunner(played.Simulator);
            var rollback = new Rollback(runner, 30);
            runner.Place(new Vector3d(0, 1, 0));
            for (int tick = 0; tick < 90; tick++)
            {
                if (tick % 30 == 5)
                {
                    rollback.ApplyKick(new KickInput(tick, new Vector3d(9, 4, 3 - (0.1 * tick)), new Vector3d(0, 20, 0)));
                }

                played.Move(runner.Time, runner.State.Position, tick);
                runner.Step();
                Assert.True(rollback.SyncTest(1 + Math.Min(tick, 19)) is null);
            }
        }
    }

    /// <summary>A move that is refused names its field, whether or not the body was moved at that time before, and changes nothing.</summary>
    [Fact]
    public void A_bad_move_is_refused_at_once_and_changes_nothing()
    {
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("leg", new BoxShape(default, new Vector3d(0.1, 0.5, 0.1)));
        foreach (bool isKnown in new[] { false, true })
        {
            for (int bad = 0; bad < s_fields.Length; bad++)
            {
                body.MoveTo(new Vector3d(1, 2, 3), new Vector3d(4, 5, 6), isKnown ? 0.5 : 0.25);
                RigidMotion before = body.Motion;
                long moves = bodies.Moves;
                body.MoveTo(new Vector3d(1, 2, 3), new Vector3d(4, 5, 6), 0.25);
                Vector3d position = bad == 0 ? new Vector3d(0, double.NaN, 0) : bad == 1 ? new Vector3d(0, 0, -1e6 - 1e-9) : new Vector3d(7, 8, 9);
                Vector3d velocity = bad == 2 ? new Vector3d(0, 0, double.NegativeInfinity) : bad == 3 ? new Vector3d(800, 600.0001, 0) : new Vector3d(1, 1, 1);
                Vector3d spin = bad == 4 ? new Vector3d(0, 1e5, 0) : default;
                double time = bad == 5 ? double.NaN : bad == 6 ? 1.1e12 : isKnown ? 0.5 : 0.25;
                Quaterniond orientation = bad == 7 ? default : bad == 8 ? new Quaterniond(0, 0, 0, double.NaN) : body.Orientation;
                Action move = bad is 4 or > 6 ? () => body.MoveTo(position, orientation, velocity, spin, time) : () => body.MoveTo(position, velocity, time);
                ArgumentOutOfRangeException refusal = Assert.Throws<ArgumentOutOfRangeException>(move);
                Assert.Equal(s_fields[bad], refusal.ParamName);
                Assert.StartsWith(s_fields[bad] + " is ", refusal.Message);
                Assert.Contains("; allowed: ", refusal.Message);
                Assert.True(before.IsSame(body.Motion));
                Assert.Equal(0.25, body.Time);
                Assert.InRange(bodies.Moves, moves, moves + 1);
            }
        }
    }

    /// <summary>The limits themselves are in range, although the sum of the numbers is beyond the smallest limit.</summary>
    [Fact]
    public void A_move_at_the_limits_is_taken()
    {
        KinematicBody body = new KinematicBodies().Add("leg", new SphereShape(default, 0.1));
        body.MoveTo(new Vector3d(1e6, -1e6, 1e6), new Vector3d(0, -1000, 0), -1e12);
        Assert.Equal((new Vector3d(1e6, -1e6, 1e6), new Vector3d(0, -1000, 0), -1e12), (body.Position, body.Velocity, body.Time));
        Assert.Equal((body.Position, body.Position, body.Velocity), (body.Motion.Origin, body.Motion.Pivot, body.Motion.Velocity));
    }

    /// <summary>A body that was turned is found at any rotation, before its box is known.</summary>
    [Fact]
    public void A_turned_body_is_in_the_way_of_the_ball()
    {
        var random = new Random(8);
        var bodies = new KinematicBodies();
        KinematicBody board = bodies.Add("board", new BoxShape(new Vector3d(0.7, 0.2, 0), new Vector3d(1, 0.4, 0.02)));
        for (int i = 0; i < 2000; i++)
        {
            var turn = new Quaterniond(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            board.MoveTo(new Vector3d(3, 1, 0), turn, default, default, 0);
            Vector3d corner = board.Position + board.Orientation.Rotate(new Vector3d(1.7, -0.2, 0.02));
            double free = bodies.FreeFor(corner - new Vector3d(0, 0, 5), new Vector3d(0, 0, 10), 0, 1, 0.11, ignores: 0);
            Assert.InRange(free, 0, 0.5);
        }
    }

    /// <summary>A ball among bodies that are moved at random, with look-aheads and restored states.</summary>
    private sealed class Played
    {
        private readonly Random _random;
        private readonly bool _isRead;
        private readonly StepLog _log = new();
        private readonly Trajectory _path = new();
        private BallState _state;
        private BallState _kept;

        public Played(Scene scene, int seed, bool isRead)
        {
            _random = new Random(seed);
            _isRead = isRead;
            for (int i = 0; i < Count; i++)
            {
                IShape shape = (i % 3) switch
                {
                    0 => new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.6, 0), 0.25),
                    1 => new SphereShape(new Vector3d(0.5, 0.3, 0), 0.2),
                    _ => new BoxShape(new Vector3d(0.4, 0.5, 0), new Vector3d(0.6, 0.5, 0.1)),
                };
                Bodies.Add($"body {i}", shape, SurfaceMaterial.Boot, i % 4 == 0 ? 5 : double.PositiveInfinity);
            }

            Simulator = new Simulator(scene with { Bodies = Bodies });
            _state = Simulator.Launch(Vector(2) + new Vector3d(0, 3, 0), Vector(10), Vector(30));
            _kept = _state;
        }

        public KinematicBodies Bodies { get; } = [];

        public Simulator Simulator { get; }

        public string Seen { get; private set; } = "";

        public int Events => _log.Events.Count;

        public void Play(int tick)
        {
            Move(_state.Time, _state.Position, tick);
            if (tick % 17 == 5)
            {
                Simulator.LookAhead(in _state, new LookAheadRequest { Duration = 0.5, MoveBodies = tick % 2 == 0 ? null : time => Move(time, _state.Position, 3) }, _path);
            }

            _kept = tick % 30 == 0 ? _state : _kept;
            if (tick % 30 == 20)
            {
                Bodies.MoveClock(_state.Time, _kept.Time, isNew: false);
                _state = _kept;
            }

            _log.Clear();
            Simulator.Step(ref _state, 0.01, _log);
            Seen = $"{Convert.ToHexString(MemoryMarshal.AsBytes(new ReadOnlySpan<BallState>(in _state)))} {_path.EndTime:R} {_path.Final.Position} {string.Join(' ', _log.Events.Span.ToArray().Select(item => $"{item.Time:R} {item.ColliderIndex}"))}"
                + (tick % 10 < 9 ? "" : string.Concat(Bodies.Select(body => $"{body.Position} {body.Velocity} {body.Orientation} {body.Spin} {body.Time:R} {body.IsWithdrawn}")));
        }

        /// <summary>Moves some of the bodies: near the ball or far from it, on or elsewhere, turned or not.</summary>
        public void Move(double time, Vector3d ball, int tick)
        {
            foreach (KinematicBody body in Bodies)
            {
                int kind = _random.Next(tick % 7 == 6 ? 1 : 9);
                Vector3d position = _random.Next(8) == 0 ? ball + Vector(0.8) : kind < 5 ? body.Position + ((time - body.Time) * body.Velocity) : Vector(9);
                Vector3d velocity = _random.Next(3) == 0 ? body.Velocity : Vector(4);
                if (kind is > 0 and < 6)
                {
                    body.MoveTo(position, velocity, time);
                }
                else if (kind is 6 or 7)
                {
                    var turn = new Quaterniond(_random.NextDouble(), _random.NextDouble(), _random.NextDouble() - 0.5, _random.NextDouble());
                    body.MoveTo(position, turn, velocity, kind == 6 ? default : Vector(8), time);
                }
                else if (kind == 8 && _random.Next(4) == 0)
                {
                    body.Withdraw();
                }

                if (_isRead)
                {
                    _ = body.Motion;
                    _ = body.BoundsAt(time);
                    _ = body.Placement.Refine();
                    _ = Bodies.Version + Bodies.Moves;
                }
            }
        }

        private Vector3d Vector(double size) => size * new Vector3d((2 * _random.NextDouble()) - 1, _random.NextDouble() - 0.5, (2 * _random.NextDouble()) - 1);
    }
}
