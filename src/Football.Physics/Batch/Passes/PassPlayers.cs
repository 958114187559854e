using System.Runtime.CompilerServices;

namespace Football.Physics;

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

    /// <summary>Prepares for players.</summary>
    /// <param name="mates">The team mates.</param>
    /// <param name="opponents">The opponents.</param>
    /// <param name="length">Length of a step, s.</param>
    public void Begin(Runner[] mates, Runner[] opponents, double length)
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
        for (int i = 0; i < _players; i++)
        {
            Runner runner = i < Mates ? mates[i] : opponents[i - Mates];
            runner.Validate();
            _motions[i] = new RunnerMotion(in runner, 0);
            Lowest = Math.Min(Lowest, _motions[i].Lowest);
            Highest = Math.Max(Highest, _motions[i].Highest);
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

    /// <summary>Whether an opponent is surely within reach of a ball at a step.</summary>
    [MethodImpl(Hot.Path)]
    public bool IsLost(int step, double x, double y, double z)
    {
        int row = step * _players;
        for (int i = Mates; i < _players; i++)
        {
            ref readonly Circle circle = ref _circles[row + i];
            double dx = x - circle.X;
            double dz = z - circle.Z;
            if ((dx * dx) + (dz * dz) <= circle.Inner && y >= _motions[i].Lowest + Surely && y <= _motions[i].Highest - Surely)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The earliest time between two steps at which a team mate could meet a ball on its way from one place to another; infinite where none could.</summary>
    /// <param name="first">The step at which it is at the first place.</param>
    /// <param name="last">The step at which it is at the other.</param>
    /// <param name="from">The first place, m.</param>
    /// <param name="to">The other, m.</param>
    /// <param name="slack">How far off the straight way at a steady speed it may be, m.</param>
    [MethodImpl(Hot.Path)]
    public double EarliestMeeting(int first, int last, in Vector3d from, in Vector3d to, double slack)
    {
        double earliest = double.PositiveInfinity;
        double least = Math.Min(from.Y, to.Y) - slack;
        double most = Math.Max(from.Y, to.Y) + slack;
        double halfX = 0.5 * (to.X - from.X);
        double halfZ = 0.5 * (to.Z - from.Z);
        double half = Math.Sqrt((halfX * halfX) + (halfZ * halfZ)) + slack;
        double start = first * _length;
        double length = (last - first) * _length;
        for (int i = 0; i < Mates; i++)
        {
            ref readonly RunnerMotion mate = ref _motions[i];
            ref readonly Circle end = ref _circles[(last * _players) + i];
            double far = end.Radius + half + (length * mate.CarriedAt(start));
            double dx = from.X + halfX - end.X;
            double dz = from.Z + halfZ - end.Z;
            if ((dx * dx) + (dz * dz) <= far * far && least <= mate.Highest && most >= mate.Lowest)
            {
                double share = Share(in _circles[(first * _players) + i], in end, in mate, in from, in to, slack + Kink(in mate, start, length), slack);
                earliest = Math.Min(earliest, start + (share * length));
            }
        }

        return earliest;
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
                double inner = circle.Radius - Surely;
                circle.Inner = inner > 0 ? inner * inner : -1;
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

        /// <summary>Square of the radius within which a ball surely is, m²; below 0 where there is none.</summary>
        public double Inner;
    }
}
