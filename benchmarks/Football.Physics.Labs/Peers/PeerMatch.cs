namespace FootballPhysics.Labs.Peers;

/// <summary>The match of one peer: a small pitch with two goals, two keepers and six players who run in curves.</summary>
internal sealed class PeerMatch
{
    public const double Step = 1.0 / 60;

    /// <summary>The distances of the goals and of the touch lines from the middle, m.</summary>
    public const double Length = 14;
    public const double Width = 10;

    private const int Players = 6;

    private readonly KinematicBodies _bodies = new();
    private readonly (Vector3d Middle, double Radius, double Rate)[] _curves;
    private readonly KeeperDive[] _keepers;

    /// <summary>Creates a match.</summary>
    /// <param name="random">The curves of the players; the same on both peers.</param>
    /// <param name="wire">The interval of rounding, ticks.</param>
    public PeerMatch(SeededRandom random, int wire)
    {
        Goal[] goals = [.. new[] { -1, 1 }.Select(side => new Goal { Center = new Vector3d(0, 0, side * Length), Facing = new Vector3d(0, 0, -side) })];
        Scene still = Scene.Default with { Goals = goals };
        var ahead = new Simulator(still);
        _curves = [.. Enumerable.Range(0, Players).Select(_ =>
            (new Vector3d(random.Uniform(-8, 8), 0, random.Uniform(-9, 9)), random.Uniform(0.3, 3), random.Uniform(-2, 2)))];
        foreach (int i in Enumerable.Range(0, Players))
        {
            _bodies.Add($"player {i}", i % 2 == 0 ? BodyKind.Player : BodyKind.Player with { Mass = double.PositiveInfinity });
        }

        _keepers = [.. goals.Select(goal => new KeeperDive(_bodies.Add("keeper", KeeperDive.Kind), goal, ahead, goal.Center + (0.6 * goal.Facing)))];
        Runner = new FixedStepRunner(new Simulator(still with { Bodies = _bodies }), Step) { QuantizationInterval = wire, MoveBodies = Move };
    }

    public FixedStepRunner Runner { get; }

    /// <summary>The number of dives.</summary>
    public int Dives => _keepers.Sum(keeper => keeper.Count);

    /// <summary>Moves the players, who depend on the time alone, and the keepers, who follow the ball.</summary>
    private void Move(double time)
    {
        for (int i = 0; i < Players; i++)
        {
            (Vector3d middle, double radius, double rate) = _curves[i];
            var away = new Vector3d(Math.Cos(rate * time), 0, Math.Sin(rate * time));
            _bodies[i].MoveTo(middle + (radius * away), radius * rate * new Vector3d(-away.Z, 0, away.X), time);
        }

        foreach (KeeperDive keeper in _keepers)
        {
            keeper.Follow(Runner);
        }
    }
}
