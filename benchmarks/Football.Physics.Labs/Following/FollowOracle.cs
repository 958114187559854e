namespace FootballPhysics.Labs.Following;

/// <summary>The least squares of the filter on the right points, told the times of the kicks: the yardstick.</summary>
internal sealed class FollowOracle
{
    private const int Motion = FilterHypothesis.Motion;
    private const int Most = FilterHypothesis.Most;

    /// <summary>The standard deviation of the time of a kick, s: it is known.</summary>
    private const double Known = 1e-7;

    private const int Iterations = 8;
    private const int BoundRounds = 4;

    /// <summary>The height above the contact up to which a ball lies, m.</summary>
    private const double OnGround = 1e-9;

    private readonly FilterModel _model;
    private readonly FilterPoints _points = new(2048);
    private readonly double[] _covariance = new double[Motion * Motion];
    private FilterHypothesis _now;
    private FilterHypothesis _before;
    private readonly FilterHypothesis _bound;
    private TrueMotion _truth;

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
        bool lies = row.Truth.Position.Y <= TruthBall.Radius + OnGround && row.Truth.Velocity.Y == 0;
        FilterStart kind = lies ? FilterStart.Rolling : FilterStart.Free;
        Vector3d measured = row.Measured;
        new FilterPriors(_model.Settings).SetStart(_now, in _points[0], in measured, kind);
        _now.Start(row.Time, 0, double.NegativeInfinity, 0, kind);
        _now.IncludesStart = true;
        _truth = row.Truth;
        FitFromTruth();
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
        FitFromTruth();
        (_now, _before) = (_before, _now);
        FilterMoment last = _before.History.Last;
        FilterMath.Covariance(last, _before.Count, _covariance);
        double[] m = _before.MotionAt(last);
        BallState state = _model.Launch(new Vector3d(m[0], m[1], m[2]), new Vector3d(m[3], m[4], m[5]), new Vector3d(m[6], m[7], m[8]), last.Time);
        double wait = kick.Time - last.Time;
        Array.Clear(_now.Mean);
        Array.Clear(_now.Prior);
        SetPrior(_now);
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
        _truth = new TrueMotion(Vector3d.Zero, kick.Velocity, kick.Spin);
        FitFromTruth();

        double At(int i, int j) => _covariance[(i * Motion) + j];
    }

    /// <summary>The covariance of the Cramér–Rao bound with the priors: that of the linearization at the truth.</summary>
    public double[] Bound { get; } = new double[Motion * Motion];

    /// <summary>True if the bound holds: between an estimate before an impact and one after it there is no linear motion.</summary>
    public bool HasBound => _bound.History.Last.IsSmooth && _now.History.Last.IsSmooth;

    /// <summary>Fits to the end, and computes the estimate and the bound.</summary>
    public void Finish()
    {
        // The first rays are as wide as the prior; later ones suit the covariance.
        for (int i = 0; i < BoundRounds; i++)
        {
            _bound.Guess(_truth.Position, _truth.Velocity, _truth.Spin);
            _bound.Fit(_points, 1);
        }

        FilterMath.Covariance(_bound.History.Last, _bound.Count, Bound);
        FitFromTruth();
        _now.MotionAt(_now.History.Last).CopyTo(Estimate, 0);
        FilterMath.Covariance(_now.History.Last, _now.Count, _covariance);
    }

    /// <summary>Fits from the true motion, so that no other minimum is found, and keeps the most probable iteration: near an impact they may not converge.</summary>
    private void FitFromTruth()
    {
        _now.Guess(_truth.Position, _truth.Velocity, _truth.Spin);
        double most = double.NegativeInfinity;
        double[] start = new double[Most];
        double[] best = new double[Most];
        for (int i = 0; i < Iterations; i++)
        {
            Array.Copy(_now.Values, start, Most);
            _now.Fit(_points, 1);
            if (_now.Evidence > most)
            {
                most = _now.Evidence;
                Array.Copy(start, best, Most);
            }
        }

        Array.Copy(best, _now.Values, Most);
        _now.Fit(_points, 1);
    }

    private void SetPrior(FilterHypothesis of)
    {
        BallFilterSettings settings = _model.Settings;
        for (int i = 3; i < Motion; i++)
        {
            double deviation = i < 6 ? settings.KickVelocity : settings.KickSpin;
            of.Prior[(i * Most) + i] = deviation * deviation;
        }
    }

    private void Insert(FollowRow row, double noise)
    {
        var point = new FilterPoint { Time = row.Time, Kind = FilterPointKind.Position, Value = row.Measured, Deviation = noise };
        _points.Insert(in point);
    }
}
