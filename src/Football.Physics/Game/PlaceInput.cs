using System.Globalization;
using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Netcode;

/// <summary>A restart at a tick: it places the ball for a kick-off, a throw-in, a corner or a dropped ball.</summary>
/// <remarks>
/// It belongs to the input log, as a <see cref="KickInput"/> does, so it may arrive late. At one tick, all places are applied first, then
/// <see cref="FixedStepRunner.MoveBodies"/> is called, and then the kicks are applied. A place removes no kick, and the clock continues.
/// </remarks>
public readonly struct PlaceInput : IFormattable, IMatchInput<PlaceInput>
{
    /// <summary>Creates a restart.</summary>
    /// <param name="tick">The tick: the ball is placed at the start of this tick's step. 0 … 1e15.</param>
    /// <param name="player">The player who restarts, 0 or more. If several players place one ball at one tick, the highest number wins on every machine.</param>
    /// <param name="ball">The index of the ball, below 10 000; 0 if there is only one.</param>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000. Default 0.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000. Default 0.</param>
    /// <param name="orientation">The orientation, of any length except zero. Default null: the identity.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public PlaceInput(long tick, int player, int ball, Vector3d position, Vector3d velocity = default, Vector3d spin = default, Quaterniond? orientation = null)
    {
        Quaterniond turned = orientation ?? Quaterniond.Identity;
        Check.Within("place.ball", ball, 0, KickInput.MostBalls - 1);
        Check.Within("place.tick", tick, 0, Limits.Tick);
        Check.NotNegative("place.player", player);
        Check.Place("place.position", position);
        Check.Size("place.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("place.spin", spin, Limits.Spin, "rad/s");
        Check.Rotation("place.orientation", turned);
        Tick = tick;
        Player = player;
        Ball = ball;
        Position = position;
        Velocity = velocity;
        Spin = spin;
        Orientation = turned;
    }

    /// <summary>The tick: the ball is placed at the start of this tick's step.</summary>
    public long Tick { get; }

    /// <summary>The number of the player who restarts.</summary>
    public int Player { get; }

    /// <summary>The index of the ball; 0 if there is only one.</summary>
    public int Ball { get; }

    /// <summary>The position of the centre, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The spin in the world frame, in rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>The orientation; it is normalised when the ball is placed.</summary>
    public Quaterniond Orientation { get; }

    /// <summary>Applies the restart to a ball: sets everything except its time.</summary>
    /// <remarks>A ball without velocity and spin is at rest, unless the slope or the wind moves it. A ball above the ground falls.</remarks>
    /// <param name="simulator">The scene of the ball.</param>
    /// <param name="state">The ball; unchanged if an exception is thrown.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    public void Apply(Simulator simulator, ref BallState state)
    {
        Check.Given(nameof(simulator), simulator);
        BallState.Launched(in state);
        state = simulator.Placed(Position, Velocity, Spin, Orientation, state.Time);
    }

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Returns the tick, ball, position, velocity, spin and player as text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for at most three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"tick {Tick.ToString(culture)}: ball {Ball.ToString(culture)} at {Position.ToString(format, culture)} m, {Velocity.ToString(format, culture)} m/s, {Spin.ToString(format, culture)} rad/s, player {Player.ToString(culture)}";
    }

    bool IMatchInput<PlaceInput>.IsSame(in PlaceInput other) =>
        Bits.Same(Position, other.Position) && Bits.Same(Velocity, other.Velocity) && Bits.Same(Spin, other.Spin) && Bits.Same(Orientation, other.Orientation);

    string IMatchInput<PlaceInput>.Noun => "restarts";

    int IMatchInput<PlaceInput>.Smallest => PlaceBytes.Smallest;

    void IMatchInput<PlaceInput>.Write(ref ByteWriter writer) => PlaceBytes.Write(in this, ref writer);

    PlaceInput IMatchInput<PlaceInput>.Read(long tick, int player, ref ByteReader reader) => PlaceBytes.Read(tick, player, ref reader);
}
