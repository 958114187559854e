using System.Globalization;
using FootballPhysics.Engines;
using FootballPhysics.Netcode;
using FootballPhysics.Shapes;

namespace FootballPhysics.Network;

/// <summary>A player of the game, who moves on the ground by the inputs of his machine.</summary>
public struct Player
{
    public Vector3d Place;
    public Vector3d Velocity;
}

/// <summary>The inputs of a team in one tick: the directions of its eleven players, and at most one kick. The network carries only these.</summary>
public sealed record TeamInput(byte[] Moves, KickInput? Kick)
{
    public static TeamInput Stand { get; } = new(Enumerable.Repeat(Match.StandStill, Match.TeamSize).ToArray(), null);

    public bool SameAs(TeamInput other) => Moves.AsSpan().SequenceEqual(other.Moves) && Kick.HasValue == other.Kick.HasValue
        && (!Kick.HasValue || (Kick.Value.Velocity == other.Kick!.Value.Velocity && Kick.Value.Spin == other.Kick.Value.Spin && Kick.Value.Player == other.Kick.Value.Player));
}

/// <summary>The game that both machines play. Equal inputs at equal ticks give bit-identical results, because it computes only with + − × ÷ √, as the library does.</summary>
public sealed class Match
{
    public const int TeamSize = 11;
    public const int Players = 2 * TeamSize;
    public const double Step = 1.0 / 60;

    /// <summary>The number of ticks kept in memory; larger than any rollback.</summary>
    public const int Kept = 256;

    /// <summary>The number of ticks between two transmissions of the ball. At these ticks, the ball's state is rounded to 24 bytes: see FixedStepRunner.QuantizationInterval.</summary>
    public const int WireTicks = 6;

    /// <summary>The distances of the touch lines and of the goal lines from the middle, m.</summary>
    public const double HalfWidth = 34;
    public const double HalfLength = 52.5;

    public const byte StandStill = (3 << 3) | 3;
    private const double Reach = 1.5;
    private const double Acceleration = 9;

    private readonly KinematicBodies _bodies = new();
    /// <summary>Keepers who let in more goals than the typical one.</summary>
    private static readonly Prediction.Player s_abilities = KeeperDive.Typical with { Reaction = 0.4, Speed = 2.5, Reach = 1.2 };
    private readonly KeeperDive[] _keepers;

    /// <summary>The events that the referee has not judged yet, in order of time.</summary>
    private readonly List<BallEvent> _events = [];
    private readonly Player[][] _players = [.. Enumerable.Range(0, Kept).Select(_ => new Player[Players])];
    private readonly TeamInput[][] _inputs = [.. Enumerable.Range(0, Kept).Select(_ => new[] { TeamInput.Stand, TeamInput.Stand })];

    public Match()
    {
        for (int i = 0; i < Players; i++)
        {
            _bodies.Add($"player {i}", IsKeeper(i) ? KeeperDive.Kind : BodyKind.Player);
            _players[0][i].Place = Home(i);
        }

        // A pitch with goals, in a hall whose four walls are behind its lines.
        Obstacle Wall(Vector3d point, Vector3d normal) => new() { Name = "wall", Shape = new PlaneShape(point, normal), Surface = SurfaceMaterial.Board };
        Scene still = Pitch.Standard.On() with
        {
            Obstacles =
            [
                Wall(new Vector3d(-38, 0, 0), new Vector3d(1, 0, 0)), Wall(new Vector3d(38, 0, 0), new Vector3d(-1, 0, 0)),
                Wall(new Vector3d(0, 0, -57), new Vector3d(0, 0, 1)), Wall(new Vector3d(0, 0, 57), new Vector3d(0, 0, -1)),
            ],
        };

        // The keepers predict the ball in a scene in which nothing moves.
        var ahead = new Simulator(still);
        _keepers = [.. Enumerable.Range(0, 2).Select(team => new KeeperDive(_bodies[team * TeamSize], GoalOf(still, team), ahead, Home(team * TeamSize), s_abilities))];
        Runner = new FixedStepRunner(new Simulator(still with { Bodies = _bodies }), Step) { QuantizationInterval = WireTicks, MoveBodies = PutPlayers };
        Referee = new Referee(this);
    }

    public FixedStepRunner Runner { get; }

    public Referee Referee { get; }

    public IReadOnlyList<KeeperDive> Keepers => _keepers;

    /// <summary>The next tick to play.</summary>
    public long Tick => Runner.Tick;

    public Player[] PlayersAt(long tick) => _players[tick % Kept];

    public TeamInput InputAt(long tick, int team) => _inputs[tick % Kept][team];

    /// <summary>Returns the guess for unknown inputs: the team repeats its moves of the tick before, without a kick.</summary>
    public TeamInput Guess(long tick, int team) => tick == 0 ? TeamInput.Stand : InputAt(tick - 1, team) with { Kick = null };

    /// <summary>Sets the inputs of a team in a tick.</summary>
    /// <returns>True if they differ from the inputs set before.</returns>
    public bool SetInput(long tick, int team, TeamInput input)
    {
        ref TeamInput slot = ref _inputs[tick % Kept][team];
        KickLog kicks = Runner.Kicks;
        bool changes = !slot.SameAs(input);
        slot = input;
        for (int i = kicks.FirstAt(tick); i < kicks.Count && kicks[i].Tick == tick; i++)
        {
            if (kicks[i].Player / TeamSize == team)
            {
                kicks.Remove(tick, kicks[i].Player);
                break;
            }
        }

        if (input.Kick is { } kick)
        {
            kicks.Add(in kick);
        }

        return changes;
    }

    /// <summary>True if a player is near enough to the ball to kick it.</summary>
    public bool CanKick(int player, in BallState ball, long tick) =>
        (ball.Position - PlayersAt(tick)[player].Place).Length < Reach;

    /// <summary>Plays one tick: first the players, then the ball.</summary>
    public void Advance()
    {
        MovePlayers(Tick);
        Runner.Step();
        Keep(Runner.Events);
    }

    /// <summary>Takes back the events after a time, before the ticks from that time on are played again.</summary>
    public void TakeBack(double time) => _events.RemoveAll(happened => happened.Time > time);

    /// <summary>Keeps the events of played ticks for the referee.</summary>
    public void Keep(EventBuffer events)
    {
        foreach (ref readonly BallEvent happened in events)
        {
            _events.Add(happened);
        }
    }

    /// <summary>Returns the events up to a time, and forgets them.</summary>
    public List<BallEvent> TakeEvents(double time)
    {
        List<BallEvent> taken = [.. _events.Where(happened => happened.Time <= time)];
        _events.RemoveAll(happened => happened.Time <= time);
        return taken;
    }

    /// <summary>Returns the team of the player whom the ball hit; null if it hit none.</summary>
    public int? TeamOf(in BallEvent happened)
    {
        string name = happened.Kind == BallEventKind.Impact ? Runner.Simulator.NameOf(happened.ColliderIndex) ?? "" : "";
        return name.StartsWith("player ", StringComparison.Ordinal) ? int.Parse(name[7..], CultureInfo.InvariantCulture) / TeamSize : null;
    }

    /// <summary>Moves the match to a tick, when a machine joins or rolls back. The keepers go back by themselves.</summary>
    public void Restore(long tick, ReadOnlySpan<Player> players, in BallState ball)
    {
        TakeBack(ball.Time);
        players.CopyTo(PlayersAt(tick));
        Runner.Restore(tick, in ball);
    }

    /// <summary>Computes the positions of the players after a tick from their positions before it and their inputs.</summary>
    public void MovePlayers(long tick)
    {
        Player[] from = PlayersAt(tick);
        Player[] to = PlayersAt(tick + 1);
        for (int i = 0; i < Players; i++)
        {
            Vector3d change = Wish(InputAt(tick, i / TeamSize).Moves[i % TeamSize]) - from[i].Velocity;
            double size = change.Length;
            Vector3d velocity = from[i].Velocity + (size > Acceleration * Step ? Acceleration * Step / size * change : change);
            to[i] = IsKeeper(i) ? from[i] : new Player { Place = from[i].Place + (Step * velocity), Velocity = velocity };
        }

        // The player who restarts stands behind the ball, outside the pitch or in his own half.
        KickLog inputs = Runner.Kicks;
        for (int i = inputs.FirstPlaceAt(tick + 1); i < inputs.PlaceCount && inputs.PlaceAt(i).Tick == tick + 1; i++)
        {
            PlaceInput place = inputs.PlaceAt(i);
            Vector3d away = place.Position.Horizontal;
            away = away.Length > 1 ? away.Normalized() : new Vector3d(0, 0, place.Player < TeamSize ? 1 : -1);
            to[place.Player] = new Player { Place = place.Position.Horizontal + (0.8 * away) };
        }
    }

    /// <summary>True for the two keepers, whom the library moves.</summary>
    public static bool IsKeeper(int player) => player % TeamSize == 0;

    /// <summary>Packs the move of a player into a byte: two components of the direction, −3 to 3, and a pace, 0 to 3.</summary>
    public static byte Move(Vector3d direction, int pace)
    {
        double size = Math.Max(Math.Abs(direction.X), Math.Abs(direction.Z));
        return size < 1e-9 ? StandStill : (byte)((pace << 6) | (((int)Math.Round(3 * direction.X / size) + 3) << 3) | ((int)Math.Round(3 * direction.Z / size) + 3));
    }

    /// <summary>Returns the base position of a player: 4-4-2, with the second team on the other half.</summary>
    public static Vector3d Home(int player)
    {
        int i = player % TeamSize;
        double side = player < TeamSize ? 1 : -1;
        (double x, double z) = i == 0 ? (0, 51.9) : i < 5 ? (-21 + (14 * (i - 1)), 34) : i < 9 ? (-21 + (14 * (i - 5)), 20) : (-6 + (12 * (i - 9)), 6);
        return new Vector3d(side * x, 0, side * z);
    }

    private static Vector3d Wish(byte move)
    {
        var direction = new Vector3d((move >> 3 & 7) - 3, 0, (move & 7) - 3);
        double size = direction.Length;
        return size > 0 ? 2.5 * (move >> 6) / size * direction : Vector3d.Zero;
    }

    /// <summary>Returns the goal that a team defends.</summary>
    private static Goal GoalOf(Scene scene, int team) => scene.Goals.Single(goal => (goal.Center.Z > 0) == (team == 0));

    /// <summary>Places the players at their positions of the tick, and moves the keepers, who follow the ball. The library calls it at every step, also at those of a rollback.</summary>
    private void PutPlayers(double time)
    {
        Player[] players = PlayersAt(Tick);
        for (int i = 0; i < Players; i++)
        {
            if (!IsKeeper(i))
            {
                _bodies[i].MoveTo(players[i].Place, players[i].Velocity, time);
            }
        }

        foreach (KeeperDive keeper in _keepers)
        {
            keeper.Follow(Runner);
        }
    }
}
