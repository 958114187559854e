using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>Watches kicks step by step: it bounds the time at which a team mate can reach each, and finds those that an opponent surely intercepts.</summary>
internal sealed class PassWatch(Simulator simulator, PassPlayers players) : LaneWatch
{
    private readonly PassPlayers _players = players;
    private readonly bool[] _decided = new bool[LaneGroup.Size];

    /// <summary>For each ball of the group: the time before which nothing can happen, in s.</summary>
    private readonly double[] _idle = new double[LaneGroup.Size];
    private readonly double _contact = simulator.ContactHeight;
    private readonly double _twiceGravity = 2.0 * Math.Abs(Weight.UpwardAcceleration(simulator.Scene));
    private double _length;
    private double _margin;
    private double _slack;
    private Vector3d _from;
    private Vector3d _wind;
    private double _duration;
    private double _windSpeed;
    private double _windDrop;
    private int _step;

    /// <summary>For each ball: a lower bound of the time at which a team mate reaches it, in s.</summary>
    /// <remarks>Infinite if no team mate does, NaN if an opponent does before.</remarks>
    public double[] Earliest { get; } = new double[LaneGroup.Size];

    /// <summary>Returns true if a ball of the group needs no further steps.</summary>
    public bool IsDecided(int ball) => _decided[ball];

    /// <summary>Prepares for a fan.</summary>
    /// <param name="from">The start of the kicks, in m.</param>
    /// <param name="wind">The wind, in m/s.</param>
    /// <param name="duration">The duration of a pass, in s.</param>
    /// <param name="length">The length of a step, in s.</param>
    /// <param name="margin">The lead that a team mate needs over every opponent, in s.</param>
    /// <param name="acceleration">A bound on the acceleration of all flights of the fan, in m/s².</param>
    /// <param name="error">The maximum error of the flights, in m.</param>
    public void Begin(in Vector3d from, in Vector3d wind, double duration, double length, double margin, double acceleration, double error)
    {
        _from = from;
        _wind = wind;
        _windSpeed = wind.Length;
        _windDrop = Math.Abs(wind.Y) * duration;
        _duration = duration;
        _length = length;
        _margin = margin;

        // |p(t₁ − s) − (p₁ − s v₁)| ≤ ½ a s²
        _slack = (0.5 * acceleration * length * length) + error;
    }

    /// <summary>Starts a group.</summary>
    public void Clear()
    {
        _step = 0;
        Array.Clear(_decided, 0, _decided.Length);
        Array.Clear(_idle, 0, _idle.Length);
        for (int i = 0; i < Earliest.Length; i++)
        {
            Earliest[i] = double.PositiveInfinity;
        }
    }

    [MethodImpl(Hot.Path)]
    public override void Step(LaneGroup group, double time)
    {
        _players.Reach(++_step);
        double startX = _from.X + (time * _wind.X);
        double startY = _from.Y + (time * _wind.Y);
        double startZ = _from.Z + (time * _wind.Z);
        double highest = _players.Highest + _slack;
        double lowest = _players.Lowest - _slack;
        LaneState now = group.Now;
        float[] heights = now.Py;
        float[] climbs = now.Uy;
        int[] balls = group.Ball;
        for (int at = 0; at < group.Flying; at++)
        {
            int ball = balls[at];
            if (_idle[ball] > time)
            {
                continue;
            }

            double y = startY + heights[at];
            double climb = climbs[at] + _wind.Y;
            double rise = _length * climb;
            bool isKnown;
            if ((y > highest && y - rise > highest) || (y < lowest && y - rise < lowest))
            {
                // Too high for anyone, both now and one step ago.
                isKnown = time - Earliest[ball] >= _margin;
            }
            else
            {
                double vx = now.Ux[at] + _wind.X;
                double vz = now.Uz[at] + _wind.Z;
                var to = new Vector3d(startX + now.Px[at], y, startZ + now.Pz[at]);
                var from = new Vector3d(to.X - (_length * vx), y - rise, to.Z - (_length * vz));
                double ux = now.Ux[at];
                double uz = now.Uz[at];

                // In the air's frame only gravity does work.
                double drop = Math.Max(0, y - _contact) + _windDrop;
                double fastest = _windSpeed + Math.Sqrt((ux * ux) + (climbs[at] * (double)climbs[at]) + (uz * uz) + (_twiceGravity * drop));
                isKnown = Look(ref Earliest[ball], _step - 1, _step, in from, in to, _slack, fastest, _duration, out _idle[ball]);
            }

            if (isKnown)
            {
                // The receiver is known, so the kick need not fly on.
                _decided[ball] = true;
                group.GiveUp(at);
            }
        }
    }

    /// <summary>Checks the last part of a flight, which ends between two steps.</summary>
    public void LookAtEnd(int ball, double time, in Vector3d at, in Vector3d velocity)
    {
        int step = (int)(time / _length);
        _players.Reach(step + 1);
        if (double.IsPositiveInfinity(Earliest[ball]))
        {
            // The circles at the end of the full step contain those at the end of the flight.
            Vector3d from = at - ((time - (step * _length)) * velocity);
            double met = double.PositiveInfinity;
            _players.Look(step, step + 1, in from, in at, _slack + (at - from).Length, ref met, out _);
            Earliest[ball] = double.IsPositiveInfinity(met) ? met : step * _length;
        }
    }

    /// <summary>Checks a path between two steps.</summary>
    /// <param name="earliest">The bound known so far for the kick.</param>
    /// <param name="first">The step at the start.</param>
    /// <param name="last">The step at the end.</param>
    /// <param name="from">The start, in m.</param>
    /// <param name="to">The end, in m.</param>
    /// <param name="slack">The maximum deviation from uniform motion, in m.</param>
    /// <param name="fastest">A bound on the ball's speed from now on, in m/s.</param>
    /// <param name="end">The time after which opponents no longer count, in s.</param>
    /// <param name="idle">The time before which nothing can happen, in s.</param>
    /// <returns>True if the kick is decided.</returns>
    [MethodImpl(Hot.Path)]
    public bool Look(ref double earliest, int first, int last, in Vector3d from, in Vector3d to, double slack, double fastest, double end, out double idle)
    {
        double time = last * _length;
        double gap = _players.Look(first, last, in from, in to, slack, ref earliest, out bool isLost);
        idle = Math.Min(time + Math.Max(0, (gap - slack) / (fastest + _players.Fastest)), earliest + _margin);
        if (time - earliest >= _margin)
        {
            return true;
        }

        // The opponent is there now at the latest, and a team mate no earlier.
        isLost &= time <= end;
        earliest = isLost ? double.NaN : earliest;
        return isLost;
    }
}
