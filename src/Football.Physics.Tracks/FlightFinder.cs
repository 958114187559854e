using FootballPhysics.Scenes;

namespace FootballPhysics.Tracks;

/// <summary>Finds the flights of a track: segments that fall like a ball in flight, joined if one flight explains both.</summary>
internal sealed class FlightFinder
{
    /// <summary>The error of a cubic as an approximation of a flight, in m.</summary>
    private const double CubicError = 0.02;

    /// <summary>The error of a cubic as an approximation of a hop, in m.</summary>
    private const double HopError = 0.006;

    /// <summary>The cost of a segment, in squared standard deviations, and that of a hop.</summary>
    /// <remarks>Hops cost less: they are sought only where no flight was found, and must fall like a ball.</remarks>
    private const double Price = 40;
    private const double HopPrice = 30;

    /// <summary>The longest segment, in s.</summary>
    private const double LongestPiece = 1.6;

    /// <summary>The minimum number of points and duration, in s, of a useful segment.</summary>
    private const int LeastPoints = 5;
    private const double LeastTime = 0.09;

    /// <summary>The tolerance of a flight's fall against g, in m/s², plus the lift of the maximum C_L and a number of standard deviations.</summary>
    private const double FallError = 2.5;
    private const double MostLift = 0.4;
    private const double FallDeviations = 3;

    /// <summary>The height above the lowest tenth of the track, in m, below which a flight must fall by this share of g.</summary>
    private const double High = 0.8;
    private const double LeastFall = -0.3;

    /// <summary>The largest growth of the mean square when two segments are joined, as a factor and in m.</summary>
    private const double JointShare = 1.3;
    private const double JointError = 0.05;

    /// <summary>The difference of velocities between two segments above which the ball was touched, in m/s.</summary>
    private const double JointVelocity = 0.8;

    /// <summary>The maximum number of points between two flights, because trackers smooth over a touch.</summary>
    private const int Between = 3;

    /// <summary>The largest residual of a flight, in m and in standard deviations.</summary>
    private const double MostRms = 0.15;
    private const double MostRmsShare = 4;

    /// <summary>The factors of drag and of the critical Reynolds number that define the trial balls.</summary>
    /// <remarks>A segment that is one flight with any of them is also one with the ball to be found.</remarks>
    private static readonly (double Drag, double Crisis)[] Balls = [(1, 1), (1, 0.6), (0.5, 1)];

    private static readonly MatchFitRequest Nothing = new() { Wind = false, Drag = false };

    private readonly TrackRuns _runs;
    private readonly Scene _scene;
    private readonly FlightEquations _system;
    private readonly double _low;
    private SharedFit[] _fits;

    public FlightFinder(TrackRuns runs, Scene scene, FlightEquations system)
    {
        _runs = runs;
        _scene = scene;
        _system = system;
        double[] heights = Array.ConvertAll(runs.Points, point => point.Position.Y);
        Array.Sort(heights);
        _low = heights[heights.Length / 10];
        _fits = new SharedFit[Balls.Length];
        for (int i = 0; i < _fits.Length; i++)
        {
            (double drag, double crisis) = Balls[i];
            DragCurve curve = scene.Ball.DragCurve;
            Scene tried = crisis == 1 ? scene : scene with { Ball = scene.Ball with { DragCurve = curve.WithCrisisAt(crisis * curve.CriticalReynolds) } };
            ForceSet forces = tried.Forces with { CustomForces = [.. tried.Forces.CustomForces, new ScaledAir(tried, drag, 1)] };
            _fits[i] = new SharedFit(system, new MatchModel(drag == 1 ? tried : tried with { Forces = forces }, Nothing));
        }
    }

    /// <summary>The exclusive end of each segment.</summary>
    public List<int> Ends { get; } = [];

    /// <summary>Finds the flights, in order of time.</summary>
    public List<FlightPath> Find(FitWatch watch)
    {
        // 1. The best division into cubics. 2. Those that fall. 3. Join neighbours that are one flight. With tiny waits between points, their number
        // in the longest segment may exceed an int, so limit it to the length of the track.
        int longest = (int)Math.Max(8, Math.Min(LongestPiece / _runs.Wait, _runs.Points.Length));
        var segments = new TrackSegments(_runs.Points, Math.Sqrt((_runs.Noise * _runs.Noise) + (CubicError * CubicError)), longest, Price);
        int first = 0;
        foreach (int end in _runs.Ends)
        {
            watch.Check();
            segments.Divide(first, end, Ends, watch);
            first = end;
        }

        List<FlightPath> flights = [];
        Take(Ends, 0, flights, watch);
        JoinNeighbours(flights, watch);
        FindHops(flights, longest, watch);
        return flights;
    }

    /// <summary>Adds the segments that are flights.</summary>
    private void Take(List<int> ends, int first, List<FlightPath> flights, FitWatch watch)
    {
        foreach (int end in ends)
        {
            watch.Check();
            var flight = new FlightPath(first, end);
            if (Falls(first, end) && Fit(flight, null, watch))
            {
                flights.Add(flight);
            }

            first = end;
        }
    }

    /// <summary>Divides the rest of the track more finely, to find hops; a single cubic fits several hops to within centimetres.</summary>
    private void FindHops(List<FlightPath> flights, int longest, FitWatch watch)
    {
        var fine = new TrackSegments(_runs.Points, Math.Sqrt((_runs.Noise * _runs.Noise) + (HopError * HopError)), longest, HopPrice);
        List<int> all = [];
        List<FlightPath> hops = [];
        int at = 0;
        for (int i = 0; i <= flights.Count; i++)
        {
            int next = i < flights.Count ? flights[i].First : _runs.Points.Length;
            int from = at;
            foreach (int run in _runs.Ends)
            {
                int end = Math.Min(run, next);
                if (end > from)
                {
                    List<int> ends = [];
                    fine.Divide(from, end, ends, watch);
                    Take(ends, from, hops, watch);
                    all.AddRange(ends);
                    from = end;
                }
            }

            if (i < flights.Count)
            {
                at = flights[i].End;
                all.Add(at);
            }
        }

        Ends.Clear();
        Ends.AddRange(all);
        flights.AddRange(hops);
        flights.Sort((a, b) => a.First.CompareTo(b.First));
    }

    /// <summary>Joins neighbours that are one flight of a given ball.</summary>
    public void JoinBy(SharedFit fit, List<FlightPath> flights, FitWatch watch)
    {
        // Fit the launches only, in the scene that was found.
        _fits = [new SharedFit(_system, new MatchModel(fit.At.Scene with { Ground = _scene.Ground }, Nothing))];
        JoinNeighbours(flights, watch);
    }

    private void JoinNeighbours(List<FlightPath> flights, FitWatch watch)
    {
        for (int i = 0; i + 1 < flights.Count;)
        {
            watch.Check();
            if (Join(flights[i], flights[i + 1], watch) is { } joint)
            {
                flights[i] = joint;
                flights.RemoveAt(i + 1);
                i = Math.Max(0, i - 1);
            }
            else
            {
                i++;
            }
        }
    }

    /// <summary>True if a segment accelerates downwards like a ball in flight.</summary>
    private bool Falls(int first, int end)
    {
        TrackPoint[] track = _runs.Points;
        double time = track[end - 1].Time - track[first].Time;
        if (end - first < LeastPoints || time < LeastTime)
        {
            return false;
        }

        // The standard deviation of a parabola's acceleration is √720 σ/(T² √n).
        var parabola = TrackPolynomial.Of(track, first, end, 2);
        double upward = parabola.Acceleration.Y;
        double speed = (track[end - 1].Position - track[first].Position).Length / time;
        double area = Math.PI * _scene.Ball.Radius * _scene.Ball.Radius;
        double lift = 0.5 * _scene.Air.Density * area / _scene.Ball.Mass * MostLift * speed * speed;
        double seen = Math.Sqrt(720.0 / (end - first)) * Math.Max(_runs.Noise, 0.25 * CubicError) / (time * time);
        double off = Math.Abs(upward - Weight.UpwardAcceleration(_scene));

        // A fast ball with backspin may even rise, but not along the ground.
        bool isHigh = parabola.At(0.5 * (track[first].Time + track[end - 1].Time)).Y > _low + High;
        return off < FallError + lift + (FallDeviations * seen) && (isHigh || upward < LeastFall * _scene.Gravity);
    }

    /// <summary>Fits a single flight, with each of the trial balls, and keeps the best.</summary>
    private bool Fit(FlightPath flight, double[]? start, FitWatch watch)
    {
        double[] best = flight.Values;
        SharedFit? found = null;
        double least = double.PositiveInfinity;
        foreach (SharedFit fit in _fits)
        {
            flight.Values = start is null ? Start(flight) : (double[])start.Clone();
            fit.Descend([flight], [1], watch);
            if (flight.Rms < least)
            {
                (least, best, found) = (flight.Rms, flight.Values, fit);
            }
        }

        flight.Values = best;
        if (found is not null)
        {
            _system.Measure(found.At, flight);
        }

        return least < Math.Max(MostRms, MostRmsShare * _runs.Noise);
    }

    private double[] Start(FlightPath flight)
    {
        var path = TrackPolynomial.Of(_runs.Points, flight.First, flight.End, flight.Count > 8 ? 3 : 2);
        Vector3d position = path.At(_runs.Points[flight.First].Time);
        Vector3d velocity = path.VelocityAt(_runs.Points[flight.First].Time);
        return [position.X, position.Y, position.Z, velocity.X, velocity.Y, velocity.Z, 0, 0, 0];
    }

    /// <summary>Returns two flights as one if a single flight explains both; otherwise null.</summary>
    private FlightPath? Join(FlightPath a, FlightPath b, FitWatch watch)
    {
        TrackPoint[] track = _runs.Points;
        if (b.First - a.End > Between || _runs.IsGap(track[a.End - 1].Time, track[a.End].Time) || _runs.IsGap(track[b.First - 1].Time, track[b.First].Time))
        {
            return null;
        }

        double wait = track[b.First].Time - track[a.End - 1].Time;
        Vector3d velocity = a.Last.Velocity + (wait * new Vector3d(0, Weight.UpwardAcceleration(_scene), 0));
        double noise = 12 * _runs.Noise / (Math.Sqrt(Math.Min(a.Count, b.Count)) * Math.Min(Duration(a), Duration(b)));
        if ((b.Velocity - velocity).Length > JointVelocity + noise)
        {
            return null;
        }

        var joint = new FlightPath(a.First, b.End);
        double apart = ((a.Count * a.Rms * a.Rms) + (b.Count * b.Rms * b.Rms)) / (a.Count + b.Count);
        bool fits = Fit(joint, a.Values, watch);
        return fits && joint.Rms * joint.Rms < (JointShare * apart) + (JointError * JointError) ? joint : null;
    }

    private double Duration(FlightPath flight) => _runs.Points[flight.End - 1].Time - _runs.Points[flight.First].Time;
}
