using System.Globalization;
using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Netcode;

/// <summary>A kick at a tick. A match can be reproduced from its start state and its kicks.</summary>
public readonly struct KickInput : IFormattable, IMatchInput<KickInput>
{
    /// <summary>The maximum number of balls.</summary>
    internal const int MostBalls = 10_000;

    /// <summary>Creates a kick.</summary>
    /// <param name="tick">The tick of the kick: the ball is kicked at the start of this tick's step. 0 … 1e15.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <param name="player">The player who kicks, 0 or more; default 0. If two players kick at one tick, the kick of the higher number is applied last and wins
    /// on every machine.</param>
    /// <param name="ball">The index of the ball, below 10 000; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
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

    /// <summary>The tick of the kick: the ball is kicked at the start of this tick's step.</summary>
    public long Tick { get; }

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The spin in the world frame, in rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>The number of the player who kicks.</summary>
    public int Player { get; }

    /// <summary>The index of the ball; 0 if there is only one.</summary>
    public int Ball { get; }

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Returns the tick, velocity, spin and player as text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for at most three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"tick {Tick.ToString(culture)}: {Velocity.ToString(format, culture)} m/s, {Spin.ToString(format, culture)} rad/s, player {Player.ToString(culture)}";
    }

    bool IMatchInput<KickInput>.IsSame(in KickInput other) => Bits.Same(Velocity, other.Velocity) && Bits.Same(Spin, other.Spin);

    string IMatchInput<KickInput>.Noun => "kicks";

    int IMatchInput<KickInput>.Smallest => KickBytes.Smallest;

    void IMatchInput<KickInput>.Write(ref ByteWriter writer) => KickBytes.Write(in this, ref writer);

    KickInput IMatchInput<KickInput>.Read(long tick, int player, ref ByteReader reader) => KickBytes.Read(tick, player, ref reader);
}
