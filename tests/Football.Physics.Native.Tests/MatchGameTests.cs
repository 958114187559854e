using System.Globalization;
using FootballPhysics.Package.Tests;

namespace FootballPhysics.Native.Tests;

/// <summary>What tests/Native/match.c prints, made by the library as C# calls it: the same game, with C#'s own runner and bodies.</summary>
public sealed class MatchGameTests
{
    private const int Players = 22;
    private const int Balls = 2;
    private const int Minute = 3600;
    private const double Step = 1.0 / 60;

    private readonly double[,] _place = new double[Players, 2];
    private readonly int[] _sinceKick = new int[Balls];
    private readonly KinematicBodies _bodies = new();
    private readonly FixedStepRunner _runner;
    private readonly BallProperties _ball;
    private readonly int _firstBody;
    private ulong _seed;
    private ulong _hash;

    public MatchGameTests()
    {
        for (int i = 0; i < Players; i++)
        {
            _place[i, 0] = (5.0 * (i % 11)) - 25;
            _place[i, 1] = i < 11 ? -10 : 10;
            _ = IsKeeper(i)
                ? _bodies.Add($"keeper {i}", new BoxShape(new(0, 1, 0), new(0.5, 1, 0.2)))
                : _bodies.Add($"player {i}", new CapsuleShape(new(0, 0.25, 0), new(0, 1.55, 0), 0.25), mass: 75);
        }

        var scene = new Scene
        {
            Goals = [new Goal { Center = new(0, 0, -52.5), Facing = new(0, 0, 1) }, new Goal { Center = new(0, 0, 52.5), Facing = new(0, 0, -1) }],
            Zones = [new Zone { Name = "area", Shape = new BoxShape(new(0, 1, -44), new(20, 1, 8.5)) }],
            Obstacles = [new Obstacle { Name = "bag", Shape = new SphereShape(new(3, 0.3, 5), 0.3), Mass = 4 }],
            Bodies = _bodies,
        };
        var simulator = new Simulator(scene);
        _ball = scene.Ball;
        _firstBody = Array.IndexOf([.. simulator.Names], "keeper 0");
        _runner = new FixedStepRunner(new BallGroup(simulator, Balls), Step, Step);
    }

    [Fact]
    public void Ten_minutes_with_22_players_have_the_hashes_of_the_file()
    {
        string lines = "";
        for (int tick = 0; tick < 10 * Minute; tick++)
        {
            Play(tick);
            lines += tick % Minute == Minute - 1 ? string.Create(CultureInfo.InvariantCulture, $"minute {(tick / Minute) + 1} {_hash:x16}\n") : "";
        }

        Repository.AssertCurrent("tests/Native/match.txt", lines);
    }

    private void Play(int tick)
    {
        BallState[] balls = [_runner.StateOf(0), _runner.StateOf(1)];
        Kick(balls);
        MovePlayers(balls, tick);
        _runner.Step();
        var impulses = new Vector3d[Players];
        foreach (ref readonly BallEvent e in _runner.Events)
        {
            int body = e.ColliderIndex >= _firstBody && e.ColliderIndex < _firstBody + Players ? e.ColliderIndex - _firstBody : -1;
            Vector3d impulse = e.Kind == BallEventKind.Impact ? _ball.Mass * (e.Velocity - e.VelocityBefore) : Vector3d.Zero;
            if (body >= 0)
            {
                impulses[body] -= impulse;
            }

            Mix(((ulong)(uint)e.Kind << 32) | (uint)e.ColliderIndex);
            Mix(((ulong)(uint)e.Ball << 32) | (uint)e.OtherBall);
            Mix((uint)body);
            Mix(e.Time);
            Mix(e.Position, e.Velocity, e.Spin, e.Normal, impulse);
            Mix(e.AddedEnergy);
        }

        for (int i = 0; i < Players; i++)
        {
            Mix(_bodies[i].Velocity, impulses[i]);
        }

        Mix(Snapshot.Hash([_runner.StateOf(0), _runner.StateOf(1)]));
    }

    private void Kick(BallState[] balls)
    {
        for (int b = 0; b < Balls; b++)
        {
            Vector3d at = balls[b].Position;
            _sinceKick[b]++;
            _ = Nearest(0, at, out double first);
            _ = Nearest(1, at, out double second);
            if (Math.Abs(at.X) > 40 || Math.Abs(at.Z) > 60 || _sinceKick[b] > 1200)
            {
                _runner.Place(new(Draw(20), 1 + Draw(1), Draw(30)), b);
                _sinceKick[b] = 0;
            }
            else if (Math.Min(first, second) < 0.8 && at.Y < 1 && _sinceKick[b] > 30)
            {
                var velocity = new Vector3d(Draw(18), 4 + Draw(4), Draw(22));
                _runner.QueueKick(velocity, new Vector3d(Draw(40), Draw(60), Draw(20)), b);
                _sinceKick[b] = 0;
            }
        }
    }

    private void MovePlayers(BallState[] balls, int tick)
    {
        int[] chasers = [Nearest(0, balls[0].Position, out _), Nearest(1, balls[1].Position, out _)];
        for (int i = 0; i < Players; i++)
        {
            int team = i / 11;
            bool chases = i == chasers[team];
            double x = chases ? balls[team].Position.X : (6.0 * (i % 11)) - 30;
            double z = chases ? balls[team].Position.Z : (team == 1 ? 9.0 : -9.0) * ((i % 3) + (IsKeeper(i) ? 5.6 : 1));
            double dx = x - _place[i, 0];
            double dz = z - _place[i, 1];
            double d = Math.Sqrt((dx * dx) + (dz * dz));
            double speed = chases ? 7 : 4;
            if (IsKeeper(i) && !chases)
            {
                dx = (balls[0].Position.X * 0.05) - _place[i, 0];
                d = Math.Sqrt((dx * dx) + (dz * dz));
            }

            Vector3d velocity = d > speed * Step ? new(speed * dx / d, 0, speed * dz / d) : Vector3d.Zero;
            double c = d > 0 ? dz / d : 1;
            double y = Math.Sqrt((1 - c) / 2);
            if (i == 5 && tick / Minute % 3 == 1)
            {
                _bodies[i].Withdraw();
            }
            else
            {
                var orientation = new Quaterniond(0, dx < 0 ? -y : y, 0, Math.Sqrt((1 + c) / 2));
                _bodies[i].MoveTo(new(_place[i, 0], 0, _place[i, 1]), orientation, velocity, new(0, IsKeeper(i) ? 2 : 0, 0), balls[0].Time);
            }

            _place[i, 0] += Step * velocity.X;
            _place[i, 1] += Step * velocity.Z;
        }
    }

    private int Nearest(int team, Vector3d ball, out double least)
    {
        int found = 11 * team;
        least = double.PositiveInfinity;
        for (int i = 11 * team; i < (11 * team) + 11; i++)
        {
            double x = ball.X - _place[i, 0];
            double z = ball.Z - _place[i, 1];
            double d = Math.Sqrt((x * x) + (z * z));
            (least, found) = d < least ? (d, i) : (least, found);
        }

        return found;
    }

    private double Draw(double size)
    {
        _seed += 0x9E3779B97F4A7C15;
        ulong z = (_seed ^ (_seed >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return size * ((2 * (((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0))) - 1);
    }

    private static bool IsKeeper(int player) => player % 11 == 0;

    private void Mix(params ReadOnlySpan<Vector3d> vectors)
    {
        foreach (Vector3d v in vectors)
        {
            Mix(v.X);
            Mix(v.Y);
            Mix(v.Z);
        }
    }

    private void Mix(double number) => Mix(BitConverter.DoubleToUInt64Bits(number));

    private void Mix(ulong word)
    {
        _hash = (_hash ^ word) * 0x9E3779B97F4A7C15;
        _hash ^= _hash >> 29;
    }
}
