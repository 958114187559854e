namespace Football.Physics;

/// <summary>
/// The speed that a kick needs over the time that it takes to the target: it falls, where the kick is flat, to that of the slowest kick, and rises
/// again, where it is steep. Sampled so that neighbours tell of each other, as far as the speeds are of use.
/// </summary>
internal sealed class SpeedOverTime
{
    /// <summary>Times next to each other.</summary>
    private const double Ratio = 1.3;

    /// <summary>Beyond this share of the fastest speed, and rising, no slower kick is to be found.</summary>
    private const double Beyond = 1.2;

    private readonly TimedKick[] _kicks = new TimedKick[64];
    private TimedProblem _problem;

    /// <summary>Whether a kick that is next to none of the row is begun from the model.</summary>
    private bool _hasModel;

    public SpeedOverTime(TimedProblem problem) => _problem = problem;

    /// <summary>How many kicks are known.</summary>
    public int Count { get; private set; }

    public TimedProblem Problem => _problem;

    /// <summary>A kick, by rising time.</summary>
    public ref readonly TimedKick this[int index] => ref _kicks[index];

    /// <summary>Whether none next to a kick of the row is slower, as far as is known.</summary>
    public bool IsBottom(int at) => _kicks[at].Found && !(at > 0 && _kicks[at - 1].Speed < _kicks[at].Speed) && !(at < Count - 1 && _kicks[at + 1].Speed < _kicks[at].Speed);

    /// <summary>Begins with a kick that is neither fast and flat nor fast and steep.</summary>
    /// <param name="problem">What the kicks are to do.</param>
    /// <param name="fastest">The fastest kick of use, m/s.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    public void Begin(TimedProblem problem, double fastest, double upward)
    {
        _problem = problem;
        _hasModel = true;
        Count = 0;
        double distance = (problem.Frame.Target - problem.Frame.From).Length;

        // Without air the slowest kick takes t² = 2 d/g.
        double slowest = Math.Abs(upward) > 1e-3 ? Math.Sqrt(2.0 * distance / Math.Abs(upward)) : double.PositiveInfinity;
        double time = Math.Min(Math.Max(slowest, 1.2 * distance / fastest), AimContext.LongestFlight);
        Add(time);
        for (int i = 1; i <= 4 && Count > 0 && !_kicks[0].Found && !double.IsPositiveInfinity(_kicks[0].Speed); i++)
        {
            // Not even that is known: elsewhere then.
            Count = 0;
            Add(Math.Min(time * (i % 2 == 0 ? Elementary.Exp(-0.3 * i) : Elementary.Exp(0.3 * i)), AimContext.LongestFlight));
        }
    }

    /// <summary>Adds shorter times, until even shorter ones need more than the fastest speed.</summary>
    public void Shorten(double fastest)
    {
        while (GoesOn(0) && Count < _kicks.Length - 24 && !IsBeyond(fastest, 0, 1) && Add(_kicks[0].Time / Ratio) >= 0)
        {
        }
    }

    /// <summary>Adds longer times, until even longer ones need more than the fastest speed.</summary>
    public void Lengthen(double fastest)
    {
        while (GoesOn(Count - 1) && Count < _kicks.Length - 12 && !IsBeyond(fastest, Count - 1, Count - 2) && _kicks[Count - 1].Time < AimContext.LongestFlight
            && Add(Math.Min(Ratio * _kicks[Count - 1].Time, AimContext.LongestFlight)) >= 0)
        {
        }
    }

    /// <summary>Goes over to the kicks at these times whose horizontal directions are the opposite ones, as far as there are any.</summary>
    /// <param name="fastest">The fastest kick of use, m/s.</param>
    /// <returns>Whether there are.</returns>
    public bool Cross(double fastest)
    {
        _hasModel = false;
        bool found = false;
        for (int i = 0; i < Count; i++)
        {
            TimedKick kick = _kicks[i];
            TimedKick other = kick;
            bool crosses = kick.Found && _problem.Across(in kick, out other) && _problem.Solve(ref other)
                && Vector3d.Dot(other.Velocity.Horizontal, kick.Velocity.Horizontal) < 0;
            found |= crosses;
            _kicks[i] = crosses ? other : new TimedKick { Time = kick.Time, Speed = double.NaN };
        }

        Shorten(fastest);
        Lengthen(fastest);
        return found;
    }

    /// <summary>Finds the kick for a time, and takes it into the row.</summary>
    /// <returns>Where it is in the row; −1 where nothing more can be searched.</returns>
    public int Add(double time)
    {
        if (Count == _kicks.Length || _problem.IsSpent)
        {
            return -1;
        }

        TimedKick kick = Near(time);
        int at = Count++;
        while (at > 0 && _kicks[at - 1].Time > time)
        {
            _kicks[at] = _kicks[at - 1];
            at--;
        }

        _kicks[at] = kick;
        return at;
    }

    /// <summary>The kick for a time, beginning with those next to it.</summary>
    public TimedKick Near(double time)
    {
        int nearest = -1;
        for (int i = 0; i < Count; i++)
        {
            double ratio = Distance(_kicks[i].Time, time);
            if (_kicks[i].Found && ratio < 1.6 && (nearest < 0 || ratio < Distance(_kicks[nearest].Time, time)))
            {
                nearest = i;
            }
        }

        if (nearest < 0 && !_hasModel)
        {
            return new TimedKick { Time = time, Speed = double.NaN };
        }

        TimedKick kick = nearest < 0 ? _problem.Guess(time) : _kicks[nearest].At(time);
        if (!_problem.Solve(ref kick) && nearest >= 0 && _hasModel && !double.IsPositiveInfinity(kick.Speed))
        {
            TimedKick again = _problem.Guess(time);
            kick = _problem.Solve(ref again) ? again : kick;
        }

        return kick;
    }

    private static double Distance(double one, double other) => one > other ? one / other : other / one;

    /// <summary>Whether there may be kicks beyond an end of the row.</summary>
    private bool GoesOn(int end) => Count > 0 && (_hasModel || _kicks[end].Found);

    private bool IsBeyond(double fastest, int outer, int inner)
    {
        if (Count < 2)
        {
            return false;
        }

        double speed = _kicks[outer].Speed;
        return speed > Beyond * fastest && (double.IsPositiveInfinity(speed) || speed > _kicks[inner].Speed);
    }
}

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
