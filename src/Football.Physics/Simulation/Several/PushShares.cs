using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Finds the balls that can reach a pushed object, or see it in their search for bodies, if another ball can do so as well.</summary>
/// <remarks>Only the steps of these balls end at a push. For the others, it does not matter whether the object has been pushed.</remarks>
/// <param name="pushed">The motions of all objects that balls push.</param>
/// <param name="simulators">The scenes of the balls.</param>
/// <param name="before">The balls before the step.</param>
internal sealed class PushShares(PushedMotions pushed, Simulator[] simulators, BallState[] before)
{
    /// <summary>Safety factor of the estimated reach.</summary>
    private const double MoreReach = 1.1;

    private readonly double[] _reaches = new double[before.Length];
    private readonly Sweep[] _sweeps = new Sweep[before.Length];
    private readonly double[] _searches = new double[before.Length];
    private readonly bool[] _shares = new bool[before.Length];

    /// <summary>True if a ball shares an object with another ball.</summary>
    public bool this[int ball] => _shares[ball];

    /// <summary>Sets an upper bound of the ball's displacement in the step, m.</summary>
    /// <remarks>
    /// It depends on this step alone, because a repeated step must end at the same pushes. The spheres of neighbours depend on earlier
    /// steps.
    /// </remarks>
    /// <param name="ball">The ball.</param>
    /// <param name="after">The ball after its own step.</param>
    /// <param name="fastest">Its greatest speed at the events of the step, m/s.</param>
    public void Begin(int ball, in BallState after, double fastest)
    {
        ref readonly BallState from = ref before[ball];

        // Movers give a squeezed ball at most twice their speed, without an event.
        bool isSqueezed = from.Motion == MotionState.Pinned || after.Motion == MotionState.Pinned;
        double most = Math.Max(fastest, isSqueezed ? 2.0 * simulators[ball].World.FastestMover : 0);

        // Only a step with a push needs the roots.
        _sweeps[ball] = new Sweep
        {
            Speed = Math.Max(Math.Max(from.Velocity.LengthSquared, after.Velocity.LengthSquared), most * most),
            Spin = Math.Max(SpinOf(in from), SpinOf(in after)),
            Way = (after.Position - from.Position).LengthSquared,
        };
        _reaches[ball] = 0;
    }

    /// <summary>Raises the bound of a ball's displacement, m.</summary>
    public void Extend(int ball, double reach) => _reaches[ball] = Math.Max(_reaches[ball], reach);

    /// <summary>Marks no ball as sharing an object.</summary>
    public void Clear() => Array.Clear(_shares, 0, _shares.Length);

    /// <summary>Marks all balls as sharing an object.</summary>
    public void Fill() => _shares.AsSpan().Fill(true);

    /// <summary>Finds the balls that share an object, after the step.</summary>
    /// <param name="motions">The motions of all objects before the step.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <returns>True if it found new ones.</returns>
    public bool Find(MotionSnapshot motions, double dt)
    {
        bool found = false;
        for (int i = 0; i < before.Length; i++)
        {
            ref readonly Sweep sweep = ref _sweeps[i];
            double speed = MoreReach * (Math.Sqrt(sweep.Speed) + (BallNeighbours.Fall * dt));
            double reach = Math.Max(_reaches[i], (MoreReach * Math.Sqrt(sweep.Way)) + (dt * speed));
            _searches[i] = reach + simulators[i].SearchMargin(speed, MoreReach * Math.Sqrt(sweep.Spin), dt);
        }

        pushed.BeginPushes(motions, before[0].Time, dt);
        while (pushed.NextPush(before[0].Time, dt, out Bounds3d box))
        {
            int first = -1;
            for (int i = 0; i < before.Length; i++)
            {
                if (!box.Expanded(_searches[i]).Intersects(new Bounds3d(before[i].Position, before[i].Position)))
                {
                    continue;
                }

                // Once a second ball pushes the object, the first one shares it too.
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

    private static double SpinOf(in BallState s) => s.Flight.Axis.LengthSquared * s.Flight.SpinRate * s.Flight.SpinRate;

    /// <summary>The squares of a ball's greatest speed and spin, and of its displacement in the step.</summary>
    private struct Sweep
    {
        public double Speed;
        public double Spin;
        public double Way;
    }
}
