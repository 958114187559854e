using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Finds the time at which two balls touch on their own steps, and their states at that time.</summary>
/// <param name="simulators">The scenes of the balls.</param>
/// <param name="trials">The paths of the balls to the end of the step.</param>
/// <param name="piles">The piles.</param>
/// <param name="pushed">The motions of all objects that balls push.</param>
internal sealed class BallTouch(Simulator[] simulators, BallTrial[] trials, BallPiles piles, PushedMotions pushed)
{
    private const int MostNewton = 12;

    private readonly BallTrial _first = new();
    private readonly BallTrial _second = new();
    private int _ball = -1;
    private int _other = -1;

    /// <summary>Returns the time at which two balls touch: Newton's method, started at the estimate from their dense paths.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="met">The contact.</param>
    /// <param name="span">The step.</param>
    /// <param name="current">The logs of the balls.</param>
    public double Locate(BallState[] states, in Happening met, in StepSpan span, StepLog[] current)
    {
        double from = Math.Max(states[met.Ball].Time, states[met.Other].Time);
        double time = Math.Max(from, met.Time);
        for (int k = 0; k < MostNewton; k++)
        {
            _ball = Look(_first, states, met.Ball, time, in span, current);
            _other = Look(_second, states, met.Other, time, in span, current);

            // A Newton step, t − f/f', on the gap between the two paths; keep it between the start of the later ball and the end of the step.
            double gap = BallContact.Gap(
                in _first.End, simulators[met.Ball].Scene.Ball.Radius, in _second.End, simulators[met.Other].Scene.Ball.Radius, out _, out double rate);
            double next = rate < 0 ? Math.Min(Math.Max(from, span.End), Math.Max(from, time - (gap / rate))) : time;
            if (Math.Abs(gap) <= ContactTolerances.BallsTouch || next == time || Math.Abs(next - met.Time) > ContactTolerances.NearbyTime)
            {
                break;
            }

            time = next;
        }

        return time;
    }

    /// <summary>Moves a ball to the time to which it was last followed, if it is unchanged.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="s">Its state.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="own">Receives its events and counts.</param>
    /// <returns>False if the state at that time is unknown.</returns>
    public bool TryTake(int ball, ref BallState s, double time, StepLog own) =>
        (ball == _ball && _first.TryTake(ref s, time, own)) || (ball == _other && _second.TryTake(ref s, time, own));

    /// <summary>Discards the stored states.</summary>
    public void Forget()
    {
        _ball = -1;
        _other = -1;
    }

    /// <summary>Follows a ball along its step to a time. The motions of the objects that it pushes are restored afterwards.</summary>
    /// <returns>The ball; −1 if it is in a pile, whose state at that time is not the ball's own, or if it is there already.</returns>
    private int Look(BallTrial look, BallState[] states, int i, double time, in StepSpan span, StepLog[] current)
    {
        ref readonly BallState s = ref states[i];
        double left = span.Left(in s, time);
        look.End = s;
        if (piles.Has(i))
        {
            look.End.Position = trials[i].At(time, out Vector3d velocity);
            look.End.Velocity = velocity;
        }

        if (piles.Has(i) || !(left > 0))
        {
            return -1;
        }

        pushed.Keep();
        look.Run(simulators[i], in s, left, StopAt.Time, haltsAtPush: false, in current[i].Spent);
        pushed.PutBack();
        return i;
    }
}
