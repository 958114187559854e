namespace Football.Physics;

/// <summary>The normal equations of a fit at some numbers: N = Σ JᵀJ/σ² and g = Σ Jᵀr/σ², what was known before included.</summary>
internal sealed class TrackEquations
{
    /// <summary>Change of a factor for a difference quotient.</summary>
    private const double FactorWidth = 1e-3;

    private readonly TrackPoint[] _track;
    private readonly TrackFitRequest _request;
    private readonly TrackModel _model;
    private readonly TrackPaths _paths;
    private readonly int _count;
    private readonly double[] _normal;
    private readonly double[] _gradient;
    private readonly double[] _system;
    private readonly double[] _misses;
    private readonly double[] _changed;

    /// <summary>By row and number: how the place changes, in units of its noise.</summary>
    private readonly double[] _jacobian;

    public TrackEquations(TrackPoint[] track, TrackFitRequest request, TrackModel model, TrackPaths paths)
    {
        _track = track;
        _request = request;
        _model = model;
        _paths = paths;
        _count = model.Count;
        _normal = new double[_count * _count];
        _gradient = new double[_count];
        _system = new double[_count * (_count + 1)];
        _misses = new double[paths.Rows];
        _changed = new double[paths.Rows];
        _jacobian = new double[paths.Rows * _count];
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
    public void Evaluate(double[] values)
    {
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

            double perNoise = 1.0 / _track[i].Noise;
            Vector3d miss = perNoise * (_track[i].Position - ball.Position);
            (_misses[3 * i], _misses[(3 * i) + 1], _misses[(3 * i) + 2]) = (miss.X, miss.Y, miss.Z);
            Set(3 * i, perNoise, derivatives.PositionByPosition.X, derivatives.PositionByVelocity.X, derivatives.PositionBySpin.X);
            Set((3 * i) + 1, perNoise, derivatives.PositionByPosition.Y, derivatives.PositionByVelocity.Y, derivatives.PositionBySpin.Y);
            Set((3 * i) + 2, perNoise, derivatives.PositionByPosition.Z, derivatives.PositionByVelocity.Z, derivatives.PositionBySpin.Z);
        }

        for (int factor = TrackModel.Launch; factor < _count; factor++)
        {
            Difference(values, factor);
        }

        Array.Clear(_normal, 0, _normal.Length);
        Array.Clear(_gradient, 0, _count);
        ChiSquared = 0;
        for (int row = 0; row < _misses.Length; row++)
        {
            int at = row * _count;
            ChiSquared += _misses[row] * _misses[row];
            for (int i = 0; i < _count; i++)
            {
                _gradient[i] += _jacobian[at + i] * _misses[row];
                for (int j = 0; j < _count; j++)
                {
                    _normal[(i * _count) + j] += _jacobian[at + i] * _jacobian[at + j];
                }
            }
        }

        Cost = ChiSquared + _model.AddKnown(values, _normal, _gradient);
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

    private void Set(int row, double perNoise, in Vector3d byPosition, in Vector3d byVelocity, in Vector3d bySpin)
    {
        int at = row * _count;
        (_jacobian[at], _jacobian[at + 1], _jacobian[at + 2]) = (perNoise * byPosition.X, perNoise * byPosition.Y, perNoise * byPosition.Z);
        (_jacobian[at + 3], _jacobian[at + 4], _jacobian[at + 5]) = (perNoise * byVelocity.X, perNoise * byVelocity.Y, perNoise * byVelocity.Z);
        (_jacobian[at + 6], _jacobian[at + 7], _jacobian[at + 8]) = (perNoise * bySpin.X, perNoise * bySpin.Y, perNoise * bySpin.Z);
    }

    /// <summary>How the misses change with a factor, by a difference.</summary>
    private void Difference(double[] values, int factor)
    {
        double value = values[factor];
        values[factor] = value + FactorWidth;
        _paths.Follow(values, _changed);
        values[factor] = value;
        for (int row = 0; row < _misses.Length; row++)
        {
            _jacobian[(row * _count) + factor] = (_misses[row] - _changed[row]) / FactorWidth;
        }
    }
}
