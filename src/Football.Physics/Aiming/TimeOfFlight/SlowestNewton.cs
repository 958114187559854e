namespace Football.Physics;

/// <summary>
/// The slowest flight to a target from a few flights, where its speed falls and rises only once over the time: Newton's method to where its derivative vanishes,
/// or, where the elevation there is not allowed, to the kick on the bound.
/// </summary>
/// <remarks>It is there for its speed alone: the answers without it are the same (<c>football lab answers</c>), by many more flights.</remarks>
internal sealed class SlowestNewton
{
    private const int MostFlights = 12;
    private const int MostMoves = 5;
    private const int MostHalvings = 6;

    /// <summary>Largest change of a speed or a time in one iteration, as a share of it.</summary>
    private const double LargestChange = 0.4;

    /// <summary>Share of its time within which the slowest kick is found: what that leaves of its speed is of second order.</summary>
    private const double TimeWidth = 5e-3;

    /// <summary>A slope of the speed over the time, both in shares of themselves, that is as good as none; and one whose sign a Jacobian by updates tells.</summary>
    private const double NoSlope = 0.005;
    private const double ClearSlope = 0.15;

    /// <summary>How far apart, as shares of the time, and how many to each side, are looks beside the slowest kick; and share of its speed by which one there is slower.</summary>
    private const double Wave = 0.05;
    private const int MostWaves = 2;
    private const double Slower = 1e-4;

    private readonly TimedFlight _flight;
    private readonly TimedHits _hits;

    public SlowestNewton(TimedFlight flight, TimedHits hits)
    {
        _flight = flight;
        _hits = hits;
    }

    /// <summary>Searches.</summary>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether it was found, measured. If not, that says nothing.</returns>
    public bool Find(double upward, out AimSolution solution)
    {
        solution = default;
        AimRequest request = _flight.Request;
        if (_flight.IsRuledByAir || request.TargetVelocity != Vector3d.Zero || !(_flight.Frame.Distance > request.Tolerance) || !(upward < -1e-3))
        {
            return false;
        }

        TimedKick kick = _flight.Model(LeastOfModel(upward));
        bool found = _flight.Bounds.Contain(TimedFlight.Elevation(in kick)) && Least(ref kick);
        AimArc? arc = null;
        if (!_flight.Bounds.Contain(TimedFlight.Elevation(in kick)))
        {
            // A flatter kick than the slowest is on the low arc.
            arc = TimedFlight.Elevation(in kick) > _flight.Bounds.Highest ? AimArc.Low : AimArc.High;
            found = OnBound(ref kick);
        }

        bool hits = found && !_flight.IsDriven(in kick) && TimedHits.IsAllowed(_flight, in kick, request.Speed) && _hits.IsHit(_flight, in kick, Math.Min(kick.Speed, request.Speed), out solution);
        solution.Arc = arc;
        return hits;
    }

    /// <summary>The time of the slowest kick in closed form, about.</summary>
    private double LeastOfModel(double upward)
    {
        // Without air it is t² = 2 d/g.
        double time = Math.Sqrt(2.0 * (_flight.Frame.Target - _flight.Frame.From).Length / -upward);
        for (double width = 0.3; width > 0.1; width *= 0.5)
        {
            double curvature = ModelCurvature(time, width, out double slope);
            double move = curvature > 0 ? -slope / curvature : slope > 0 ? -width : width;
            time = Math.Min(time * Elementary.Exp(Math.Min(Math.Max(move, -0.6), 0.6)), 0.9 * AimContext.LongestFlight);
        }

        return time;
    }

    /// <summary>How the speed in closed form changes with the logarithm of the time.</summary>
    private double ModelCurvature(double time, double width, out double slope)
    {
        double ratio = Elementary.Exp(width);
        double below = _flight.Model(time / ratio).Velocity.Length;
        double here = _flight.Model(time).Velocity.Length;
        double above = _flight.Model(time * ratio).Velocity.Length;
        slope = (above - below) / (2.0 * width);
        return (above - (2.0 * here) + below) / (width * width);
    }

    /// <summary>The slowest kick without bounds, by Newton's method on the slope of its speed.</summary>
    private bool Least(ref TimedKick kick)
    {
        if (!_flight.Solve(ref kick))
        {
            return false;
        }

        for (int i = 0; i < MostMoves; i++)
        {
            _flight.Sharpen(ref kick);
            double curvature = ModelCurvature(kick.Time, 0.1, out _);
            double move = -kick.Slope() / curvature;
            if (!(curvature > 0 && Math.Abs(move) < LargestChange))
            {
                return false;
            }

            if (Math.Abs(move) < TimeWidth)
            {
                return !_flight.Bounds.Contain(TimedFlight.Elevation(in kick)) || IsLeast(in kick);
            }

            kick = kick.At(kick.Time * Elementary.Exp(move));
            if (!_flight.Solve(ref kick))
            {
                return false;
            }
        }

        return false;
    }

    /// <summary>Whether none beside it is slower: the drag law's jump makes waves.</summary>
    private bool IsLeast(in TimedKick kick)
    {
        for (int i = -MostWaves; i <= MostWaves; i++)
        {
            TimedKick beside = kick.At(kick.Time * (1.0 + (i * Wave)));
            if (i != 0 && _flight.Solve(ref beside) && beside.Speed < (1.0 - Slower) * kick.Speed)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The kick on the bound of the elevations beyond which the slowest lies, by Newton's method for speed, azimuth and time.</summary>
    /// <param name="kick">The slowest; on return the one on the bound.</param>
    /// <returns>False where it was not found, or those within the bounds are slower.</returns>
    private bool OnBound(ref TimedKick kick)
    {
        bool isHighest = TimedFlight.Elevation(in kick) > _flight.Bounds.Highest;
        double elevation = isHighest ? _flight.Bounds.Highest : _flight.Bounds.Lowest;
        kick = _flight.Model(ModelTime(elevation, kick.Time, isHighest));
        Vector3d flat = kick.Velocity.Horizontal;
        double speed = kick.Velocity.Length;
        if (!(flat.Length > 1e-3 * speed && speed <= _flight.FastestOfUse))
        {
            return false;
        }

        Vector3d ahead = flat / flat.Length;
        Elementary.SinCos(elevation, out double sine, out double cosine);
        kick.Velocity = speed * ((cosine * ahead) + (sine * Vector3d.Up));
        Vector3d gap = _flight.Fly(ref kick);
        for (int i = 1; i < MostFlights && gap.Length > _flight.Tolerance; i++)
        {
            // J (d Δv + v d' Δφ) + ṗ Δt = −r
            Vector3d left = cosine * speed * Vector3d.Cross(Vector3d.Up, in ahead);
            var columns = new VelocityJacobian(kick.Velocity / speed, in left, kick.Jacobian.Solve(in kick.Arrival, out Vector3d delay) ? delay : Vector3d.Zero);
            if (!kick.Jacobian.Solve(-gap, out Vector3d wanted) || !columns.Solve(in wanted, out Vector3d change)
                || !(Math.Abs(change.X) < LargestChange * speed && Math.Abs(change.Y) < LargestChange && Math.Abs(change.Z) < LargestChange * kick.Time))
            {
                return false;
            }

            speed += change.X;
            if (!(speed <= _flight.FastestOfUse && kick.Time + change.Z <= AimContext.LongestFlight))
            {
                return false;
            }

            Elementary.SinCos(change.Y, out double turn, out double stay);
            ahead = (stay * ahead) + (turn * Vector3d.Cross(Vector3d.Up, in ahead));
            TimedKick next = kick;
            next.Velocity = speed * ((cosine * ahead) + (sine * Vector3d.Up));
            next.Time = kick.Time + change.Z;
            Vector3d nextGap = _flight.Fly(ref next);
            next.Jacobian.Update(next.Velocity - kick.Velocity, nextGap - gap - (0.5 * change.Z * (kick.Arrival + next.Arrival)));
            kick = next;
            gap = nextGap;
        }

        kick.Miss = gap.Length;
        kick.Speed = speed;
        kick.Found = kick.Miss <= _flight.Tolerance;
        if (!kick.Found)
        {
            return false;
        }

        double slope = kick.Slope() / speed;
        if (!(Math.Abs(slope) > ClearSlope))
        {
            _flight.Sharpen(ref kick);
            slope = kick.Slope() / speed;
        }

        return isHighest ? slope < NoSlope : slope > -NoSlope;
    }

    /// <summary>When the kick in closed form has an elevation.</summary>
    private double ModelTime(double elevation, double time, bool isEarlier)
    {
        double one = time;
        double other = isEarlier ? 0.15 * time : Math.Min(6 * time, AimContext.LongestFlight);
        for (int i = 0; i < MostHalvings; i++)
        {
            double middle = Math.Sqrt(one * other);
            TimedKick kick = _flight.Model(middle);
            if (TimedFlight.Elevation(in kick) > elevation == isEarlier)
            {
                one = middle;
            }
            else
            {
                other = middle;
            }
        }

        return Math.Sqrt(one * other);
    }
}
