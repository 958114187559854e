using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>The part of the match that the referee decides: the score, the team that touched the ball last, and the next restart.</summary>
/// <param name="First">The goals of the first team.</param>
/// <param name="Second">The goals of the second team.</param>
/// <param name="Touched">The team that touched the ball last.</param>
/// <param name="Restart">The next restart; null while the ball is in play.</param>
public readonly record struct Ruling(int First, int Second, int Touched, PlaceInput? Restart)
{
    public string Score => FormattableString.Invariant($"{First}:{Second}");
}

/// <summary>
/// Counts goals and decides restarts: kick-offs, throw-ins, corners and goal kicks. It judges a tick once, when the tick is final. Both machines judge the same final ticks, so
/// they have the same score and the same restarts, and send neither. A restart follows a pause, so it usually belongs to a future tick; after a long delay, it is a late input.
/// </summary>
public sealed class Referee(Match match)
{
    /// <summary>The number of ticks from a goal, or from a ball out of play, to the restart.</summary>
    private const int Pause = 90;

    private readonly Ruling[] _rulings = new Ruling[Match.Kept];
    private readonly Dictionary<string, int> _counts = [];

    /// <summary>The next tick to judge. All earlier ticks are judged.</summary>
    public long Tick { get; private set; }

    /// <summary>The ruling after the last judged tick.</summary>
    public Ruling Now => At(Tick);

    /// <summary>The score, and the numbers of restarts since this machine joined.</summary>
    public string Summary => string.Join(", ", _counts.OrderBy(count => count.Key, StringComparer.Ordinal).Select(count => $"{count.Key} {count.Value}").Prepend($"score {Now.Score}"));

    /// <summary>Returns the ruling at the start of a judged tick.</summary>
    public Ruling At(long tick) => _rulings[tick % Match.Kept];

    /// <summary>Continues from a ruling at the start of a tick.</summary>
    public void Begin(long tick, in Ruling ruling)
    {
        Tick = tick;
        _rulings[tick % Match.Kept] = ruling;
    }

    /// <summary>Judges the next tick, which must be final.</summary>
    /// <param name="after">The ball after this tick.</param>
    /// <returns>The restart that follows from this tick; null if there is none.</returns>
    public PlaceInput? Judge(in BallState after)
    {
        Ruling ruling = Now;
        if (ruling.Restart is { } due && due.Tick <= Tick)
        {
            ruling = ruling with { Restart = null };
        }

        ruling = ruling with { Touched = Toucher(ruling.Touched) };
        PlaceInput? restart = null;
        foreach (BallEvent happened in match.TakeEvents(after.Time))
        {
            if (happened.Kind == BallEventKind.Goal && ruling.Restart is null)
            {
                // The first team plays towards negative z.
                int scorer = happened.Position.Z < 0 ? 0 : 1;
                ruling = scorer == 0 ? ruling with { First = ruling.First + 1 } : ruling with { Second = ruling.Second + 1 };
                restart = Restart("kick-offs", 1 - scorer, Match.TeamSize - 1, default);
                ruling = ruling with { Restart = restart };
            }
            else if (match.TeamOf(in happened) is { } team)
            {
                ruling = ruling with { Touched = team };
            }
        }

        if (ruling.Restart is null)
        {
            restart = Out(after.Position, ruling.Touched);
            ruling = ruling with { Restart = restart };
        }

        Tick++;
        _rulings[Tick % Match.Kept] = ruling;
        return restart;
    }

    /// <summary>Returns the team of the last kick in this tick.</summary>
    private int Toucher(int before)
    {
        KickLog inputs = match.Runner.Kicks;
        for (int i = inputs.FirstAt(Tick); i < inputs.Count && inputs[i].Tick == Tick; i++)
        {
            before = inputs[i].Player / Match.TeamSize;
        }

        return before;
    }

    /// <summary>Returns the restart for a ball out of play; null if it is in play.</summary>
    private PlaceInput? Out(Vector3d ball, int touched)
    {
        double radius = match.Runner.Simulator.Scene.Ball.Radius;
        double x = ball.X < 0 ? -1 : 1;
        double z = ball.Z < 0 ? -1 : 1;
        // The goal line is as deep as the posts, so a slow goal is a goal before the ball is out.
        if (Math.Abs(ball.Z) > Match.HalfLength + match.Runner.Simulator.Scene.Goals[0].PostRadius + radius)
        {
            // The team that defends this goal line takes a goal kick, unless it touched the ball last.
            int defends = z < 0 ? 1 : 0;
            return touched == defends
                ? Restart("corners", 1 - defends, 8, new Vector3d((Match.HalfWidth - 0.3) * x, 0, (Match.HalfLength - 0.3) * z))
                : Restart("goal kicks", defends, 1, new Vector3d(5.5 * x, 0, (Match.HalfLength - 5.5) * z));
        }

        if (Math.Abs(ball.X) > Match.HalfWidth + radius)
        {
            // The throw is part of the restart: it leaves the hands over the line.
            int throws = 1 - touched;
            double along = Math.Clamp(ball.Z, -Match.HalfLength + 1, Match.HalfLength - 1);
            return Restart("throw-ins", throws, 6, new Vector3d(Match.HalfWidth * x, 2.1, along), new Vector3d(-9 * x, 3, throws == 0 ? -4 : 4));
        }

        return null;
    }

    private PlaceInput Restart(string kind, int team, int player, Vector3d position, Vector3d velocity = default)
    {
        _counts[kind] = _counts.GetValueOrDefault(kind) + 1;
        return new PlaceInput(Tick + Pause, (team * Match.TeamSize) + player, 0, position, velocity);
    }
}
