namespace FootballPhysics.Aiming;

/// <summary>Bounds that hold for every kick up to a speed, whatever its direction and spin: the energy of the ball relative to the air.</summary>
/// <remarks>
/// Seen from a uniform horizontal wind, drag slows the ball, the Magnus force turns it, and only gravity does work: |u|² ≤ |u₀|² − 2 g h after a rise h.
/// </remarks>
internal readonly struct EnergyBound
{
    private readonly bool _holds;
    private readonly Vector3d _toTarget;
    private readonly Vector3d _targetVelocity;
    private readonly Vector3d _wind;
    private readonly double _gravity;
    private readonly double _most;
    private readonly double _tolerance;

    public EnergyBound(AimContext context, AimRequest request)
    {
        Scene scene = context.Scene;
        TargetFrame frame = context.Frame(request);
        _wind = scene.Air.Wind;
        _holds = scene.Air.WindField is null && _wind.Y == 0 && !scene.HasOwnForces && !scene.IsTilted && scene.Forces.KnuckleSeed is null && context.Upward <= 0;
        _toTarget = frame.Target - frame.From;
        _targetVelocity = request.TargetVelocity;
        _gravity = -context.Upward;
        _tolerance = request.Tolerance;

        // On the ground, friction may turn spin into speed.
        double spin = Math.Max(Math.Abs(request.TopSpin), request.MaximumTopSpin) + Math.Max(Math.Abs(request.SideSpin), request.MaximumSideSpin);
        double fromSpin = context.IsOnGround(frame.Target, request.Tolerance) ? scene.Ball.Radius * spin : 0;
        _most = request.Speed + _wind.Length + fromSpin;
    }

    /// <summary>Returns the reason if the bound excludes every kick; otherwise, that the search found none.</summary>
    public AimReason Reason => IsTooHigh ? AimReason.TooHigh : AimReason.NoneFound;

    /// <summary>True if the target is higher than the energy of any kick.</summary>
    public bool IsTooHigh => _holds && _targetVelocity.Y == 0 && 2.0 * _gravity * (_toTarget.Y - _tolerance) > _most * _most;

    /// <summary>Returns the reason for a time of arrival, in s.</summary>
    public AimReason ReasonAt(double time) => Reason == AimReason.NoneFound && IsTooFarAt(time) ? AimReason.TooFarInTime : Reason;

    /// <summary>Returns the reason for an arrival speed, in m/s.</summary>
    /// <param name="speed">The arrival speed.</param>
    /// <param name="miss">The reason if the bound excludes nothing.</param>
    public AimReason ReasonFor(double speed, AimReason miss) => IsTooHigh ? AimReason.TooHigh : IsSlowerThan(speed) ? AimReason.TooSlow : miss;

    /// <summary>True if the target is farther away at a time, in s, than any kick can be: |u| ≤ |u₀| + g t.</summary>
    private bool IsTooFarAt(double time) =>
        _holds && (_toTarget + (time * (_targetVelocity - _wind))).Length - _tolerance > time * (_most + (0.5 * _gravity * time));

    /// <summary>True if every kick is slower than a speed, in m/s, at the target.</summary>
    private bool IsSlowerThan(double speed) =>
        _holds && _targetVelocity.Y == 0 && speed > _wind.Length && (speed - _wind.Length) * (speed - _wind.Length) > (_most * _most) - (2.0 * _gravity * (_toTarget.Y - _tolerance));
}
