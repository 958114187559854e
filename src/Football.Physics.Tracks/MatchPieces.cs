using FootballPhysics.Scenes;

namespace FootballPhysics.Tracks;

/// <summary>Builds the pieces of a match from its flights: the parts between them, and the events.</summary>
internal sealed class MatchPieces(TrackRuns runs, FlightEquations equations, Simulator at, double contact)
{
    /// <summary>The maximum number of points between two flights, because trackers smooth over a touch.</summary>
    private const int Between = 3;

    /// <summary>The distance from contact height within which a ball may be on the ground, in m: heights are inaccurate there, and pitches are
    /// crowned.</summary>
    private const double Near = 0.3;

    /// <summary>The highest hop of a ball on the ground, in m.</summary>
    private const double Hop = 0.35;

    /// <summary>The largest change of velocity at a track error, in m/s, which shifts the position only.</summary>
    private const double SeamVelocity = 0.8;

    /// <summary>The change of velocity on the ground that counts as a touch, in m/s.</summary>
    private const double TouchVelocity = 1.2;

    /// <summary>The limits of an impact on any pitch.</summary>
    /// <remarks>
    /// They are the restitution, the ratio of tangential to normal impulse with its tolerance in m/s, and the speed gained from spin, in m/s.
    /// </remarks>
    private const double MostRestitution = 1.05;
    private const double MostFriction = 0.9;
    private const double UnsureTurn = 0.5;
    private const double MostGain = 1.5;

    /// <summary>The uncertainty of a change of horizontal velocity beyond those of the flights, and of a twist by friction as the velocity of a rim, in m/s.</summary>
    private const double UnsureChange = 0.05;
    private const double UnsureTwist = 1;

    /// <summary>The growth of a flight's squared residuals, in variances, above which the spin after an impact is not that of the flight.</summary>
    private const double MostContradiction = 16;

    private readonly TrackPoint[] _track = runs.Points;
    private readonly TrackRuns _runs = runs;
    private readonly FlightEquations _equations = equations;
    private readonly Simulator _at = at;
    private readonly double _upward = Weight.UpwardAcceleration(at.Scene);
    private readonly double _contact = contact;

    /// <summary>Returns the heights at which the ball is on the ground: between a falling and a rising flight, and where it neither rises nor
    /// falls.</summary>
    public static List<double> GroundHeights(TrackRuns runs, IReadOnlyList<int> ends, List<FlightPath> flights, Simulator at)
    {
        TrackPoint[] track = runs.Points;
        List<double> heights = [];
        double upward = Weight.UpwardAcceleration(at.Scene);
        for (int i = 0; i + 1 < flights.Count; i++)
        {
            FlightPath a = flights[i];
            FlightPath b = flights[i + 1];
            if (b.First - a.End <= Between && a.Last.Velocity.Y < -1 && b.Velocity.Y > 0.5)
            {
                Meet(track, a, b, upward, out _, out Vector3d place, out _, out _);
                heights.Add(place.Y);
            }
        }

        int first = 0;
        foreach (int end in ends)
        {
            bool flies = flights.Exists(f => f.First < end && f.End > first);
            if (!flies && end - first >= 5)
            {
                double least = double.PositiveInfinity;
                double most = double.NegativeInfinity;
                for (int i = first; i < end; i++)
                {
                    least = Math.Min(least, track[i].Position.Y);
                    most = Math.Max(most, track[i].Position.Y);
                }

                if (most - least < Hop)
                {
                    heights.Add(0.5 * (least + most));
                }
            }

            first = end;
        }

        return heights;
    }

    /// <summary>Builds the pieces.</summary>
    public List<MatchPiece> Make(IReadOnlyList<int> ends, List<FlightPath> flights)
    {
        // 1. The flights, and the parts between them, in order. 2. The event from each to the next.
        List<MatchPiece> steady = [];
        List<FlightPath?> paths = [];
        int at = 0;
        foreach (FlightPath flight in flights)
        {
            AddRest(steady, paths, ends, at, flight.First, at > 0);
            steady.Add(Flight(flight));
            paths.Add(flight);
            at = flight.End;
        }

        AddRest(steady, paths, ends, at, _track.Length, at > 0);
        List<MatchPiece> pieces = [];
        for (int i = 0; i < steady.Count; i++)
        {
            if (i > 0 && Event(steady[i - 1], paths[i - 1], steady[i], paths[i]) is { } between)
            {
                pieces.Add(between);
            }

            pieces.Add(steady[i]);
        }

        return pieces;
    }

    /// <summary>Sets the prior spin of flights that follow an impact.</summary>
    /// <remarks>
    /// Friction at the contact changes velocity and spin together on any surface, Δω = n × (−Δv)/(α r). So the impact predicts the spin of the next
    /// flight, which the air alone would hardly reveal in such a short time.
    /// </remarks>
    /// <param name="flights">The flights, in order of time.</param>
    /// <param name="spinDeviation">The prior standard deviation of a spin component of a flight whose predecessor reveals no spin, in rad/s.</param>
    /// <param name="doubt">The doubt about a spin as a share of it, beyond its standard deviation, because the laws of the ball are in doubt.</param>
    /// <param name="fit">Fits a flight again after its prior changed; the next flight uses the result.</param>
    public void SetPriorSpins(List<FlightPath> flights, double spinDeviation, double doubt, Action<FlightPath> fit)
    {
        BallProperties ball = _at.Scene.Ball;
        double lever = 1.0 / (ball.InertiaFactor * ball.Radius);
        for (int i = 0; i + 1 < flights.Count; i++)
        {
            FlightPath a = flights[i];
            FlightPath b = flights[i + 1];
            if (b.First - a.End > Between || HasGap(a.End - 1, b.First))
            {
                continue;
            }

            Meet(_track, a, b, _upward, out double time, out Vector3d place, out Vector3d before, out Vector3d after);
            if ((after - before).Length < SeamVelocity || ImpactOr(time, place, before, a.Last.Spin, after, b.Spin, b).Kind != MatchPieceKind.Impact)
            {
                continue;
            }

            Vector3d change = (after - before).Horizontal;
            Vector3d unsure = Deviations(a, 6);
            double doubtful = doubt * a.Spin.Length;
            b.LikelySpin = a.Last.Spin - (lever * Vector3d.Cross(Vector3d.Up, in change));
            b.LikelySpinDeviation = new Vector3d(Unsure(unsure.X, Change(2)), Unsure(unsure.Y, lever * UnsureTwist), Unsure(unsure.Z, Change(0)));
            double[] free = b.Values;
            double rms = b.Rms;
            b.Values = (double[])free.Clone();
            fit(b);

            // A kick near the ground looks like an impact, but its flight contradicts the spin of one.
            double assumed = _equations.Deviation(in _track[b.First]);
            if (b.Count * ((b.Rms * b.Rms) - (rms * rms)) > MostContradiction * assumed * assumed)
            {
                (b.LikelySpin, b.LikelySpinDeviation, b.Values) = (Vector3d.Zero, Vector3d.Zero, free);
                fit(b);
            }

            double Unsure(double before, double change) =>
                before > 0 ? Math.Sqrt((before * before) + (doubtful * doubtful) + (change * change)) : spinDeviation;
            double Change(int axis) =>
                lever * Math.Sqrt((UnsureChange * UnsureChange) + (Deviation(a, 3 + axis) * Deviation(a, 3 + axis)) + (Deviation(b, 3 + axis) * Deviation(b, 3 + axis)));
        }
    }

    /// <summary>Returns the time and position at which two flights meet: the closest approach of their extrapolated paths.</summary>
    private static void Meet(TrackPoint[] track, FlightPath a, FlightPath b, double upward, out double time, out Vector3d place, out Vector3d before, out Vector3d after)
    {
        double end = track[a.End - 1].Time;
        double wait = track[b.First].Time - end;
        Vector3d va = a.Last.Velocity;
        Vector3d vb = b.Velocity;

        // a(t) = pa + va t, b(t) = pb + vb (t − wait):  least |a − b|²
        Vector3d apart = b.Position - (wait * vb) - a.Last.Position;
        Vector3d closing = va - vb;
        double square = closing.LengthSquared;
        double t = square > 1e-6 ? Vector3d.Dot(in apart, in closing) / square : 0.5 * wait;
        t = Math.Min(2 * wait, Math.Max(-wait, t));
        time = end + t;
        var g = new Vector3d(0, upward, 0);
        before = va + (t * g);
        after = vb + ((t - wait) * g);
        Vector3d pa = a.Last.Position + (t * va) + (0.5 * t * t * g);
        Vector3d pb = b.Position + ((t - wait) * vb) + (0.5 * (t - wait) * (t - wait) * g);
        place = 0.5 * (pa + pb);
    }

    private MatchPiece Flight(FlightPath flight)
    {
        var fitted = new Vector3d[flight.Count];
        _equations.Follow(_at, flight, flight.Values, fitted);
        return new MatchPiece
        {
            Kind = MatchPieceKind.Flight,
            StartTime = _track[flight.First].Time,
            EndTime = _track[flight.End - 1].Time,
            Points = flight.Count,
            Rms = flight.Rms,
            MaximumResidual = flight.Worst,
            Position = flight.Position,
            Velocity = flight.Velocity,
            Spin = flight.Spin,
            VelocityDeviation = Deviations(flight, 3),
            SpinDeviation = Deviations(flight, 6),
            Observed = Points(flight.First, flight.End),
            Fitted = fitted,
        };
    }

    private static Vector3d Deviations(FlightPath flight, int at) => new(Deviation(flight, at), Deviation(flight, at + 1), Deviation(flight, at + 2));

    private static double Deviation(FlightPath flight, int at) => Math.Sqrt(Math.Max(0, flight.Covariance[(at * FlightPath.Launch) + at]));

    private TrackPoint[] Points(int first, int end)
    {
        var points = new TrackPoint[end - first];
        Array.Copy(_track, first, points, 0, points.Length);
        return points;
    }

    /// <summary>Adds the pieces between two flights: ground, lost parts and gaps.</summary>
    private void AddRest(List<MatchPiece> steady, List<FlightPath?> paths, IReadOnlyList<int> ends, int first, int end, bool follows)
    {
        // A few points between two flights belong to the event there.
        if (end - first <= Between && follows && end < _track.Length && !HasGap(first - 1, end))
        {
            return;
        }

        int from = first;
        while (from < end)
        {
            AddGap(steady, paths, from);
            int to = PieceEnd(ends, from, end);
            bool low = IsLow(from, to);
            while (to < end && !_runs.IsGap(_track[to - 1].Time, _track[to].Time))
            {
                int next = PieceEnd(ends, to, end);
                if (IsLow(to, next) != low || (low && IsTouched(from, to, next)))
                {
                    break;
                }

                to = next;
            }

            steady.Add(Rest(low ? MatchPieceKind.Ground : MatchPieceKind.Lost, ends, from, to));
            paths.Add(null);
            from = to;
        }

        if (end < _track.Length)
        {
            AddGap(steady, paths, end);
        }
    }

    private void AddGap(List<MatchPiece> steady, List<FlightPath?> paths, int at)
    {
        if (at > 0 && _runs.IsGap(_track[at - 1].Time, _track[at].Time) && (steady.Count == 0 || steady[steady.Count - 1].EndTime < _track[at].Time))
        {
            steady.Add(new MatchPiece { Kind = MatchPieceKind.Lost, StartTime = _track[at - 1].Time, EndTime = _track[at].Time, Position = _track[at - 1].Position });
            paths.Add(null);
        }
    }

    private bool HasGap(int first, int end)
    {
        for (int i = Math.Max(1, first + 1); i <= Math.Min(end, _track.Length - 1); i++)
        {
            if (_runs.IsGap(_track[i - 1].Time, _track[i].Time))
            {
                return true;
            }
        }

        return false;
    }

    private static int PieceEnd(IReadOnlyList<int> ends, int at, int end)
    {
        int low = 0;
        int high = ends.Count - 1;
        while (low < high)
        {
            int middle = (low + high) / 2;
            (low, high) = ends[middle] > at ? (low, middle) : (middle + 1, high);
        }

        return Math.Min(end, ends[low]);
    }

    /// <summary>True if half of the points are as low as a ball on the ground.</summary>
    private bool IsLow(int first, int end)
    {
        double[] heights = Array.ConvertAll(_track[first..end], point => point.Position.Y);
        Array.Sort(heights);
        return heights[heights.Length / 2] < _contact + Hop;
    }

    /// <summary>True if the velocity of a ball on the ground changes between two segments by more than friction can cause.</summary>
    private bool IsTouched(int first, int at, int end)
    {
        int before = Math.Max(first, at - 8);
        int after = Math.Min(end, at + 8);
        if (at - before < 4 || after - at < 4)
        {
            return false;
        }

        double time = 0.5 * (_track[at - 1].Time + _track[at].Time);
        double span = Math.Min(_track[at - 1].Time - _track[before].Time, _track[after - 1].Time - _track[at].Time);
        Vector3d change = TrackPolynomial.Of(_track, at, after, 1).VelocityAt(time) - TrackPolynomial.Of(_track, before, at, 1).VelocityAt(time);
        return change.Horizontal.Length > TouchVelocity + (6 * _runs.Noise / (span * Math.Sqrt(after - at)));
    }

    /// <summary>Creates a piece that no law of flight describes, from the cubics of the division.</summary>
    private MatchPiece Rest(MatchPieceKind kind, IReadOnlyList<int> ends, int first, int end)
    {
        var fitted = new Vector3d[end - first];
        double squares = 0;
        double worst = 0;
        for (int from = first, to; from < end; from = to)
        {
            to = PieceEnd(ends, from, end);
            var cubic = TrackPolynomial.Of(_track, from, to, 3);
            for (int i = from; i < to; i++)
            {
                fitted[i - first] = cubic.At(_track[i].Time);
                double square = (_track[i].Position - fitted[i - first]).LengthSquared;
                squares += square;
                worst = Math.Max(worst, square);
            }
        }

        int few = Math.Min(end, first + 8);
        double time = _track[first].Time;
        var start = TrackPolynomial.Of(_track, first, few, 1);
        return new MatchPiece
        {
            Kind = kind,
            StartTime = time,
            EndTime = _track[end - 1].Time,
            Points = end - first,
            Rms = Math.Sqrt(squares / (end - first)),
            MaximumResidual = Math.Sqrt(worst),
            Position = _track[first].Position,
            Velocity = few - first > 1 ? start.VelocityAt(time) : Vector3d.Zero,
            Observed = Points(first, end),
            Fitted = fitted,
        };
    }

    /// <summary>Returns the event between two pieces; null if there is none.</summary>
    private MatchPiece? Event(MatchPiece before, FlightPath? a, MatchPiece after, FlightPath? b)
    {
        if (a is null && b is null)
        {
            bool touched = before.Kind == MatchPieceKind.Ground && after.Kind == MatchPieceKind.Ground;
            return touched ? Touch(after.StartTime, after.Position, EndVelocity(before), Vector3d.Zero, after.Velocity, Vector3d.Zero) : null;
        }

        if (before.Points == 0 || after.Points == 0)
        {
            return null;
        }

        if (a is not null && b is not null)
        {
            Meet(_track, a, b, _upward, out double time, out Vector3d place, out Vector3d from, out Vector3d to);
            time = Math.Min(after.StartTime, Math.Max(before.EndTime, time));
            return (to - from).Length < SeamVelocity
                ? new MatchPiece { Kind = MatchPieceKind.Lost, StartTime = before.EndTime, EndTime = after.StartTime, Position = place, Velocity = to }
                : ImpactOr(time, place, from, a.Last.Spin, to, b.Spin, b);
        }

        if (a is not null)
        {
            // The flight ends on the ground or at a touch, such as a catch.
            double fall = Math.Max(0, after.StartTime - before.EndTime);
            Vector3d speed = a.Last.Velocity + (0.5 * fall * new Vector3d(0, _upward, 0));
            var to = new Vector3d(after.Velocity.X, Math.Max(0, after.Velocity.Y), after.Velocity.Z);
            return after.Kind == MatchPieceKind.Ground
                ? ImpactOr(0.5 * (before.EndTime + after.StartTime), after.Position, speed, a.Last.Spin, to, Vector3d.Zero, null)
                : Touch(after.StartTime, after.Position, speed, a.Last.Spin, after.Velocity, Vector3d.Zero);
        }

        return before.Kind == MatchPieceKind.Ground || (b!.Velocity - EndVelocity(before)).Length > TouchVelocity
            ? Touch(after.StartTime, b!.Position, EndVelocity(before), Vector3d.Zero, b.Velocity, b.Spin)
            : null;
    }

    private static Vector3d EndVelocity(MatchPiece piece)
    {
        TrackPoint[] points = (TrackPoint[])piece.Observed;
        int few = Math.Min(points.Length, 8);
        return few < 2 ? Vector3d.Zero : TrackPolynomial.Of(points, points.Length - few, points.Length, 1).VelocityAt(points[points.Length - 1].Time);
    }

    private static MatchPiece Touch(double time, Vector3d place, Vector3d before, Vector3d spinBefore, Vector3d after, Vector3d spin) => new()
    {
        Kind = MatchPieceKind.Touch,
        StartTime = time,
        EndTime = time,
        Position = place,
        VelocityBefore = before,
        SpinBefore = spinBefore,
        Velocity = after,
        Spin = spin,
    };

    /// <summary>Returns an impact if the velocities allow one; otherwise a touch.</summary>
    private MatchPiece ImpactOr(double time, Vector3d place, Vector3d before, Vector3d spinBefore, Vector3d after, Vector3d spin, FlightPath? flight)
    {
        Vector3d along = before.Horizontal;
        Vector3d left = after.Horizontal;
        double speed = along.Length;
        double restitution = before.Y < 0 ? Math.Max(0, after.Y) / -before.Y : double.PositiveInfinity;
        double kept = speed > 0 ? Vector3d.Dot(in along, in left) / (speed * speed) : 1;
        double impulse = after.Y - before.Y;
        bool isImpact = Math.Abs(place.Y - _contact) < Near && restitution < MostRestitution
            && (left - along).Length < (MostFriction * impulse) + UnsureTurn && after.Length < before.Length + MostGain;
        return !isImpact ? Touch(time, place, before, spinBefore, after, spin) : new MatchPiece
        {
            Kind = MatchPieceKind.Impact,
            StartTime = time,
            EndTime = time,
            Position = place,
            VelocityBefore = before,
            SpinBefore = spinBefore,
            Velocity = after,
            Spin = spin,
            Restitution = flight is null ? null : restitution,
            SpeedRetained = kept,
            VelocityDeviation = flight is null ? Vector3d.Zero : Deviations(flight, 3),
            SpinDeviation = flight is null ? Vector3d.Zero : Deviations(flight, 6),
        };
    }
}
