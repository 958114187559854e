namespace FootballPhysics.Labs.Following;

/// <summary>The least squares of the filter on the right points, told the times of the kicks: the yardstick.</summary>
internal sealed class FollowOracle
{
    private const int Motion = FilterHypothesis.Motion;
    private const int Most = FilterHypothesis.Most;

    /// <summary>The standard deviation of the time of a kick, s: it is known.</summary>
    private const double Known = 1e-7;

    private const int Iterations = 8;

    private readonly FilterModel _model;
    private readonly FilterPoints _points = new(2048);
    private readonly double[] _covariance = new double[Motion * Motion];
    private FilterHypothesis _now;
    private FilterHypothesis _before;
    private readonly FilterHypothesis _bound;
    private TrueKick? _kick;

    public FollowOracle(Scene scene, BallFilterSettings settings)
    {
        _model = new FilterModel(new Simulator(scene, new SolverSettings { Integrator = Integrator.Rk4 }), settings) { LogOutlier = double.NegativeInfinity };
        (_now, _before, _bound) = (new FilterHypothesis(_model, 0), new FilterHypothesis(_model, 1), new FilterHypothesis(_model, 2));
    }

    /// <summary>The estimate: position, velocity and spin.</summary>
    public double[] Estimate { get; } = new double[Motion];

    /// <summary>The covariance that the fit tells.</summary>
    public double[] Covariance => _covariance;

    /// <summary>The time of the last kick, s.</summary>
    public double LastKick { get; private set; } = double.NegativeInfinity;

    /// <summary>Predicts the position, and its deviation by the rays of the estimate.</summary>
    public (Vector3d Position, double Deviation) LookAhead(double duration)
    {
        double[] factor = (double[])_covariance.Clone();
        FilterMath.Factorize(factor, Motion);
        Vector3d center = End(-1);
        double sum = 0;
        for (int j = 0; j < Motion; j++)
        {
            sum += (End(j) - center).LengthSquared;
        }

        return (center, Math.Sqrt(sum / 3));

        Vector3d End(int column)
        {
            double[] m = [.. Estimate.Select((value, i) => value + (column < 0 ? 0 : factor[(i * Motion) + column]))];
            double time = _points.LastTime;
            BallState ball = _model.Launch(new Vector3d(m[0], m[1], m[2]), new Vector3d(m[3], m[4], m[5]), new Vector3d(m[6], m[7], m[8]), time);
            _model.Run(ref ball, time + duration);
            return ball.Position;
        }
    }

    /// <summary>Starts with the first point, at the true motion.</summary>
    public void Begin(FollowRow row, double noise)
    {
        Insert(row, noise);
        Array.Clear(_now.Mean);
        Array.Clear(_now.Prior);
        (_now.Mean[0], _now.Mean[1], _now.Mean[2]) = (row.Measured.X, row.Measured.Y, row.Measured.Z);
        SetPrior(_now, 10);
        _now.Start(row.Time, 0, double.NegativeInfinity, 0, FilterStart.Free);
        _now.IncludesStart = true;
        _now.Guess(row.Truth.Position, row.Truth.Velocity, row.Truth.Spin);
        _now.Fit(_points, Iterations);
    }

    public void Add(FollowRow row, double noise)
    {
        Insert(row, noise);
        _now.Add(_points);
    }

    /// <summary>Starts again with a kick before the next row.</summary>
    public void Kick(TrueKick kick, FollowRow row, double noise)
    {
        LastKick = kick.Time;

        // The position at the kick follows from the points before it: fit them to the end.
        _now.Fit(_points, Iterations);
        (_now, _before) = (_before, _now);
        FilterMoment last = _before.History.Last;
        FilterMath.Covariance(last, _before.Count, _covariance);
        double[] m = last.Motion;
        BallState state = _model.Launch(new Vector3d(m[0], m[1], m[2]), new Vector3d(m[3], m[4], m[5]), new Vector3d(m[6], m[7], m[8]), last.Time);
        double wait = kick.Time - last.Time;
        Array.Clear(_now.Mean);
        Array.Clear(_now.Prior);
        SetPrior(_now, 0);
        for (int i = 0; i < 3; i++)
        {
            for (int j = 0; j < 3; j++)
            {
                _now.Prior[(i * Most) + j] = At(i, j) + (wait * (At(i, j + 3) + At(i + 3, j))) + (wait * wait * At(i + 3, j + 3));
            }

            _now.Prior[(i * Most) + i] += 1e-7;
        }

        _now.Mean[9] = kick.Time;
        _now.Prior[(9 * Most) + 9] = Known * Known;
        Insert(row, noise);
        _now.Start(in state, row.Time, 0, kick.Velocity, FilterStart.Free);
        Array.Copy(_now.Mean, _bound.Mean, Most);
        Array.Copy(_now.Prior, _bound.Prior, Most * Most);
        _bound.Start(in state, row.Time, 0, kick.Velocity, FilterStart.Free);
        _kick = kick;
        _now.Fit(_points, Iterations);

        double At(int i, int j) => _covariance[(i * Motion) + j];
    }

    /// <summary>The covariance of the Cramér–Rao bound with the priors: that of the linearization at the truth.</summary>
    public double[] Bound { get; } = new double[Motion * Motion];

    /// <summary>Fits to the end, from the true motion so that no other minimum is found, and computes the estimate.</summary>
    public void Finish()
    {
        if (_kick is { } kick)
        {
            _now.Guess(Vector3d.Zero, kick.Velocity, kick.Spin);
            _bound.Guess(Vector3d.Zero, kick.Velocity, kick.Spin);
            _bound.Fit(_points, 1);
            FilterMath.Covariance(_bound.History.Last, _bound.Count, Bound);
        }

        _now.Fit(_points, Iterations);
        _now.Estimate(Estimate);
        FilterMath.Covariance(_now.History.Last, _now.Count, _covariance);
    }

    private void SetPrior(FilterHypothesis of, double place)
    {
        BallFilterSettings settings = _model.Settings;
        for (int i = 0; i < Motion; i++)
        {
            double deviation = i < 3 ? place : i < 6 ? settings.KickVelocity : settings.KickSpin;
            of.Prior[(i * Most) + i] = deviation * deviation;
        }
    }

    private void Insert(FollowRow row, double noise)
    {
        var point = new FilterPoint { Time = row.Time, Kind = FilterPointKind.Position, Value = row.Measured, Deviation = noise };
        _points.Insert(in point);
    }
}
