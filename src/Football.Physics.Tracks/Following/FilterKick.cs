namespace FootballPhysics.Tracks;

/// <summary>The ball at a kick, on the path before it.</summary>
/// <remarks>Most rays have the kick at the same time, so the last state is kept.</remarks>
internal sealed class FilterKick(FilterModel model)
{
    private BallState _before;
    private BallState _last;
    private double _time = double.NaN;

    /// <summary>Sets the last state that is known before the kick.</summary>
    public void Begin(in BallState before)
    {
        _before = before;
        _time = double.NaN;
    }

    /// <summary>Starts from the state before another kick.</summary>
    public void Begin(FilterKick other) => Begin(in other._before);

    /// <summary>Returns the position of the ball at a time of the kick, in m.</summary>
    public Vector3d PositionAt(double time)
    {
        if (!_time.Equals(time))
        {
            (_last, _time) = (_before, time);
            model.Run(ref _last, time);
        }

        return _last.Position;
    }

    public void Transfer(ref FilterStream stream)
    {
        Span<BallState> before = [_before];
        stream.Plain(before);
        Begin(in before[0]);
    }
}
