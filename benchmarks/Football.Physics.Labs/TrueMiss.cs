namespace FootballPhysics.Labs;

/// <summary>Computes the true miss of a kick: its closest approach to the target before its first impact, by a look-ahead in RK4 at 5 ms.</summary>
/// <param name="scene">The scene.</param>
internal sealed class TrueMiss(Scene scene)
{
    /// <summary>The factor by which a hit may exceed its tolerance: its miss was measured with other steps.</summary>
    public const double Rounding = 1.01;

    private static readonly LookAheadRequest s_look = new() { TimeStep = 0.005, Duration = 30, StopAt = StopAt.Impact };

    private readonly Simulator _simulator = new(scene);
    private Trajectory _path = new(8192);

    /// <summary>Returns the closest approach of a kick, m.</summary>
    /// <param name="request">The request.</param>
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

        // A target below contact height is raised to it, like a ball.
        return _path.ClosestApproach(new Vector3d(request.Target.X, Math.Max(request.Target.Y, _simulator.ContactHeight), request.Target.Z)).Distance;
    }
}
