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

    private readonly BallLook _first = new();
    private readonly BallLook _second = new();

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
            Look(_first, states, met.Ball, time, in span, current);
            Look(_second, states, met.Other, time, in span, current);

            // A Newton step, t − f/f', on the gap between the two paths; keep it between the start of the later ball and the end of the step.
            double gap = BallContact.Gap(
                in _first.State, simulators[met.Ball].Scene.Ball.Radius, in _second.State, simulators[met.Other].Scene.Ball.Radius, out _, out double rate);
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
    public bool TryTake(int ball, ref BallState s, double time, StepLog own)
    {
        bool taken = _first.TryTake(ball, ref s, time, own) || _second.TryTake(ball, ref s, time, own);
        return taken;
    }

    /// <summary>Discards the stored states.</summary>
    public void Forget()
    {
        _first.Forget();
        _second.Forget();
    }

    private void Look(BallLook look, BallState[] states, int i, double time, in StepSpan span, StepLog[] current)
    {
        ref readonly BallState s = ref states[i];
        if (piles.Has(i))
        {
            look.Forget();
            look.State = s;
            look.State.Position = trials[i].At(time, out Vector3d velocity);
            look.State.Velocity = velocity;
            return;
        }

        look.Follow(simulators[i], i, in s, span.Left(in s, time), current[i].Spent, pushed);
    }
}
