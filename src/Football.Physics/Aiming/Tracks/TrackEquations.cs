namespace Football.Physics;

/// <summary>The normal equations of a fit at some numbers: N = Σ JᵀJ/σ² and g = Σ Jᵀr/σ², what was known before included.</summary>
internal sealed class TrackEquations
{
    private readonly TrackPoint[] _track;
    private readonly TrackFitRequest _request;
    private readonly TrackModel _model;
    private readonly int _count;
    private readonly double[] _normal;
    private readonly double[] _gradient;
    private readonly double[] _row;
    private readonly double[] _system;

    /// <summary>By factor and point: how the place changes with the factor.</summary>
    private readonly Vector3d[] _byFactor;

    public TrackEquations(TrackPoint[] track, TrackFitRequest request, TrackModel model)
    {
        _track = track;
        _request = request;
        _model = model;
        _count = model.Count;
        _normal = new double[_count * _count];
        _gradient = new double[_count];
        _row = new double[_count];
        _system = new double[_count * (_count + 1)];
        _byFactor = new Vector3d[(_count - TrackModel.Launch) * track.Length];
    }

    /// <summary>N, row by row.</summary>
    public double[] Normal => _normal;

    /// <summary>χ² of the track.</summary>
    public double ChiSquared { get; private set; }

    /// <summary>χ² of the track and of what was known before.</summary>
    public double Cost { get; private set; }

    /// <summary>Whether the ball begins on the ground.</summary>
    public bool IsOnGround { get; private set; }

    /// <summary>Evaluates them.</summary>
    /// <param name="values">The numbers; a place in the ground is raised out of it.</param>
    /// <returns>False where the ball cannot be followed.</returns>
    public bool Evaluate(double[] values)
    {
        Array.Clear(_normal, 0, _normal.Length);
        Array.Clear(_gradient, 0, _count);
        ChiSquared = 0;
        for (int factor = TrackModel.Launch; factor < _count; factor++)
        {
            Difference(values, factor);
        }

        var derivatives = new LaunchDerivatives(_model.Simulator(values));
        BallState ball = TrackModel.Ball(derivatives.Simulator, values);

        // No ball begins in the ground.
        IsOnGround = ball.Position.Y > values[1] - 1e-9 && ball.Position.Y <= derivatives.Simulator.ContactHeight;
        (values[0], values[1], values[2]) = (ball.Position.X, ball.Position.Y, ball.Position.Z);
        derivatives.Start(in ball);
        for (int i = 0; i < _track.Length; i++)
        {
            double wait = i > 0 ? _track[i].Time - _track[i - 1].Time : 0;
            if (wait > 0)
            {
                derivatives.Advance(ref ball, _request.TimeStep, wait);
            }

            Vector3d off = _track[i].Position - ball.Position;
            double weight = 1.0 / (_track[i].Noise * _track[i].Noise);
            ChiSquared += weight * off.LengthSquared;
            Add(0, i, weight, off.X, derivatives.PositionByPosition.X, derivatives.PositionByVelocity.X, derivatives.PositionBySpin.X);
            Add(1, i, weight, off.Y, derivatives.PositionByPosition.Y, derivatives.PositionByVelocity.Y, derivatives.PositionBySpin.Y);
            Add(2, i, weight, off.Z, derivatives.PositionByPosition.Z, derivatives.PositionByVelocity.Z, derivatives.PositionBySpin.Z);
        }

        Cost = ChiSquared + _model.AddKnown(values, _normal, _gradient);
        return !double.IsNaN(Cost);
    }

    /// <summary>The step (N + λ diag N)⁻¹ g.</summary>
    public bool Solve(double damping, double[] step)
    {
        Fill(damping);
        bool solved = Linear.Solve(_system, step, _count);
        if (solved && IsOnGround && step[1] < 0)
        {
            Fill(damping);
            Hold(1);
            solved = Linear.Solve(_system, step, _count);
        }

        return solved && Array.TrueForAll(step, x => !double.IsNaN(x) && !double.IsInfinity(x));
    }

    /// <summary>The length of a step in standard deviations, √(sᵀ N s).</summary>
    public double Length(double[] step)
    {
        double sum = 0;
        for (int i = 0; i < _count; i++)
        {
            for (int j = 0; j < _count; j++)
            {
                sum += step[i] * _normal[(i * _count) + j] * step[j];
            }
        }

        return Math.Sqrt(Math.Max(0, sum));
    }

    /// <summary>Writes the system, with the gradient on its right.</summary>
    private void Fill(double damping)
    {
        int width = _count + 1;
        for (int i = 0; i < _count; i++)
        {
            for (int j = 0; j < _count; j++)
            {
                _system[(i * width) + j] = _normal[(i * _count) + j] * (i == j ? 1.0 + damping : 1.0);
            }

            _system[(i * width) + _count] = _gradient[i];
        }
    }

    /// <summary>Keeps a number as it is.</summary>
    private void Hold(int number)
    {
        int width = _count + 1;
        for (int i = 0; i < _count; i++)
        {
            _system[(i * width) + number] = 0;
            _system[(number * width) + i] = 0;
        }

        _system[(number * width) + number] = 1;
        _system[(number * width) + _count] = 0;
    }

    private void Add(int axis, int point, double weight, double off, in Vector3d byPosition, in Vector3d byVelocity, in Vector3d bySpin)
    {
        (_row[0], _row[1], _row[2]) = (byPosition.X, byPosition.Y, byPosition.Z);
        (_row[3], _row[4], _row[5]) = (byVelocity.X, byVelocity.Y, byVelocity.Z);
        (_row[6], _row[7], _row[8]) = (bySpin.X, bySpin.Y, bySpin.Z);
        for (int i = TrackModel.Launch; i < _count; i++)
        {
            Vector3d change = _byFactor[((i - TrackModel.Launch) * _track.Length) + point];
            _row[i] = axis == 0 ? change.X : axis == 1 ? change.Y : change.Z;
        }

        for (int i = 0; i < _count; i++)
        {
            _gradient[i] += weight * _row[i] * off;
            for (int j = 0; j < _count; j++)
            {
                _normal[(i * _count) + j] += weight * _row[i] * _row[j];
            }
        }
    }

    /// <summary>How the places change with a factor, by a central difference.</summary>
    private void Difference(double[] values, int factor)
    {
        double value = values[factor];
        int at = (factor - TrackModel.Launch) * _track.Length;
        for (int side = -1; side <= 1; side += 2)
        {
            values[factor] = value + (side * TrackFit.FactorWidth);
            Simulator simulator = _model.Simulator(values);
            BallState ball = TrackModel.Ball(simulator, values);
            var log = new StepLog();
            for (int i = 0; i < _track.Length; i++)
            {
                double wait = i > 0 ? _track[i].Time - _track[i - 1].Time : 0;
                if (wait > 0)
                {
                    simulator.Run(ref ball, _request.TimeStep, wait, StopAt.Time, log, null);
                }

                Vector3d share = side / (2.0 * TrackFit.FactorWidth) * ball.Position;
                _byFactor[at + i] = side < 0 ? share : _byFactor[at + i] + share;
            }
        }

        values[factor] = value;
    }
}
