using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The scene of one ball in a game engine, built from the objects in the engine's scene.</summary>
/// <remarks>
/// Components of the engine add goals, boards, walls, keepers and colliders. <see cref="Compile"/> then creates the scene for the game, and the scene for
/// predictions, which has no objects that react to the ball. Call <see cref="BeforeStep(FixedStepRunner)"/> in <see cref="FixedStepRunner.MoveBodies"/> to move
/// the keepers, and <see cref="AfterStep"/> after each step to move the nets. To change the objects, create a new ball scene and continue in it.
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

    /// <summary>Creates a ball scene without added objects.</summary>
    /// <param name="scene">The ball, air, forces and ground; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">The solver settings; default <see cref="SolverSettings.Default"/>.</param>
    public BallScene(Scene? scene = null, SolverSettings? settings = null)
    {
        Scene = scene ?? Scene.Default;
        _settings = settings;
    }

    /// <summary>Gets or sets the scene without the added objects; set it before <see cref="Compile"/>.</summary>
    public Scene Scene { get; set; }

    /// <summary>Gets or sets the engine's colliders that the ball hits. Default none.</summary>
    public IEngineColliders? Colliders { get; set; }

    /// <summary>Gets or sets the engine's colliders for predictions. Default none.</summary>
    /// <remarks>Use a different object from <see cref="Colliders"/>, because a prediction must not push anything.</remarks>
    public IEngineColliders? PredictionColliders { get; set; }

    /// <summary>The compiled scene in which the ball is played.</summary>
    /// <exception cref="InvalidOperationException">The ball scene is not compiled yet.</exception>
    public Simulator Game => _game ?? throw NotYet();

    /// <summary>The compiled scene for predictions, without keepers, because they react to the ball.</summary>
    /// <exception cref="InvalidOperationException">The ball scene is not compiled yet.</exception>
    public Simulator Ahead => _ahead ?? throw NotYet();

    /// <summary>The bulges of all nets, for drawing.</summary>
    /// <exception cref="InvalidOperationException">The ball scene is not compiled yet.</exception>
    public NetBulges Bulges => _bulges ?? throw NotYet();

    /// <summary>The goals, in the order in which they were added.</summary>
    public IReadOnlyList<Goal> Goals => _goals;

    /// <summary>The keepers, in the order in which they were added; empty before <see cref="Compile"/>.</summary>
    public IReadOnlyList<KeeperDive> Keepers => _keepers;

    /// <summary>Adds a goal.</summary>
    /// <param name="goal">The goal.</param>
    /// <returns>The index of the goal.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="goal"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The ball scene is already compiled.</exception>
    public int Add(Goal goal)
    {
        Check.Given(nameof(goal), goal);
        RequireOpen();
        _goals.Add(goal);
        return _goals.Count - 1;
    }

    /// <summary>Returns the index of the goal whose centre is nearest to a position.</summary>
    /// <param name="place">The position, in m.</param>
    /// <returns>The index of the goal, the lowest of several at the same distance; −1 if there are none.</returns>
    public int NearestGoal(Vector3d place)
    {
        int nearest = _goals.Count - 1;
        for (int i = nearest - 1; i >= 0; i--)
        {
            nearest = Vector3d.Distance(_goals[i].Center, place) <= Vector3d.Distance(_goals[nearest].Center, place) ? i : nearest;
        }

        return nearest;
    }

    /// <summary>Adds a static obstacle, such as a board or a player in a wall.</summary>
    /// <param name="obstacle">The obstacle.</param>
    /// <exception cref="ArgumentNullException"><paramref name="obstacle"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The ball scene is already compiled.</exception>
    public void Add(Obstacle obstacle)
    {
        Check.Given(nameof(obstacle), obstacle);
        RequireOpen();
        _obstacles.Add(obstacle);
    }

    /// <summary>Adds a player who stands still, with the shape of <see cref="BodyKind.Player"/>.</summary>
    /// <param name="name">The name of the player, for events.</param>
    /// <param name="feet">The position of his feet, in m.</param>
    /// <exception cref="ArgumentNullException"><paramref name="name"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The ball scene is already compiled.</exception>
    public void AddPlayer(string name, Vector3d feet)
    {
        Check.Given(nameof(name), name);
        var shape = (CapsuleShape)BodyKind.Player.Shape;
        Add(new Obstacle { Name = name, Shape = new CapsuleShape(shape.From + feet, shape.To + feet, shape.Radius), Surface = BodyKind.Player.Surface });
    }

    /// <summary>Adds a diving goalkeeper.</summary>
    /// <param name="goal">The index of his goal.</param>
    /// <param name="feet">The position of his feet, in m.</param>
    /// <param name="abilities">His abilities; default null: <see cref="KeeperDive.Typical"/>.</param>
    /// <returns>The index of the keeper.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such goal.</exception>
    /// <exception cref="InvalidOperationException">The ball scene is already compiled.</exception>
    public int AddKeeper(int goal, Vector3d feet, Player? abilities = null)
    {
        Check.Index(nameof(goal), goal, _goals.Count);
        RequireOpen();
        _planned.Add((goal, feet, abilities));
        return _planned.Count - 1;
    }

    /// <summary>Validates the ball scene, and compiles the scenes for the game and for predictions.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="InvalidOperationException">The ball scene is already compiled, or it has keepers and its scene has bodies.</exception>
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

    /// <summary>Converts the state of the ball from <see cref="Game"/> to <see cref="Ahead"/>, as the start of a prediction.</summary>
    /// <remarks>In the converted state, a ball that rests on a keeper or an engine's collider is in the air.</remarks>
    /// <param name="ball">The state of the ball in <see cref="Game"/>.</param>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public BallState PredictionState(in BallState ball)
    {
        BallState.Launched(in ball);
        bool isElsewhere = !ReferenceEquals(_game, _ahead) && ball.Carrier >= PartsBefore(Game.World, Game.Scene.Goals.Count);
        return isElsewhere ? Ahead.Continue(Game, in ball) : ball;
    }

    /// <summary>Moves the keepers to their positions at the start of a step. A <see cref="PlaceInput"/> of this tick sends them back to their goals.</summary>
    /// <remarks>Call it in <see cref="FixedStepRunner.MoveBodies"/>: a <see cref="Rollback"/> then also moves the keepers in the steps that it resimulates.</remarks>
    /// <param name="runner">The runner of the ball.</param>
    /// <exception cref="ArgumentNullException"><paramref name="runner"/> is null.</exception>
    public void BeforeStep(FixedStepRunner runner)
    {
        Check.Given(nameof(runner), runner);
        Follow(runner.State, KeeperDive.IsPlaced(runner));
    }

    /// <summary>Moves the keepers to their positions at the start of a step.</summary>
    /// <remarks>With a <see cref="Rollback"/>, call it in <see cref="FixedStepRunner.MoveBodies"/>.</remarks>
    /// <param name="ball">The ball before the step.</param>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public void BeforeStep(in BallState ball) => Follow(in ball, isPlaced: false);

    /// <summary>Updates the bulges of the nets after a step. Does not allocate.</summary>
    /// <param name="ball">The ball after the step.</param>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public void AfterStep(in BallState ball) => Bulges.Follow(in ball);

    /// <summary>Returns the goal that an event belongs to: its opening, a net, a post or the bar.</summary>
    /// <param name="happened">An event of <see cref="Game"/>.</param>
    /// <returns>The index of the goal; −1 if no goal of this ball scene is involved.</returns>
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

    /// <summary>Returns the index of a goal's first net in <see cref="Bulges"/>; the order is back, roof, left, right.</summary>
    /// <param name="goal">The index of the goal.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such goal.</exception>
    public int FirstNetOf(int goal)
    {
        Check.Index(nameof(goal), goal, _goals.Count);
        return FirstNet(Scene.Goals.Count + goal);
    }

    /// <summary>Returns the engine's collider that an event reports; null if it is not one.</summary>
    /// <param name="happened">An event of the last step of <see cref="Game"/>.</param>
    public EngineCollider? ColliderOf(in BallEvent happened)
    {
        World world = Game.World;
        return world.Engine is { } engine && happened.ColliderIndex >= EngineCollider.FirstNumber ? engine.Of(happened.ColliderIndex, happened.Position, happened.Time) : null;
    }

    private void Follow(in BallState ball, bool isPlaced)
    {
        BallState.Launched(in ball);
        if (_keepers.Count > 0)
        {
            BallState seen = PredictionState(in ball);
            foreach (KeeperDive keeper in _keepers)
            {
                keeper.Follow(in seen, isPlaced);
            }
        }
    }

    private static InvalidOperationException NotYet() => new("stage: it is not compiled yet; call Compile first.");

    /// <summary>Returns the collider index of the first post of a goal: after the ground and the obstacles.</summary>
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
