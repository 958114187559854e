using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Watches kicks step by step: before when no team mate can meet each of them, and which an opponent surely takes.</summary>
internal sealed class PassWatch : LaneWatch
{
    private readonly PassPlayers _players;
    private readonly bool[] _decided = new bool[LaneGroup.Size];
    private double _length;
    private double _margin;
    private double _slack;
    private Vector3d _from;
    private Vector3d _wind;
    private int _step;

    public PassWatch(PassPlayers players) => _players = players;

    /// <summary>By ball of the group: no team mate meets it before, s; infinite where none does at all, not a number where an opponent does before.</summary>
    public double[] Earliest { get; } = new double[LaneGroup.Size];

    /// <summary>By ball of the group: whether it was seen long enough.</summary>
    public bool IsDecided(int ball) => _decided[ball];

    /// <summary>Prepares for a fan.</summary>
    /// <param name="from">Where the kicks begin, m.</param>
    /// <param name="wind">The wind, m/s.</param>
    /// <param name="length">Length of a step, s.</param>
    /// <param name="margin">How much earlier than any opponent a team mate must be there, s.</param>
    /// <param name="acceleration">No flight of the fan is accelerated more strongly, m/s².</param>
    /// <param name="error">How far off the flights may be, m.</param>
    public void Begin(in Vector3d from, in Vector3d wind, double length, double margin, double acceleration, double error)
    {
        _from = from;
        _wind = wind;
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
        for (int at = 0; at < group.Flying; at++)
        {
            // Most are far too high for anyone, now and a step ago.
            double y = startY + heights[at];
            double rise = _length * (climbs[at] + _wind.Y);
            if ((y > highest && y - rise > highest) || (y < lowest && y - rise < lowest))
            {
                if (Earliest[group.Ball[at]] + _margin <= time)
                {
                    _decided[group.Ball[at]] = true;
                    group.GiveUp(at);
                }

                continue;
            }

            int ball = group.Ball[at];
            var to = new Vector3d(startX + now.Px[at], y, startZ + now.Pz[at]);
            var from = new Vector3d(to.X - (_length * (now.Ux[at] + _wind.X)), y - rise, to.Z - (_length * (now.Uz[at] + _wind.Z)));
            if (Look(ref Earliest[ball], _step - 1, _step, in from, in to, _slack))
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
            double met = _players.EarliestMeeting(step, step + 1, in from, in at, _slack + (at - from).Length);
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
    /// <returns>Whether all is known.</returns>
    [MethodImpl(Hot.Path)]
    public bool Look(ref double earliest, int first, int last, in Vector3d from, in Vector3d to, double slack)
    {
        double time = last * _length;
        if (_players.Mates > 0 && double.IsPositiveInfinity(earliest))
        {
            earliest = _players.EarliestMeeting(first, last, in from, in to, slack);
        }

        // An opponent is there at this time at the latest, a team mate at the earliest one at the earliest.
        if (!(time - earliest >= _margin) && _players.IsLost(last, to.X, to.Y, to.Z))
        {
            earliest = double.NaN;
            return true;
        }

        return time - earliest >= _margin;
    }
}
