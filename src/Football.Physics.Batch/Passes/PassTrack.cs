namespace FootballPhysics.Batch;

/// <summary>A kick along the ground, stepped as far as it was asked for. Places are relative to its start; its memory is used again.</summary>
internal sealed class PassTrack
{
    private Vector3d[] _places = new Vector3d[64];
    private double[] _slacks = new double[64];
    private BallState _state;
    private Vector3d _velocity;
    private Vector3d _spin;
    private double _acceleration = double.NaN;

    /// <summary>Steps taken.</summary>
    public int Steps { get; private set; }

    /// <summary>True when the ball rests after them.</summary>
    public bool Rests => _state.Motion == MotionState.Rest;

    /// <summary>No faster than this does the ball ever get, m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>Where the ball is after so many steps, m.</summary>
    public ref readonly Vector3d Place(int step) => ref _places[step];

    /// <summary>How far off the straight way at a steady speed the ball may be in the step that ends there, m.</summary>
    public double Slack(int step) => _slacks[step];

    /// <summary>Starts a kick, if it is not the one that it was.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="velocity">Velocity of the kick, m/s.</param>
    /// <param name="spin">Spin of the kick, rad/s.</param>
    /// <param name="acceleration">Nothing on the ground is accelerated more strongly, m/s².</param>
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

        // All of a spin may become speed, and the wind may take a slow ball along.
        Fastest = velocity.Length + (simulator.Scene.Ball.Radius * spin.Length) + (2.0 * simulator.Scene.Air.Wind.Length);
    }

    /// <summary>Takes another step.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="length">Length of the step, s.</param>
    /// <param name="log">For its events.</param>
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

        // |p − chord| ≤ a h²/8 where nothing strikes the ball; else no further than it gets: an impact turns spin into speed, and makes no energy.
        isSmooth &= _state.Motion != MotionState.Airborne && log.Events.Impacts == 0;
        _slacks[Steps] = isSmooth ? 0.125 * _acceleration * length * length : fastest * length;
    }
}
