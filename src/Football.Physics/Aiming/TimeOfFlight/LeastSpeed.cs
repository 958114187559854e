namespace Football.Physics;

/// <summary>The least of the speeds that kicks need over their time.</summary>
internal sealed class LeastSpeed
{
    /// <summary>Steps towards the least speed.</summary>
    private const int MostSteps = 12;

    /// <summary>Share of its time within which the slowest kick is found.</summary>
    private const double TimeWidth = 2e-3;

    /// <summary>How far apart, as shares of the time, and how many to each side, are looks for waves beside the slowest kick.</summary>
    private const double Wave = 0.04;
    private const int MostWaves = 3;

    private readonly SpeedOverTime _speeds;

    public LeastSpeed(SpeedOverTime speeds) => _speeds = speeds;

    /// <summary>The slowest kick around one of the row, by successive parabolas.</summary>
    /// <param name="at">A kick that is no faster than its neighbours.</param>
    /// <param name="enough">A speed that is slow enough, or negative.</param>
    /// <returns>Its place in the row.</returns>
    public int At(int at, double enough)
    {
        for (int i = 0; i < MostSteps && at > 0 && at < _speeds.Count - 1 && !(_speeds[at].Speed <= enough); i++)
        {
            ref readonly TimedKick a = ref _speeds[at - 1];
            ref readonly TimedKick b = ref _speeds[at];
            ref readonly TimedKick c = ref _speeds[at + 1];
            double left = b.Time - a.Time;
            double right = c.Time - b.Time;
            double known = a.Found && c.Found ? Math.Max(left, right) : a.Found ? left : right;
            double move = a.Found && c.Found ? Vertex(left, right, b.Speed - a.Speed, b.Speed - c.Speed)
                : a.Found ? Vertex(in b, -left, in a)
                : c.Found ? Vertex(in b, right, in c)
                : double.NaN;
            if (!double.IsFinite(move))
            {
                move = left > right ? -0.5 * left : 0.5 * right;
            }
            else if (known < 0.2 * b.Time && Math.Abs(move) < TimeWidth * b.Time)
            {
                // What is left is of second order in the last move.
                return at;
            }

            double least = 0.05 * Math.Max(left, right);
            if (Math.Abs(move) < least)
            {
                move = left > right ? -least : least;
            }

            double time = b.Time + Math.Min(Math.Max(move, -0.9 * left), 0.9 * right);
            double speed = b.Speed;
            int added = _speeds.Add(time);
            if (added < 0)
            {
                return at;
            }

            at = _speeds[added].Speed < speed ? added : added <= at ? at + 1 : at;
        }

        return at;
    }

    /// <summary>Looks beside the slowest kick: the drag law's jump makes waves there.</summary>
    /// <returns>The place of the slowest in the row.</returns>
    public int WithWaves(int at)
    {
        double time = _speeds[at].Time;
        for (int i = 1; i <= MostWaves; i++)
        {
            at = Slower(at, _speeds.Add(time * (1.0 + (i * Wave))));
            at = Slower(at, _speeds.Add(time * (1.0 - (i * Wave))));
        }

        return _speeds[at].Time == time ? at : At(at, enough: -1);
    }

    /// <summary>The slower of a kick of the row and one that was added to it since.</summary>
    private int Slower(int at, int added) =>
        added < 0 ? at : added <= at ? (_speeds[added].Speed < _speeds[at + 1].Speed ? added : at + 1) : _speeds[added].Speed < _speeds[at].Speed ? added : at;

    /// <summary>Where the parabola through two kicks, with the slope of the one, is least, from that one.</summary>
    private double Vertex(in TimedKick one, double way, in TimedKick other)
    {
        // f(x) = f₀ + s x + k x²
        TimedKick sharp = one;
        _speeds.Problem.Sharpen(ref sharp);
        double slope = sharp.Slope() / one.Time;
        double curvature = (other.Speed - one.Speed - (slope * way)) / (way * way);
        return curvature > 0 ? -0.5 * slope / curvature : double.NaN;
    }

    /// <summary>Where the parabola through three points is least, from the middle one.</summary>
    private static double Vertex(double left, double right, double riseLeft, double riseRight)
    {
        double below = (left * riseRight) + (right * riseLeft);
        return below < 0 ? 0.5 * ((right * right * riseLeft) - (left * left * riseRight)) / below : 0;
    }
}
