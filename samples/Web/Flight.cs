using FootballPhysics.Engines;
using FootballPhysics.Prediction;

namespace FootballPhysics.Web;

/// <summary>A moving ball. It is simulated ahead of the display, and passed to the page in rows of numbers.</summary>
internal sealed class Flight
{
    /// <summary>The longest story of a kick, s.</summary>
    public const double Longest = 9;

    private readonly Ball _ball;
    private readonly Keeper? _keeper;
    private readonly NetBulges _bulges;
    private readonly bool[] _moving;
    private readonly List<double> _told = [];
    private double _lastTime;
    private Vector3d _lastSpin;
    private Quaterniond _lastOrientation;

    /// <summary>Kicks a ball.</summary>
    public Flight(Setting setting, Trajectory ahead, Vector3d velocity, Vector3d spin)
    {
        _keeper = setting.NewKeeper();
        _keeper?.Watch(ahead);
        _ball = new Ball(setting.Scene(_keeper?.Bodies));
        _bulges = new NetBulges(_ball.Simulator);
        _moving = new bool[_bulges.Count];
        _ball.Kick(velocity, spin);
        Tell(_ball.State.Position, _ball.State.Velocity, _ball.State.Velocity, _ball.State.Spin, 0);
        TellKeeper();
    }

    /// <summary>Whether there is no more to come.</summary>
    public bool IsOver => _ball.Motion == MotionState.Rest || _ball.Time >= Longest;

    /// <summary>The present time of the flight, s.</summary>
    public double Time => _ball.Time;

    /// <summary>The dive that the library found for the goalkeeper; null if there is none.</summary>
    public KeeperResult? Answer => _keeper?.Answer;

    /// <summary>The name of the collider of an event.</summary>
    public string NameOf(int thing) => _ball.Simulator.NameOf(thing) ?? "";

    /// <summary>Goes on for a while, and returns what there is to tell of it: rows that begin with their kind and their length.</summary>
    public double[] Advance(double seconds)
    {
        double until = _ball.Time + seconds;
        while (_ball.Time < until && !IsOver)
        {
            _keeper?.MoveTo(_ball.Time);
            _ball.Step(Setting.TimeStep);
            foreach (BallEvent happened in _ball.Events)
            {
                Tell(happened.Position, happened.VelocityBefore, happened.Velocity, happened.Spin, happened.Time);
                _told.AddRange([(double)Row.Event, (double)happened.Kind, happened.ColliderIndex, happened.Time, happened.Position.X, happened.Position.Y, happened.Position.Z, happened.VelocityBefore.Length, happened.Velocity.Length]);
            }

            BallState state = _ball.State;
            Tell(state.Position, state.Velocity, state.Velocity, state.Spin, state.Time);
            TellKeeper();
            TellNets();
        }

        double[] told = [.. _told];
        _told.Clear();
        return told;
    }

    private void Tell(Vector3d position, Vector3d before, Vector3d velocity, Vector3d spin, double time)
    {
        Quaterniond q = _ball.State.Orientation;
        if (time < _ball.Time)
        {
            // Events within the step, with the ball's orientation at their time.
            q = (Quaterniond.FromRotationVector((time - _lastTime) * _lastSpin) * _lastOrientation).Normalized();
        }

        (_lastTime, _lastSpin, _lastOrientation) = (time, spin, q);
        _told.AddRange(
        [
            (double)Row.Key, time, position.X, position.Y, position.Z, before.X, before.Y, before.Z, velocity.X, velocity.Y, velocity.Z,
            spin.X, spin.Y, spin.Z, q.X, q.Y, q.Z, q.W, (double)_ball.Motion,
        ]);
    }

    private void TellKeeper()
    {
        if (_keeper is null)
        {
            return;
        }

        (Vector3d feet, Vector3d shoulders, Vector3d gloves) = _keeper.At(_ball.Time);
        _told.AddRange([(double)Row.Keeper, _ball.Time, feet.X, feet.Y, feet.Z, shoulders.X, shoulders.Y, shoulders.Z, gloves.X, gloves.Y, gloves.Z]);
    }

    private void TellNets()
    {
        BallState state = _ball.State;
        _bulges.Follow(in state);
        for (int net = 0; net < _bulges.Count; net++)
        {
            NetBulge bulge = _bulges[net];
            bool moves = bulge.Depth > 0.005;
            if (moves || _moving[net])
            {
                _told.AddRange([(double)Row.Bulge, _ball.Time, net, bulge.Depth, bulge.Position.X, bulge.Position.Y, bulge.Position.Z, bulge.Direction.X, bulge.Direction.Y, bulge.Direction.Z]);
            }

            _moving[net] = moves;
        }
    }

    /// <summary>The kind of a row.</summary>
    private enum Row
    {
        Key = 0,
        Event = 1,
        Keeper = 2,
        Bulge = 3,
    }
}
