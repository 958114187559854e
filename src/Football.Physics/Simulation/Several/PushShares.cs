namespace Football.Physics;

/// <summary>The balls that can reach an object that is pushed in a step and that another ball can reach as well: only their steps end at a push.</summary>
/// <param name="pushed">The motions of all objects that balls push.</param>
/// <param name="simulators">The scenes of the balls.</param>
/// <param name="before">The balls before the step.</param>
/// <param name="reaches">Not less than the distance that each ball gets from there, m.</param>
internal sealed class PushShares(PushedMotions pushed, Simulator[] simulators, BallState[] before, double[] reaches)
{
    private readonly bool[] _shares = new bool[before.Length];

    /// <summary>True if a ball shares an object.</summary>
    public bool this[int ball] => _shares[ball];

    /// <summary>No ball shares an object.</summary>
    public void Clear() => Array.Clear(_shares, 0, _shares.Length);

    /// <summary>All balls share an object.</summary>
    public void Fill() => _shares.AsSpan().Fill(true);

    /// <summary>Finds the balls that share an object, after the step was taken.</summary>
    /// <param name="motions">The motions of all objects before the step.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <returns>Whether there are balls that were not known to share an object.</returns>
    public bool Find(MotionsBefore motions, double dt)
    {
        bool found = false;
        pushed.BeginPushes(motions);
        while (pushed.NextPush(before[0].Time, dt, out Bounds3d box))
        {
            int first = -1;
            for (int i = 0; i < before.Length; i++)
            {
                if (!box.Grown(reaches[i] + simulators[i].Scene.Ball.Radius).Touches(new Bounds3d(before[i].Position, before[i].Position)))
                {
                    continue;
                }

                // The first one shares it as soon as there is a second one.
                found |= first >= 0 && (!_shares[first] || !_shares[i]);
                if (first >= 0)
                {
                    _shares[first] = true;
                    _shares[i] = true;
                }

                first = first < 0 ? i : first;
            }
        }

        return found;
    }
}
