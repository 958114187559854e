namespace Football.Physics;

/// <summary>Where the ball of some numbers is at the times of a track, and how far that is from where it was seen.</summary>
internal sealed class TrackPaths
{
    private readonly TrackPoint[] _track;
    private readonly TrackFitRequest _request;
    private readonly TrackModel _model;
    private readonly StepLog _log = new();

    public TrackPaths(TrackPoint[] track, TrackFitRequest request, TrackModel model)
    {
        _track = track;
        _request = request;
        _model = model;
    }

    /// <summary>Coordinates seen.</summary>
    public int Rows => 3 * _track.Length;

    /// <summary>Follows a ball.</summary>
    /// <param name="values">The numbers; a place in the ground is raised out of it.</param>
    /// <param name="misses">(seen − followed)/noise of each coordinate.</param>
    /// <returns>The cost: the squares of the misses, and those of what was known before.</returns>
    public double Follow(double[] values, double[] misses)
    {
        Simulator simulator = _model.Simulator(values);
        BallState ball = TrackModel.Ball(simulator, values);
        (values[0], values[1], values[2]) = (ball.Position.X, ball.Position.Y, ball.Position.Z);
        double cost = _model.KnownCost(values);
        for (int i = 0; i < _track.Length; i++)
        {
            double wait = i > 0 ? _track[i].Time - _track[i - 1].Time : 0;
            if (wait > 0)
            {
                _log.Clear();
                simulator.Run(ref ball, _request.TimeStep, wait, StopAt.Time, _log, null);
            }

            Vector3d miss = (_track[i].Position - ball.Position) / _track[i].Noise;
            (misses[3 * i], misses[(3 * i) + 1], misses[(3 * i) + 2]) = (miss.X, miss.Y, miss.Z);
            cost += miss.LengthSquared;
        }

        return cost;
    }
}
