namespace FootballPhysics.Benchmarks;

/// <summary>A stadium with all objects of a match: two goals with nets, boards, twenty-two players.</summary>
/// <param name="scene">Its air and ground.</param>
internal sealed class StadiumScenes(Scene scene)
{
    private const int Team = 11;

    /// <summary>Only goals, nets and boards.</summary>
    public Scene WithoutPlayers { get; } = Pitch.Stadium.On(scene);

    /// <summary>The stadium with standing players.</summary>
    public Scene WithStandingPlayers => With(i => default);

    /// <summary>The stadium with running players, each at a constant velocity.</summary>
    public Scene WithRunningPlayers => With(i => new Vector3d(3.0 * ((i % 5) - 2), 0, 3.0 * ((i % 3) - 1)));

    /// <summary>Returns the stadium with players that the game moves.</summary>
    public Scene WithBodies(out KinematicBodies players)
    {
        players = new KinematicBodies();
        for (int i = 0; i < 2 * Team; i++)
        {
            players.Add($"player {i}", Player(Vector3d.Zero)).MoveTo(Place(i), new Vector3d(3.0 * ((i % 5) - 2), 0, 3.0 * ((i % 3) - 1)), 0);
        }

        return WithoutPlayers with { Bodies = players };
    }

    /// <summary>Returns the position of a player: ten in lines across each half, one in goal.</summary>
    public static Vector3d Place(int player)
    {
        int of = player % Team;
        double side = player < Team ? -1 : 1;
        return of == 0 ? new Vector3d(0, 0, side * 51) : new Vector3d((15.0 * ((of - 1) % 4)) - 22, 0, side * (6 + (15.0 * ((of - 1) / 4))));
    }

    private Scene With(Func<int, Vector3d> velocity) => WithoutPlayers with
    {
        Obstacles =
        [
            .. WithoutPlayers.Obstacles,
            .. Enumerable.Range(0, 2 * Team).Select(i => new Obstacle { Name = $"player {i}", Shape = Player(Place(i)), Surface = SurfaceMaterial.Boot, Velocity = velocity(i) }),
        ],
    };

    private static CapsuleShape Player(in Vector3d at) => new(at + new Vector3d(0, 0.25, 0), at + new Vector3d(0, 1.6, 0), 0.25);
}
