namespace FootballPhysics.Labs.Intercept;

/// <summary>Finds when a runner can reach a ball by sampling: the reference for the search with bounds.</summary>
internal sealed class MeetingScan
{
    private const double Step = 1e-4;
    private const double Closeness = 1e-10;

    private readonly Trajectory _path;
    private readonly Vector3d[] _places;

    public MeetingScan(Trajectory path)
    {
        _path = path;
        _places = new Vector3d[(int)Math.Ceiling((path.EndTime - path.StartTime) / Step) + 1];
        for (int i = 0; i < _places.Length; i++)
        {
            _places[i] = path.PositionAt(TimeOf(i));
        }
    }

    /// <summary>Returns the windows, with ends to 0.1 ns. Windows shorter than a step of the scan are found only by chance.</summary>
    public List<(double From, double To)> Windows(Player runner)
    {
        var windows = new List<(double From, double To)>();
        bool inside = false;
        double from = 0;
        for (int i = 0; i < _places.Length; i++)
        {
            bool meets = Meets(runner, TimeOf(i), _places[i]);
            if (meets == inside)
            {
                continue;
            }

            double change = i == 0 ? TimeOf(0) : LabMath.Bisect(TimeOf(i - 1), TimeOf(i), time => Meets(runner, time) == meets, Closeness);
            inside = meets;
            if (meets)
            {
                from = change;
            }
            else
            {
                windows.Add((from, change));
            }
        }

        if (inside)
        {
            windows.Add((from, _path.EndTime));
        }

        return windows;
    }

    /// <summary>True if the runner reaches the ball at a time, by the literal definition.</summary>
    public bool Meets(Player runner, double time) => Meets(runner, time, _path.PositionAt(time));

    private static bool Meets(Player runner, double time, Vector3d ball)
    {
        double since = time - runner.Reaction;
        double s = Math.Max(0, since);
        Vector3d place = runner.Position + (Math.Min(time, runner.Reaction) * runner.Velocity);
        double ramp = runner.Speed / runner.Acceleration;
        double run = s <= ramp ? 0.5 * runner.Acceleration * s * s : runner.Speed * (s - (0.5 * ramp));
        return (ball - place).Horizontal.Length <= run + runner.Reach && ball.Y >= runner.MinimumHeight - 1e-9 && ball.Y <= runner.MaximumHeight + 1e-9;
    }

    private double TimeOf(int i) => Math.Min(_path.StartTime + (i * Step), _path.EndTime);
}
