using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>Watches kicks step by step: before when no team mate can meet each of them, and which an opponent surely takes.</summary>
internal sealed class PassWatch : LaneWatch
{
    private readonly PassPlayers _players;
    private readonly bool[] _decided = new bool[LaneGroup.Size];

    /// <summary>By ball of the group: nothing happens before, s.</summary>
    private readonly double[] _idle = new double[LaneGroup.Size];
    private readonly double _contact;
    private readonly double _twiceGravity;
    private double _length;
    private double _margin;
    private double _slack;
    private Vector3d _from;
    private Vector3d _wind;
    private double _duration;
    private double _windSpeed;
    private double _windDrop;
    private int _step;

    public PassWatch(Simulator simulator, PassPlayers players)
    {
        _players = players;
        _contact = simulator.ContactHeight;
        _twiceGravity = 2.0 * Math.Abs(Weight.UpwardAcceleration(simulator.Scene));
    }

    /// <summary>By ball of the group: no team mate meets it before, s; infinite where none does at all, not a number where an opponent does before.</summary>
    public double[] Earliest { get; } = new double[LaneGroup.Size];

    /// <summary>By ball of the group: whether it was seen long enough.</summary>
    public bool IsDecided(int ball) => _decided[ball];

    /// <summary>Prepares for a fan.</summary>
    /// <param name="from">Where the kicks begin, m.</param>
    /// <param name="wind">The wind, m/s.</param>
    /// <param name="duration">How long the kicks are looked at, s.</param>
    /// <param name="length">Length of a step, s.</param>
    /// <param name="margin">How much earlier than any opponent a team mate must be there, s.</param>
    /// <param name="acceleration">No flight of the fan is accelerated more strongly, m/s².</param>
    /// <param name="error">How far off the flights may be, m.</param>
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
                // Too high for anyone, now and a step ago.
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
                // Whom a kick comes to is then known: it need not fly on.
                _decided[ball] = true;
                group.GiveUp(at);
            }
        }
    }

    /// <summary>Looks at the last part of a flight, which ends between two steps.</summary>
    public void LookAtEnd(int ball, double time, in Vector3d at, in Vector3d velocity)
    {
        int step = (int)(time / _length);
        _players.Reach(step + 1);
        if (double.IsPositiveInfinity(Earliest[ball]))
        {
            // The circles of a whole step hold all that they are until the flight's end.
            Vector3d from = at - ((time - (step * _length)) * velocity);
            double met = double.PositiveInfinity;
            _players.Look(step, step + 1, in from, in at, _slack + (at - from).Length, ref met, out _);
            Earliest[ball] = double.IsPositiveInfinity(met) ? met : step * _length;
        }
    }

    /// <summary>Looks at a way between two steps.</summary>
    /// <param name="earliest">What is known of the kick.</param>
    /// <param name="first">The step at which it begins.</param>
    /// <param name="last">The step at which it ends.</param>
    /// <param name="from">Where it begins, m.</param>
    /// <param name="to">Where it ends, m.</param>
    /// <param name="slack">How far off the straight way at a steady speed the ball may be, m.</param>
    /// <param name="fastest">No faster than this will it ever be, m/s.</param>
    /// <param name="end">No opponent who comes later counts, s.</param>
    /// <param name="idle">Nothing happens before, s.</param>
    /// <returns>Whether all is known.</returns>
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

        // An opponent is there now at the latest, a team mate no earlier than that.
        isLost &= time <= end;
        earliest = isLost ? double.NaN : earliest;
        return isLost;
    }
}
