using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>Where the players of a fan can be, step by step: the same for all kicks, so it is worked out once a step.</summary>
internal sealed class PassPlayers
{
    /// <summary>A ball this much within a circle is so on its exact path too, m: lanes and tracks are closer than that.</summary>
    private const double Surely = 0.005;

    private RunnerMotion[] _motions = new RunnerMotion[22];
    private Circle[] _circles = new Circle[22 * 64];
    private int _players;
    private int _filled;
    private double _length;

    /// <summary>How many team mates there are: the first players.</summary>
    public int Mates { get; private set; }

    /// <summary>Least height at which anyone plays the ball, m.</summary>
    public double Lowest { get; private set; }

    /// <summary>Greatest such height, m.</summary>
    public double Highest { get; private set; }

    /// <summary>No circle comes towards a place faster, m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>Prepares for players.</summary>
    /// <param name="mates">The team mates.</param>
    /// <param name="opponents">The opponents.</param>
    /// <param name="length">Length of a step, s.</param>
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

    /// <summary>Makes sure of the circles up to a step.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Reach(int step)
    {
        if (step >= _filled)
        {
            Fill(step);
        }
    }

    /// <summary>Looks at a ball on its way from one place to another between two steps.</summary>
    /// <param name="first">The step at which it is at the first place.</param>
    /// <param name="last">The step at which it is at the other.</param>
    /// <param name="from">The first place, m.</param>
    /// <param name="to">The other, m.</param>
    /// <param name="slack">How far off the straight way at a steady speed it may be, m.</param>
    /// <param name="earliest">The earliest time at which a team mate could meet it, s; looked for where it is infinite.</param>
    /// <param name="isLost">Whether an opponent is surely within reach at the end.</param>
    /// <returns>How far it then is from the circles of those who matter, m.</returns>
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

    /// <summary>The earliest time at which one team mate could meet a ball; infinite where he could not.</summary>
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

    /// <summary>The first share of a way at which its end can be within a circle that moves and grows steadily; infinite where it is not.</summary>
    private static double Share(in Circle start, in Circle end, in RunnerMotion mate, in Vector3d from, in Vector3d to, double beside, double above)
    {
        // q(s) = (R₀ + s ΔR)² − |w₀ + s Δw|² = A s² + 2 B s + C. A radius grows ever faster, so it is below its chord.
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

    /// <summary>How far the middle of a circle is off its straight way in a step in which the player reacts, m.</summary>
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

    /// <summary>Where a player can be at a step.</summary>
    private struct Circle
    {
        /// <summary>Middle, m.</summary>
        public double X;
        public double Z;

        /// <summary>Radius, m.</summary>
        public double Radius;

        /// <summary>How far outside a place is, m.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly double Distance(double x, double z)
        {
            double dx = x - X;
            double dz = z - Z;
            return Math.Sqrt((dx * dx) + (dz * dz)) - Radius;
        }
    }
}
