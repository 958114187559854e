using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <content>The limits of the modes.</content>
internal sealed partial class TouchingBalls
{
    /// <summary>Modes hold where they were found, and no longer when one quantity after another is put beyond its limit.</summary>
    /// <returns>The number of limits passed.</returns>
    public int CheckLimits(string when)
    {
        // A slip or a spin that has only just started is at its limit already.
        for (int k = 0; k < _system.ContactCount; k++)
        {
            ref readonly ClusterContact contact = ref _system.Contacts[k];
            ref readonly SetContact on = ref contact.On;
            if ((on.Bears && !on.Sticks && on.Sliding > 0 && on.Slip.Length < 1e-3) || (on.Bears && on.Sticks && on.Grip < 1e-6)
                || (contact.Second >= 0 && !contact.HoldsTwist && contact.Lever > 0 && Math.Abs(AboutOf(k, 0)) < 1e-3))
            {
                return 0;
            }
        }

        for (int i = 0; i < _system.Count; i++)
        {
            ref readonly ClusterBall ball = ref _system.Balls[i];
            if (ball.Bearer >= 0 && !ball.HoldsSpin && Math.Abs(Vector3d.Dot(_spins[i], NormalOf(ball.Bearer, 0)) - _system.Contacts[ball.Bearer].On.CarrierSpin) < 1e-3)
            {
                return 0;
            }
        }

        Assert.True(ClusterModes.Hold(_system), when);
        int ends = 0;
        for (int k = 0; k < _system.ContactCount; k++)
        {
            ClusterContact before = _system.Contacts[k];
            ref ClusterContact contact = ref _system.Contacts[k];
            string at = FormattableString.Invariant($"{when}, contact {k}");
            if (!before.On.Bears)
            {
                contact.Gap = -1e-6;
                Ends($"{at} overlaps");
                contact.Gap = 0;
                contact.On.Opening = -1;
                Ends($"{at} closes");
                contact.Gap = 1e-6;
                Assert.True(ClusterModes.Hold(_system), $"{at} is open");
                contact = before;
                continue;
            }

            contact.On.Load = -before.On.Load;
            Ends($"{at} pulls");
            contact = before;
            if (before.On.Sticks)
            {
                contact.On.Friction = before.On.Friction + (2 * before.On.Sliding * before.On.Load * before.On.First);
                Ends($"{at} slips");
            }
            else if (before.On.Sliding > 0)
            {
                contact.On.Direction = -before.On.Direction;
                Ends($"{at} stops");
            }

            contact = before;
            if (before.Second >= 0 && before.Lever > 0)
            {
                contact.Twist = 1.001 * before.Lever * before.On.Load;
                contact.TwistSign = -before.TwistSign;
                Ends($"{at} turns");
            }

            contact = before;
        }

        for (int i = 0; i < _system.Count; i++)
        {
            ClusterBall before = _system.Balls[i];
            ref ClusterBall ball = ref _system.Balls[i];
            ball.Bearer = before.Bearer < 0 ? 0 : -1;
            Ends($"{when}, bearer of ball {i}");
            ball = before;
            if (before.Bearer < 0)
            {
                continue;
            }

            ref readonly SetContact on = ref _system.Contacts[before.Bearer].On;
            if (on.Drilling > 0)
            {
                ball.HeldSpin = 1.001 * on.Drilling * before.PerMass * on.Load;
                ball.SpinSign = -before.SpinSign;
                Ends($"{when}, spin of ball {i}");
            }

            ball = before;
            if (on.Sticks)
            {
                ball.Along = -before.Along;
                Ends($"{when}, roll of ball {i}");
            }

            ball = before;
        }

        Assert.True(ClusterModes.Hold(_system), when);
        return ends;

        void Ends(string what)
        {
            Assert.False(ClusterModes.Hold(_system), what);
            ends++;
        }
    }
}
