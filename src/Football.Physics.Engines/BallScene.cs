namespace FootballPhysics.Engines;

/// <summary>The scene of one ball in a game engine, put together from what stands in the engine's scene: goals, boards, walls, keepers, colliders.</summary>
/// <remarks>
/// A component of the engine adds what it is to the stage; <see cref="Compile"/> then makes the scene that is played, and the one that is looked ahead in, without what reacts to the ball.
/// Between, before and after each step the stage moves its keepers and its nets. When anything of it changes, the engine makes a new one and goes on in that.
/// </remarks>
public sealed class BallScene
{
    private readonly SolverSettings? _settings;
    private readonly List<Goal> _goals = [];
    private readonly List<Obstacle> _obstacles = [];
    private readonly List<(int Goal, Vector3d Feet, Player? Abilities)> _planned = [];
    private readonly List<KeeperDive> _keepers = [];
    private Simulator? _game;
    private Simulator? _ahead;
    private NetBulges? _bulges;

    /// <summary>Makes a stage with nothing on it.</summary>
    /// <param name="scene">Ball, air, forces and ground; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">How to integrate it; default <see cref="SolverSettings.Default"/>.</param>
    public BallScene(Scene? scene = null, SolverSettings? settings = null)
    {
        Scene = scene ?? Scene.Default;
        _settings = settings;
    }

    /// <summary>The scene without what stands on it: another one may be set before <see cref="Compile"/>.</summary>
    public Scene Scene { get; set; }

    /// <summary>Colliders of the engine that the ball hits. Default none.</summary>
    public IEngineColliders? Colliders { get; set; }

    /// <summary>The same colliders for looking ahead: others than <see cref="Colliders"/>, for a look ahead must push nothing. Default none.</summary>
    public IEngineColliders? PredictionColliders { get; set; }

    /// <summary>The scene that is played, compiled.</summary>
    /// <exception cref="InvalidOperationException">The stage is not compiled yet.</exception>
    public Simulator Game => _game ?? throw NotYet();

    /// <summary>The scene that is looked ahead in: without keepers, who would not stay where they are.</summary>
    /// <exception cref="InvalidOperationException">The stage is not compiled yet.</exception>
    public Simulator Ahead => _ahead ?? throw NotYet();

    /// <summary>The bulges of all nets, for drawing.</summary>
    /// <exception cref="InvalidOperationException">The stage is not compiled yet.</exception>
    public NetBulges Bulges => _bulges ?? throw NotYet();

    /// <summary>The goals, in the order in which they were added.</summary>
    public IReadOnlyList<Goal> Goals => _goals;

    /// <summary>The keepers, in the order in which they were added; none before <see cref="Compile"/>.</summary>
    public IReadOnlyList<KeeperDive> Keepers => _keepers;

    /// <summary>Adds a goal.</summary>
    /// <param name="goal">The goal.</param>
    /// <returns>Its index among the goals.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="goal"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The stage is compiled already.</exception>
    public int Add(Goal goal)
    {
        Check.Given(nameof(goal), goal);
        RequireOpen();
        _goals.Add(goal);
        return _goals.Count - 1;
    }

    /// <summary>The goal whose middle is nearest to a place.</summary>
    /// <param name="place">The place, m.</param>
    /// <returns>Its index among the goals, the lowest of those that are as near; −1 where there is none.</returns>
    public int NearestGoal(Vector3d place)
    {
        int nearest = _goals.Count - 1;
        for (int i = nearest - 1; i >= 0; i--)
        {
            nearest = Vector3d.Distance(_goals[i].Center, place) <= Vector3d.Distance(_goals[nearest].Center, place) ? i : nearest;
        }

        return nearest;
    }

    /// <summary>Adds a thing that stands still: a board, a player of a wall.</summary>
    /// <param name="obstacle">The thing.</param>
    /// <exception cref="ArgumentNullException"><paramref name="obstacle"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The stage is compiled already.</exception>
    public void Add(Obstacle obstacle)
    {
        Check.Given(nameof(obstacle), obstacle);
        RequireOpen();
        _obstacles.Add(obstacle);
    }

    /// <summary>Adds a player who stands still, as <see cref="BodyKind.Player"/> is.</summary>
    /// <param name="name">His name, for events.</param>
    /// <param name="feet">Where he stands, m.</param>
    /// <exception cref="ArgumentNullException"><paramref name="name"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The stage is compiled already.</exception>
    public void AddPlayer(string name, Vector3d feet)
    {
        Check.Given(nameof(name), name);
        var shape = (CapsuleShape)BodyKind.Player.Shape;
        Add(new Obstacle { Name = name, Shape = new CapsuleShape(shape.From + feet, shape.To + feet, shape.Radius), Surface = BodyKind.Player.Surface });
    }

    /// <summary>Adds a keeper who dives.</summary>
    /// <param name="goal">Index of the goal that he guards.</param>
    /// <param name="feet">Where he stands, m.</param>
    /// <param name="abilities">What he can; default null: <see cref="KeeperDive.Typical"/>.</param>
    /// <returns>His index among the keepers.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such goal.</exception>
    /// <exception cref="InvalidOperationException">The stage is compiled already.</exception>
    public int AddKeeper(int goal, Vector3d feet, Player? abilities = null)
    {
        Check.Index(nameof(goal), goal, _goals.Count);
        RequireOpen();
        _planned.Add((goal, feet, abilities));
        return _planned.Count - 1;
    }

    /// <summary>Checks all of it and compiles both scenes.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="InvalidOperationException">The stage is compiled already, or it has keepers and its scene has bodies.</exception>
    public void Compile()
    {
        RequireOpen();
        if (_planned.Count > 0 && Scene.Bodies is not null)
        {
            throw new InvalidOperationException("A BallScene cannot have both keepers and a scene with bodies. Remove the keepers or the bodies.");
        }

        Scene still = _goals.Count + _obstacles.Count == 0 ? Scene : Scene with
        {
            Goals = [.. Scene.Goals, .. _goals],
            Obstacles = [.. Scene.Obstacles, .. _obstacles],
        };
        _ahead = new Simulator(PredictionColliders is null ? still : still with { EngineColliders = PredictionColliders }, _settings);
        _game = _ahead;
        if (_planned.Count > 0 || Colliders is not null)
        {
            KinematicBodies? bodies = _planned.Count > 0 ? new KinematicBodies() : still.Bodies;
            foreach ((int goal, Vector3d feet, Player? abilities) in _planned)
            {
                _keepers.Add(new KeeperDive(bodies!.Add("keeper", KeeperDive.Kind), _goals[goal], _ahead, feet, abilities));
            }

            _game = new Simulator(still with { Bodies = bodies, EngineColliders = Colliders }, _settings);
        }

        _bulges = new NetBulges(_game);
    }

    /// <summary>Gives the ball as it is in <see cref="Ahead"/>, to be looked ahead from: one that lies on a keeper, or on an engine's collider, is in the air there.</summary>
    /// <param name="ball">The ball in <see cref="Game"/>.</param>
    public BallState PredictionState(in BallState ball)
    {
        bool isElsewhere = !ReferenceEquals(_game, _ahead) && ball.Carrier >= PartsBefore(Game.World, Game.Scene.Goals.Count);
        return isElsewhere ? Ahead.Continue(Game, in ball) : ball;
    }

    /// <summary>Moves the keepers to where they are when a step begins. Allocates nothing.</summary>
    /// <param name="ball">The ball before the step.</param>
    public void BeforeStep(in BallState ball)
    {
        if (_keepers.Count > 0)
        {
            BallState seen = PredictionState(in ball);
            foreach (KeeperDive keeper in _keepers)
            {
                keeper.Follow(in seen);
            }
        }
    }

    /// <summary>Lets the nets bulge as they do after a step. Allocates nothing.</summary>
    /// <param name="ball">The ball after the step.</param>
    public void AfterStep(in BallState ball) => Bulges.Follow(in ball);

    /// <summary>Tells which of the goals an event belongs to: a goal, one of its nets, posts or bar.</summary>
    /// <param name="happened">An event of <see cref="Game"/>.</param>
    /// <returns>Its index; −1 for none that was added here.</returns>
    public int GoalOf(in BallEvent happened)
    {
        World world = Game.World;
        int first = Scene.Goals.Count;
        int thing = happened.ColliderIndex;
        for (int i = 0; i < _goals.Count; i++)
        {
            int post = PartsBefore(world, first + i);
            int net = FirstNet(first + i);
            if (thing == world.ThingOfGoal(first + i) || (thing >= post && thing < post + 3) || (thing >= world.ThingOfNet(net) && thing < world.ThingOfNet(net + _goals[i].NetCount)))
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>The index of a goal's first net among <see cref="Bulges"/>: back, roof, left, right.</summary>
    /// <param name="goal">Index of the goal.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such goal.</exception>
    public int FirstNetOf(int goal)
    {
        Check.Index(nameof(goal), goal, _goals.Count);
        return FirstNet(Scene.Goals.Count + goal);
    }

    /// <summary>The engine's collider that an event tells of; null where it is none.</summary>
    /// <param name="happened">An event of the last step of <see cref="Game"/>.</param>
    public EngineCollider? ColliderOf(in BallEvent happened)
    {
        World world = Game.World;
        return world.Engine is { } engine && happened.ColliderIndex >= EngineCollider.FirstNumber ? engine.Of(happened.ColliderIndex, happened.Position, happened.Time) : null;
    }

    private static InvalidOperationException NotYet() => new("stage: it is not compiled yet; call Compile first.");

    /// <summary>Index among the things of the first post of a goal of the scene: after the ground and the obstacles.</summary>
    private int PartsBefore(World world, int goal) => world.FirstCollider + (world.Ground is null ? 0 : 1) + Game.Scene.Obstacles.Count + (3 * goal);

    private int FirstNet(int goal)
    {
        int net = Scene.Nets.Count;
        for (int i = 0; i < goal; i++)
        {
            net += Game.Scene.Goals[i].NetCount;
        }

        return net;
    }

    private void RequireOpen()
    {
        if (_game is not null)
        {
            throw new InvalidOperationException("The BallScene is already compiled. Create a new one to change it.");
        }
    }
}
