using System.Globalization;

namespace FootballPhysics.Netcode;

/// <summary>A kick at a tick: all that a match must send, besides its start, to be played again.</summary>
public readonly struct KickInput : IFormattable
{
    /// <summary>So many balls there may be.</summary>
    internal const int MostBalls = 10_000;

    /// <summary>Makes a kick.</summary>
    /// <param name="tick">The tick whose step begins with the kick; 0 … 1e15.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <param name="player">Who kicks, 0 or more; default 0. Of two kicks at one tick the higher number is applied last, and so wins on every machine.</param>
    /// <param name="ball">Which of several balls is kicked, from 0, below 10 000; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public KickInput(long tick, Vector3d velocity, Vector3d spin, int player = 0, int ball = 0)
    {
        Check.Within("kick.ball", ball, 0, MostBalls - 1);
        Check.Within("kick.tick", tick, 0, Limits.Tick);
        Check.NotNegative("kick.player", player);
        Check.Size("kick.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("kick.spin", spin, Limits.Spin, "rad/s");
        Tick = tick;
        Velocity = velocity;
        Spin = spin;
        Player = player;
        Ball = ball;
    }

    /// <summary>The tick whose step begins with the kick.</summary>
    public long Tick { get; }

    /// <summary>Velocity, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Spin, rad/s, world frame.</summary>
    public Vector3d Spin { get; }

    /// <summary>Who kicks.</summary>
    public int Player { get; }

    /// <summary>Which of several balls is kicked; 0 where there is one.</summary>
    public int Ball { get; }

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>When, how, and by whom, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most, "R" for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"tick {Tick.ToString(culture)}: {Velocity.ToString(format, culture)} m/s, {Spin.ToString(format, culture)} rad/s, player {Player.ToString(culture)}";
    }

    /// <summary>True when this kick is applied before, with or after another one.</summary>
    internal int Order(long tick, int player, int ball)
    {
        int byTick = Tick.CompareTo(tick);
        int byPlayer = Player.CompareTo(player);
        return byTick != 0 ? byTick : byPlayer != 0 ? byPlayer : Ball.CompareTo(ball);
    }
}
