namespace Football.Physics;

/// <summary>
/// What a piece of flight in a net does to the derivatives by the launch. Forces change much within such a piece, so it is differentiated as it was taken, its
/// length with it: that depends on how deep and how fast the ball is, and on when the piece began.
/// </summary>
internal sealed class NetPieceTangent<TAir>
    where TAir : struct, IAir
{
    /// <summary>By so much the motion at the start is changed for how the length changes with it, m.</summary>
    private const double Width = 1e-6;

    /// <summary>Share of a length by which it may differ from what was asked for, by rounding.</summary>
    private const double Rounding = 1e-9;

    private readonly Tangent _tangent;
    private readonly StepTangent<TAir> _step;
    private readonly NetGuard? _guard;

    /// <summary>When the piece begins and ends, by the launch: δt of each column.</summary>
    private readonly double[] _starts = new double[Tangent.Columns];
    private readonly double[] _ends = new double[Tangent.Columns];

    /// <summary>Whether its own length says when it ends; else it is a fixed time, or an event.</summary>
    private bool _endsByLength;

    /// <summary>How the end of the last piece changes with its length.</summary>
    private Motion _byLength;
    private double _stepEnd;
    private double _part;

    public NetPieceTangent(Tangent tangent, StepTangent<TAir> step, World? world)
    {
        _tangent = tangent;
        _step = step;
        _guard = world is null ? null : new NetGuard(world);
    }

    /// <summary>Whether the last piece was one of these.</summary>
    public bool WasTaken { get; private set; }

    /// <summary>The next piece begins at a time that does not move.</summary>
    public void Start()
    {
        Array.Clear(_starts, 0, _starts.Length);
        WasTaken = false;
        _endsByLength = false;
    }

    /// <summary>The next piece begins at a time that moves with the launch.</summary>
    /// <param name="times">δt of each column.</param>
    public void Start(double[] times)
    {
        Array.Copy(times, _starts, _starts.Length);
        WasTaken = false;
        _endsByLength = false;
    }

    /// <summary>The next piece goes on where the last one ended without an event.</summary>
    /// <param name="next">What moves the ball from there.</param>
    /// <param name="before">The ball there.</param>
    public void GoOn(LocalMotion<TAir> next, in BallState before)
    {
        if (!_endsByLength)
        {
            Start();
            return;
        }

        Shift(_ends, 1.0);
        next.Rates(before.Time, MotionVector.Of(in before), out MotionRates rates);
        _tangent.Shift(before.Velocity, in rates, _ends, -1.0);
        Start(_ends);
    }

    /// <summary>The rate ġ of an event as the step goes on with its length, and not the motion.</summary>
    /// <param name="g">The event.</param>
    /// <param name="velocity">Velocity at its end, m/s.</param>
    /// <param name="rates">Rates there.</param>
    public double Rate(in EventGradient g, in Vector3d velocity, in MotionRates rates) =>
        g.Rate + Vector3d.Dot(in g.Place, _byLength.Position - velocity) + Vector3d.Dot(in g.Velocity, _byLength.Velocity - rates.Acceleration)
        + Vector3d.Dot(in g.Spin, _byLength.Spin - rates.SpinAcceleration);

    /// <summary>After an impact a step is divided anew.</summary>
    public void Hit() => _part = 0;

    /// <summary>Takes a piece.</summary>
    /// <param name="now">What moves the ball.</param>
    /// <param name="before">The ball at its start.</param>
    /// <param name="h">Its length, s.</param>
    /// <param name="stepEnd">When the step ends that it is part of, s.</param>
    public void Propagate(LocalMotion<TAir> now, in BallState before, double h, double stepEnd)
    {
        _part = stepEnd == _stepEnd ? _part : 0;
        _stepEnd = stepEnd;
        double time = before.Time;
        Motion start = MotionVector.Of(in before);
        now.Rates(time, in start, out MotionRates rates);
        _tangent.Shift(in start.Velocity, in rates, _starts, 1.0);
        FindEnds(in before, h, stepEnd - time);
        _byLength = _step.Propagate(now, time, in start, h);
        Shift(_starts, -1.0);
        WasTaken = true;
    }

    /// <summary>J ← J ± ∂y'/∂h ⊗ δt.</summary>
    public void Shift(double[] times, double sign) =>
        _tangent.Shift(in _byLength.Position, new MotionRates(in _byLength.Velocity, in _byLength.Spin, _byLength.AirDistance), times, sign);

    /// <summary>Finds when the piece ends, by the launch.</summary>
    private void FindEnds(in BallState before, double h, double left)
    {
        double parts = _part > 0 && left > _part ? Math.Ceiling((left / _part) - Rounding) : 1.0;
        double limit = _guard!.LongestPiece(in before, left / parts);
        _part = limit < left / parts ? limit : _part;
        _endsByLength = h < left * (1.0 - Rounding) && Math.Abs(h - limit) <= Rounding * h;
        for (int c = 0; c < Tangent.Columns && _endsByLength; c++)
        {
            Motion change = _tangent.Of(c);
            double by = Width / (change.Position.Length + (1e-2 * change.Velocity.Length) + Math.Abs(_starts[c]) + 1e-6);
            double longer = Length(in before, in change, by, (left - (by * _starts[c])) / parts);
            double shorter = Length(in before, in change, -by, (left + (by * _starts[c])) / parts);
            _ends[c] = _starts[c] + ((longer - shorter) / (2.0 * by));
        }
    }

    private double Length(in BallState before, in Motion change, double by, double asked)
    {
        BallState s = before;
        s.Position += by * change.Position;
        s.Velocity += by * change.Velocity;
        return _guard!.LongestPiece(in s, asked);
    }
}
