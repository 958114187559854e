namespace FootballPhysics.Batch;

/// <summary>A kick on the ground, stepped as far as needed. Positions are relative to its start; the memory is reused.</summary>
internal sealed class PassTrack
{
    private Vector3d[] _places = new Vector3d[64];
    private double[] _slacks = new double[64];
    private BallState _state;
    private Vector3d _velocity;
    private Vector3d _spin;
    private double _acceleration = double.NaN;

    /// <summary>The number of steps taken.</summary>
    public int Steps { get; private set; }

    /// <summary>True if the ball is at rest after these steps.</summary>
    public bool Rests => _state.Motion == MotionState.Rest;

    /// <summary>A bound on the speed of the ball, in m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>Returns the position of the ball after a number of steps, in m.</summary>
    public ref readonly Vector3d Place(int step) => ref _places[step];

    /// <summary>Returns the maximum deviation from uniform motion in the step that ends there, in m.</summary>
    public double Slack(int step) => _slacks[step];

    /// <summary>Starts a kick, unless the track already holds it.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="velocity">The velocity of the kick, in m/s.</param>
    /// <param name="spin">The spin of the kick, in rad/s.</param>
    /// <param name="acceleration">A bound on the acceleration on the ground, in m/s².</param>
    public void Start(Simulator simulator, in Vector3d velocity, in Vector3d spin, double acceleration)
    {
        if (_velocity == velocity && _spin == spin && _acceleration == acceleration)
        {
            return;
        }

        _acceleration = acceleration;
        _velocity = velocity;
        _spin = spin;
        _state = simulator.LaunchAt(new Vector3d(0, simulator.ContactHeight, 0), in velocity, in spin, 0);
        _places[0] = Vector3d.Zero;
        Steps = 0;

        // All spin may turn into speed, and the wind may drive a slow ball.
        Fastest = velocity.Length + (simulator.Scene.Ball.Radius * spin.Length) + (2.0 * simulator.Scene.Air.Wind.Length);
    }

    /// <summary>Takes another step.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="length">The length of the step, in s.</param>
    /// <param name="log">Receives the events.</param>
    public void Advance(Simulator simulator, double length, StepLog log)
    {
        if (Steps + 1 == _places.Length)
        {
            Array.Resize(ref _places, 2 * _places.Length);
            Array.Resize(ref _slacks, _places.Length);
        }

        log.Clear();
        double radius = simulator.Scene.Ball.Radius;
        double fastest = _state.Velocity.Length + (radius * _state.Spin.Length) + (length * _acceleration);
        bool isSmooth = _state.Motion != MotionState.Airborne;
        simulator.Advance(ref _state, length, log);
        Steps++;
        _places[Steps] = _state.Position - new Vector3d(0, simulator.ContactHeight, 0);

        // |p − chord| ≤ a h²/8 without impacts; otherwise at most the distance covered, since an impact turns spin into speed but adds no energy.
        isSmooth &= _state.Motion != MotionState.Airborne && log.Events.Impacts == 0;
        _slacks[Steps] = isSmooth ? 0.125 * _acceleration * length * length : fastest * length;
    }
}
