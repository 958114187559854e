using System.Runtime.CompilerServices;
using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <content>Kicks, restarts and drawing poses, for use between steps.</content>
public sealed partial class FixedStepRunner
{
    /// <summary>Queues a kick for the start of this tick's step, as player 0.</summary>
    /// <remarks><see cref="Ball.Kick(Vector3d, Vector3d)"/> kicks immediately; this method kicks at the start of the step.</remarks>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    [OverloadResolutionPriority(1)]
    public void QueueKick(Vector3d velocity, Vector3d spin, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        Kicks.Add(new KickInput(Tick, velocity, spin, ball: ball));
    }

    /// <summary>Queues a kick for the start of this tick's step, given by speed, direction, and spin relative to the direction.</summary>
    /// <param name="speed">The speed, in m/s; 0 … 1000.</param>
    /// <param name="direction">The direction of the kick; any length except zero.</param>
    /// <param name="topSpin">The spin about the horizontal axis across the kick, in rad/s: topspin (positive) makes the ball dip, backspin lifts it.</param>
    /// <param name="sideSpin">The spin about the vertical, in rad/s: positive is counter-clockwise seen from above, and bends the path to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or <paramref name="topSpin"/> is nonzero for a vertical kick; nothing has changed.</exception>
    public void QueueKick(double speed, Vector3d direction, double topSpin = 0, double sideSpin = 0)
    {
        Check.Within(nameof(speed), speed, 0, Limits.Speed);
        Vector3d unit = KickVectors.Unit(direction);
        QueueKick(speed * unit, KickVectors.Spin(unit, topSpin, sideSpin));
    }

    /// <summary>Queues a kick from an aiming search for the start of this tick's step.</summary>
    /// <param name="kick">The kick.</param>
    public void QueueKick(in AimResult kick) => QueueKick(kick.Velocity, kick.Spin);

    /// <summary>Places the ball with zero velocity and spin at this tick, and discards its pending kicks and restarts.</summary>
    /// <remarks>The clock restarts at 0; with several balls, the common clock continues. A ball placed above the ground falls. Pending kicks were aimed
    /// from the old position, so the ball's inputs for this tick and later ones are removed. With a <see cref="Rollback"/>, use a <see cref="PlaceInput"/>
    /// (<see cref="QueuePlace"/> or <see cref="Rollback.ApplyPlace"/>), which belongs to a tick.</remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component, or the index of the ball, is out of range; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">A <see cref="Rollback"/> is attached; nothing has changed.</exception>
    public void Place(Vector3d position, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        Check.Place("launch.position", position);
        if (Rollback is not null)
        {
            throw new InvalidOperationException("Place would discard the history of the Rollback that is attached to this runner. Restart with a PlaceInput instead: call QueuePlace, or Rollback.ApplyPlace.");
        }

        // The balls of a group share one clock; a single ball restarts its clock. Bodies continue from their current positions.
        double time = _group is null ? 0 : Time;
        _simulator.World.Bodies?.MoveClock(Time, time, isNew: true);
        BallState placed = Ball.AtRest(SimulatorOf(ball), in position, time);
        Kicks.RemoveFrom(Tick, ball);
        Array.Copy(_states, _before, _states.Length);
        _before[ball] = placed;
        GoTo(Tick, _before);
    }

    /// <summary>Queues a restart for the start of this tick's step, as player 0.</summary>
    /// <remarks><see cref="PlaceInput"/> describes the order of inputs. Unlike <see cref="Place"/>, this method keeps the clock, the kicks and the history of a
    /// <see cref="Rollback"/>.</remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000. Default 0.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000. Default 0.</param>
    /// <param name="orientation">The orientation, of any length except zero. Default null: the identity.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void QueuePlace(Vector3d position, Vector3d velocity = default, Vector3d spin = default, Quaterniond? orientation = null, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        Kicks.Add(new PlaceInput(Tick, 0, ball, position, velocity, spin, orientation));
    }

    /// <summary>Returns the pose in which to draw a ball after <see cref="Advance"/>.</summary>
    /// <param name="ball">The index of the ball, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public BallPose PoseOf(int ball) => PoseAt(Fraction, ball);

    /// <summary>Returns the pose in which to draw the ball, at a fraction of the last step.</summary>
    /// <remarks>The position is interpolated linearly from the start of the step to its end, through the exact positions of the events in between. A bouncing
    /// ball therefore visibly touches the ground. The orientation turns at constant speed along the shorter rotation, which is correct up to half a turn per step.</remarks>
    /// <param name="fraction">0 is the start of the last step, 1 is its end. The value is clamped to this range.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public BallPose PoseAt(double fraction, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        BallState state = _states[ball];
        ref readonly BallState previous = ref _previous[ball];
        double span = state.Time - previous.Time;
        if (!(fraction < 1) || !(span > 0))
        {
            return new BallPose(state.Position, state.Orientation);
        }

        // A straight line between the ends of the step would cut the corner of a bounce: interpolate through the events.
        fraction = fraction > 0 ? fraction : 0;
        double time = previous.Time + (fraction * span);
        double t0 = previous.Time;
        double t1 = state.Time;
        Vector3d p0 = previous.Position;
        Vector3d p1 = state.Position;
        for (int i = 0; i < _log.Events.Count; i++)
        {
            ref readonly BallEvent happened = ref _log.Events[i];
            if (happened.Ball != ball)
            {
                continue;
            }

            if (happened.Time > time)
            {
                t1 = happened.Time;
                p1 = happened.Position;
                break;
            }

            t0 = happened.Time;
            p0 = happened.Position;
        }

        // Interpolate linearly between two events, and spread the rotation evenly over the entire step.
        double part = t1 > t0 ? (time - t0) / (t1 - t0) : 1;
        Quaterniond orientation = Slerp.Between(previous.Orientation, state.Orientation, fraction);
        return new BallPose(p0 + (part * (p1 - p0)), in orientation);
    }
}
