using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <content>What a game and its network ask of a runner between steps: kicks, where to draw the ball, states as bytes.</content>
public sealed partial class FixedStepRunner
{
    /// <summary>Has the ball kicked when this tick's step begins, as player 0. <see cref="Ball.Kick(Vector3d, Vector3d)"/> kicks at once; this waits for the step.</summary>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    [OverloadResolutionPriority(1)]
    public void QueueKick(Vector3d velocity, Vector3d spin, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        Kicks.Add(new KickInput(Tick, velocity, spin, ball: ball));
    }

    /// <summary>Has the ball kicked when this tick's step begins: speed, direction, and spin relative to the direction.</summary>
    /// <param name="speed">Speed, m/s; 0 … 1000.</param>
    /// <param name="direction">Direction of the kick; any length but zero.</param>
    /// <param name="topSpin">Spin about the horizontal axis across the kick, rad/s: positive dips, negative (backspin) lifts.</param>
    /// <param name="sideSpin">Spin about the vertical, rad/s: positive is counter-clockwise seen from above, and bends to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or <paramref name="topSpin"/> is given to a vertical kick; nothing has changed.</exception>
    public void QueueKick(double speed, Vector3d direction, double topSpin = 0, double sideSpin = 0)
    {
        Check.Within(nameof(speed), speed, 0, Limits.Speed);
        Vector3d unit = KickVectors.Unit(direction);
        QueueKick(speed * unit, KickVectors.Spin(unit, topSpin, sideSpin));
    }

    /// <summary>Has the ball kicked when this tick's step begins, with a kick that was found for it.</summary>
    /// <param name="kick">The kick.</param>
    public void QueueKick(in AimResult kick) => QueueKick(kick.Velocity, kick.Spin);

    /// <summary>Where to draw the ball at a fraction of the last step.</summary>
    /// <remarks>
    /// The position runs straight from the step's start to its end, through the exact points of the events between, so a bouncing
    /// ball is seen to touch the ground; the orientation turns the shorter way at constant speed, which is right below half a turn a step.
    /// </remarks>
    /// <param name="fraction">0 is the last step's start, 1 its end; what is beyond is limited to it.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
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

        // A straight way between the ends of the step would cut the corner of a bounce: it goes through the events in it.
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

        // Straight between two events; the turn is spread evenly over the whole step.
        double part = t1 > t0 ? (time - t0) / (t1 - t0) : 1;
        Quaterniond orientation = Slerp.Between(previous.Orientation, state.Orientation, fraction);
        return new BallPose(p0 + (part * (p1 - p0)), in orientation);
    }

    /// <summary>Writes a state in <see cref="Snapshot.QuantizedSize"/> bytes, where these hold it to the last bit: at the ticks of <see cref="QuantizationInterval"/>.</summary>
    /// <param name="state">The state: <see cref="State"/>, or one that a <see cref="Rollback"/> has kept.</param>
    /// <param name="destination">Where to; at least <see cref="Snapshot.QuantizedSize"/> bytes.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
    /// <returns>False where it takes all of <see cref="Snapshot.Write"/>; nothing of use is written then.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    /// <exception cref="ArgumentException"><paramref name="destination"/> is too short.</exception>
    public bool TryWriteQuantized(in BallState state, Span<byte> destination, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        return WireForm.TryWrite(SimulatorOf(ball), TimeStep, in state, destination);
    }

    /// <summary>Reads what <see cref="TryWriteQuantized"/> wrote: the same bits.</summary>
    /// <param name="source">At least <see cref="Snapshot.QuantizedSize"/> bytes; more are ignored.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    /// <exception cref="ArgumentException"><paramref name="source"/> is too short.</exception>
    /// <exception cref="FormatException">The bytes are no state.</exception>
    public BallState ReadQuantized(ReadOnlySpan<byte> source, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        return WireForm.Read(SimulatorOf(ball), TimeStep, source);
    }
}
