using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Watches passes in flight: whom of the players each comes within reach of first, step by step.</summary>
internal sealed class PassWatch : LaneWatch
{
    /// <summary>Where a player can be now: x and z of the middle, the square of the radius, and his heights.</summary>
    private double[] _x = new double[22];
    private double[] _z = new double[22];
    private double[] _squared = new double[22];
    private double[] _low = new double[22];
    private double[] _high = new double[22];
    private RunnerMotion[] _motions = new RunnerMotion[22];
    private int _players;
    private int _mates;
    private double _lowest;
    private double _highest;
    private Vector3d _from;
    private Vector3d _wind;

    /// <summary>By ball of the group: when a team mate meets it; negative where an opponent does before; 0 where nobody has.</summary>
    public double[] Time { get; } = new double[LaneGroup.Size];

    /// <summary>Prepares for players.</summary>
    public void Begin(Runner[] mates, Runner[] opponents, in Vector3d from, in Vector3d wind)
    {
        _mates = mates.Length;
        _players = mates.Length + opponents.Length;
        if (_motions.Length < _players)
        {
            _motions = new RunnerMotion[_players];
            _x = new double[_players];
            _z = new double[_players];
            _squared = new double[_players];
            _low = new double[_players];
            _high = new double[_players];
        }

        _from = from;
        _wind = wind;
        _lowest = double.PositiveInfinity;
        _highest = double.NegativeInfinity;
        for (int i = 0; i < _players; i++)
        {
            Runner runner = i < _mates ? mates[i] : opponents[i - _mates];
            runner.Validate();
            _motions[i] = new RunnerMotion(in runner, 0);
            _low[i] = _motions[i].Lowest;
            _high[i] = _motions[i].Highest;
            _lowest = Math.Min(_lowest, _low[i]);
            _highest = Math.Max(_highest, _high[i]);
        }
    }

    /// <summary>Starts a group.</summary>
    public void Clear() => Array.Clear(Time, 0, Time.Length);

    [MethodImpl(Hot.Path)]
    public override void Step(LaneGroup group, double time)
    {
        for (int i = 0; i < _players; i++)
        {
            _motions[i].MiddleAt(time, out _x[i], out _z[i]);
            double radius = _motions[i].RadiusAt(time);
            _squared[i] = radius * radius;
        }

        double startX = _from.X + (time * _wind.X);
        double startY = _from.Y + (time * _wind.Y);
        double startZ = _from.Z + (time * _wind.Z);
        LaneState now = group.Now;
        float[] heights = now.Py;
        for (int at = 0; at < group.Flying; at++)
        {
            // Most are far too high for anyone.
            double y = startY + heights[at];
            if (y < _lowest || y > _highest)
            {
                continue;
            }

            int ball = group.Ball[at];
            if (Time[ball] != 0)
            {
                continue;
            }

            double x = startX + now.Px[at];
            double z = startZ + now.Pz[at];

            // An opponent who is there as early comes first. Whom a kick comes to is then known: it need not fly on.
            if (Reaches(_mates, _players, x, y, z))
            {
                Time[ball] = -1;
                group.GiveUp(at);
            }
            else if (Reaches(0, _mates, x, y, z))
            {
                Time[ball] = time;
                group.GiveUp(at);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool Reaches(int first, int end, double x, double y, double z)
    {
        for (int i = first; i < end; i++)
        {
            double dx = x - _x[i];
            double dz = z - _z[i];
            if ((dx * dx) + (dz * dz) <= _squared[i] && y >= _low[i] && y <= _high[i])
            {
                return true;
            }
        }

        return false;
    }
}
