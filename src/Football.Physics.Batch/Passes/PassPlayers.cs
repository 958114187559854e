using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The circles that the players of a fan can reach at each step, shared by all kicks.</summary>
internal sealed class PassPlayers
{
    /// <summary>The depth within a circle, in m, at which the exact path is inside too: more than the error of lanes and tracks.</summary>
    private const double Surely = 0.005;

    private RunnerMotion[] _motions = new RunnerMotion[22];
    private Circle[] _circles = new Circle[22 * 64];
    private int _players;
    private int _filled;
    private double _length;

    /// <summary>The number of team mates; they are the first players.</summary>
    public int Mates { get; private set; }

    /// <summary>The lowest height at which anyone can play the ball, in m.</summary>
    public double Lowest { get; private set; }

    /// <summary>The greatest height at which anyone can play the ball, in m.</summary>
    public double Highest { get; private set; }

    /// <summary>A bound on the speed at which any circle approaches a point, in m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>Prepares for players.</summary>
    /// <param name="mates">The team mates.</param>
    /// <param name="opponents">The opponents.</param>
    /// <param name="length">The length of a step, in s.</param>
    public void Begin(Player[] mates, Player[] opponents, double length)
    {
        Mates = mates.Length;
        _players = mates.Length + opponents.Length;
        _length = length;
        _filled = 0;
        if (_motions.Length < _players)
        {
            _motions = new RunnerMotion[_players];
        }

        Lowest = double.PositiveInfinity;
        Highest = double.NegativeInfinity;
        Fastest = 0;
        for (int i = 0; i < _players; i++)
        {
            Player runner = i < Mates ? mates[i] : opponents[i - Mates];
            runner.Validate();
            _motions[i] = new RunnerMotion(in runner, 0);
            Lowest = Math.Min(Lowest, _motions[i].Lowest);
            Highest = Math.Max(Highest, _motions[i].Highest);
            Fastest = Math.Max(Fastest, _motions[i].Fastest);
        }
    }

    /// <summary>Computes the circles up to a step.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Reach(int step)
    {
        if (step >= _filled)
        {
            Fill(step);
        }
    }

    /// <summary>Checks a ball that moves from one point to another between two steps.</summary>
    /// <param name="first">The step at the first point.</param>
    /// <param name="last">The step at the second point.</param>
    /// <param name="from">The first point, in m.</param>
    /// <param name="to">The second point, in m.</param>
    /// <param name="slack">The maximum deviation from uniform motion, in m.</param>
    /// <param name="earliest">The earliest time at which a team mate could reach the ball, in s; computed if it is infinite.</param>
    /// <param name="isLost">True if an opponent can surely reach the ball at the end.</param>
    /// <returns>The distance at the end from the nearest relevant circle, in m.</returns>
    [MethodImpl(Hot.Path)]
    public double Look(int first, int last, in Vector3d from, in Vector3d to, double slack, ref double earliest, out bool isLost)
    {
        double gap = double.PositiveInfinity;
        Circle[] circles = _circles;
        int row = last * _players;
        isLost = false;
        for (int i = Mates; i < _players; i++)
        {
            double distance = circles[row + i].Distance(to.X, to.Z);
            gap = Math.Min(gap, distance);
            if (distance <= -Surely && to.Y >= _motions[i].Lowest + Surely && to.Y <= _motions[i].Highest - Surely)
            {
                isLost = true;
                break;
            }
        }

        if (Mates > 0 && double.IsPositiveInfinity(earliest))
        {
            double way = (to - from).Horizontal.Length + slack;
            for (int i = 0; i < Mates; i++)
            {
                double distance = circles[row + i].Distance(to.X, to.Z);
                gap = Math.Min(gap, distance);
                if (distance <= way + ((last - first) * _length * _motions[i].Carried))
                {
                    earliest = Math.Min(earliest, Meeting(i, first, last, in from, in to, slack));
                }
            }
        }

        return gap;
    }

    /// <summary>Returns the earliest time at which one team mate could reach the ball; infinite if he cannot.</summary>
    private double Meeting(int mate, int first, int last, in Vector3d from, in Vector3d to, double slack)
    {
        ref readonly RunnerMotion motion = ref _motions[mate];
        if (Math.Min(from.Y, to.Y) - slack > motion.Highest || Math.Max(from.Y, to.Y) + slack < motion.Lowest)
        {
            return double.PositiveInfinity;
        }

        double start = first * _length;
        double length = (last - first) * _length;
        double beside = slack + Kink(in motion, start, length);
        return start + (length * Share(in _circles[(first * _players) + mate], in _circles[(last * _players) + mate], in motion, in from, in to, beside, slack));
    }

    /// <summary>Returns the first fraction of a path at which it can be within a circle that moves and grows steadily; infinite if never.</summary>
    private static double Share(in Circle start, in Circle end, in RunnerMotion mate, in Vector3d from, in Vector3d to, double beside, double above)
    {
        // q(s) = (R₀ + s ΔR)² − |w₀ + s Δw|² = A s² + 2 B s + C. The radius is convex in time, so its chord is an upper bound.
        double wx = from.X - start.X;
        double wz = from.Z - start.Z;
        double dx = to.X - end.X - wx;
        double dz = to.Z - end.Z - wz;
        double radius = start.Radius + beside;
        double growth = end.Radius - start.Radius;
        double a = (growth * growth) - ((dx * dx) + (dz * dz));
        double b = (radius * growth) - ((wx * dx) + (wz * dz));
        double c = (radius * radius) - ((wx * wx) + (wz * wz));
        double share = 0;
        if (c < 0)
        {
            double divisor = b + Math.Sqrt(Math.Max(0, (b * b) - (a * c)));
            share = (b * b) >= a * c && divisor > 0 ? -c / divisor : double.PositiveInfinity;
        }

        double down = from.Y - above - mate.Highest;
        double up = mate.Lowest - above - from.Y;
        double rise = to.Y - from.Y;
        share = down > 0 ? Math.Max(share, -down / rise) : up > 0 ? Math.Max(share, up / rise) : share;
        return share <= 1 ? share : double.PositiveInfinity;
    }

    /// <summary>Returns the deviation of a circle's centre from uniform motion in the step in which the player reacts, in m.</summary>
    private static double Kink(in RunnerMotion mate, double start, double length) =>
        start < mate.Start && mate.Start < start + length ? 0.25 * length * mate.Carried : 0;

    private void Fill(int step)
    {
        int room = (step + 1) * _players;
        if (_circles.Length < room)
        {
            Array.Resize(ref _circles, Math.Max(room, 2 * _circles.Length));
        }

        for (; _filled <= step; _filled++)
        {
            double time = _filled * _length;
            for (int i = 0; i < _players; i++)
            {
                ref Circle circle = ref _circles[(_filled * _players) + i];
                _motions[i].MiddleAt(time, out circle.X, out circle.Z);
                circle.Radius = _motions[i].RadiusAt(time);
            }
        }
    }

    /// <summary>The circle that a player can reach at a step.</summary>
    private struct Circle
    {
        /// <summary>The centre, in m.</summary>
        public double X;
        public double Z;

        /// <summary>The radius, in m.</summary>
        public double Radius;

        /// <summary>Returns the distance of a point outside the circle, in m.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly double Distance(double x, double z)
        {
            double dx = x - X;
            double dz = z - Z;
            return Math.Sqrt((dx * dx) + (dz * dz)) - Radius;
        }
    }
}
