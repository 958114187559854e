using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Batch;

/// <summary>The map of an impact from the motion before to the motion after, with derivatives by difference quotients of the simulation's own impact.</summary>
internal sealed class ImpactMap(Surroundings around)
{
    private const double TimeWidth = 1e-6;

    /// <summary>The number of times, and the factor, by which a difference is narrowed if its two sides behave differently.</summary>
    private const int MostTries = 4;
    private const double Narrower = 0.1;

    private readonly World _world = around.World;
    private readonly WorldContact _contact = new(around, gainsByHops: false);
    private readonly StepLog _log = new() { IgnoresZones = true };

    /// <summary>The derivative of the motion by the time of the impact, which is not zero if the object moves.</summary>
    public Motion TimeRate { get; private set; }

    /// <summary>Applies an impact.</summary>
    /// <param name="s">The ball before the impact; on return, after it.</param>
    /// <param name="thing">The index of the object.</param>
    /// <param name="map">∂y'/∂y.</param>
    /// <returns>The number of impacts: the supporting surface may add one at the same time.</returns>
    public int Impact(ref BallState s, int thing, double[] map)
    {
        Motion at = MotionVector.Of(in s);
        Clear(map);
        for (int i = 0; i < MotionVector.AirDistance; i++)
        {
            Difference(in s, in at, i, thing, map);
        }

        if (_world.Moves)
        {
            Motion later = Hit(in s, in at, TimeWidth, thing, out _);
            Motion sooner = Hit(in s, in at, -TimeWidth, thing, out _);
            const double PerWidth = 0.5 / TimeWidth;
            TimeRate = new Motion(PerWidth * (later.Position - sooner.Position), PerWidth * (later.Velocity - sooner.Velocity), PerWidth * (later.Spin - sooner.Spin));
        }

        return Hit(ref s, thing);
    }

    private static void Clear(double[] map)
    {
        Array.Clear(map, 0, map.Length);
        map[map.Length - 1] = 1;
    }

    /// <summary>Computes one column. Both sides must behave alike: a ball that bounces, or stays down, does so on both.</summary>
    private void Difference(in BallState s, in Motion at, int index, int thing, double[] map)
    {
        double width = MotionVector.Width(in at, index);
        for (int i = 0; i < MostTries; i++, width *= Narrower)
        {
            Motion high = Hit(in s, MotionVector.Changed(in at, index, width), 0, thing, out MotionState above);
            Motion low = Hit(in s, MotionVector.Changed(in at, index, -width), 0, thing, out MotionState below);
            MotionVector.Write(map, index, in high, in low, 2.0 * width);
            if (above == below)
            {
                return;
            }
        }
    }

    private Motion Hit(in BallState s, in Motion motion, double later, int thing, out MotionState becomes)
    {
        BallState changed = MotionVector.With(in s, in motion);
        changed.Time += later;
        Hit(ref changed, thing);
        becomes = changed.Motion;
        return MotionVector.Of(in changed);
    }

    private int Hit(ref BallState s, int thing)
    {
        var run = new StepRun(1, s.Time, _log);
        _contact.Impact(ref s, _world.Struck(thing, in s), ref run);
        int impacts = (int)_log.Events.Impacts;
        _log.Clear();
        return impacts;
    }
}
