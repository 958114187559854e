namespace FootballPhysics.Labs;

/// <summary>What a kick really misses by: its closest approach to the target before its first impact, by a look-ahead in RK4 at 5 ms.</summary>
/// <param name="scene">The scene.</param>
internal sealed class TrueMiss(Scene scene)
{
    /// <summary>How much more than its tolerance a hit may miss by: its miss was measured in other steps.</summary>
    public const double Rounding = 1.01;

    private static readonly LookAheadRequest s_look = new() { TimeStep = 0.005, Duration = 30, StopAt = StopAt.Impact };

    private readonly Simulator _simulator = new(scene);
    private Trajectory _path = new(8192);

    /// <summary>The closest approach of a kick, m.</summary>
    /// <param name="request">What it was to do.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="spin">Its spin, rad/s.</param>
    public double Of(AimRequest request, Vector3d velocity, Vector3d spin)
    {
        BallState ball = _simulator.Launch(request.From, velocity, spin);
        _simulator.LookAhead(in ball, s_look, _path);
        while (!_path.IsComplete)
        {
            // A step of a light ball that spins fast has many parts.
            _path = new Trajectory(8 * _path.Pieces.Length);
            _simulator.LookAhead(in ball, s_look, _path);
        }

        // A target below contact height is raised to it, as a ball is.
        return _path.ClosestApproach(new Vector3d(request.Target.X, Math.Max(request.Target.Y, _simulator.ContactHeight), request.Target.Z)).Distance;
    }
}
