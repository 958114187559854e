using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>How long a piece of motion may be: so short that no force changes the motion by more than itself, explicit Euler's limit of no overshoot.</summary>
internal readonly struct StabilityLimit
{
    /// <summary>No force may change the motion in a piece by more than this share of itself.</summary>
    public const double LargestChange = 1.0;

    /// <summary>A ball that would be back on the ground sooner than this, s, stays down: so an impact takes time, however strong gravity is.</summary>
    public const double ShortestHop = 1e-6;

    /// <summary>Up to this restitution every ball comes to rest, whatever the method and its step.</summary>
    private const double MostElastic = 0.95;

    /// <summary>Below this many pieces the simple bound is good enough.</summary>
    private const double FewPieces = 16;

    /// <summary>In slower air spin decays as in this, m/s.</summary>
    private const double SlowestAir = 3.2e-9;

    /// <summary>Its square, m²/s².</summary>
    private const double StillAir = SlowestAir * SlowestAir;

    private readonly RateBound _bound;
    private readonly double _upward;

    /// <summary>Up to this length, s, no step that the fastest form of the laws covers must be divided.</summary>
    private readonly double _wholeUpTo;

    /// <summary>Into how many pieces a hop is divided at least, see <see cref="PiecesOfHop"/>.</summary>
    private readonly double _piecesOfHop;

    /// <summary>True when nothing but the Magnus force acts on a velocity that the method cannot turn without making it longer.</summary>
    private readonly bool _spirals;

    /// <summary>Order of the method.</summary>
    private readonly int _order;

    private StabilityLimit(in RateBound bound, double upward, double wholeUpTo, double piecesOfHop, bool spirals, int order)
    {
        _order = order;
        _bound = bound;
        _upward = upward;
        _wholeUpTo = wholeUpTo;
        _piecesOfHop = piecesOfHop;
        _spirals = spirals;
    }

    /// <summary>How fast the air and gravity can change the motion.</summary>
    public RateBound Bound => _bound;

    /// <summary>The limit of a scene for a method of an order.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="air">Its air.</param>
    /// <param name="wholeUpTo">Up to which length, s, no step that the fast form of the laws covers must be divided; 0 where that is not known.</param>
    /// <param name="upward">Upward acceleration, m/s².</param>
    /// <param name="order">Order of the method.</param>
    public static StabilityLimit Of(Scene scene, in SceneAir air, double wholeUpTo, double upward, int order)
    {
        RateBound ofAir = air.Bound;
        RateBound bound = WithFall(in ofAir, upward);

        // The restitution of the slowest and most oblique impacts decides; without weight there are no hops.
        double pieces = -upward > SurfaceForces.Least ? PiecesOfHop(ContactMaterial.LargestOn(scene.Ground, scene.Ball)) : 0;

        // Without drag nothing takes away what a method of low order adds to a velocity that it turns.
        bool spirals = order < 4 && air.Lifts && !(air.Drags && ofAir.PerSpeed > 0);
        return new StabilityLimit(in bound, upward, wholeUpTo, pieces, spirals, order);
    }

    /// <summary>Into how many pieces a hop is divided at least by a method that gains by hops, 3e/(1 − e): then every bounce is lower than the one before.</summary>
    public static double PiecesOfHop(double restitution)
    {
        double e = Math.Min(restitution, MostElastic);
        return 3.0 * e / (1.0 - e);
    }

    /// <summary>How fast the air and gravity can change the motion: a ball that falls from rest is soon as fast as drag lets it, 1/√(P a) is how soon.</summary>
    public static RateBound WithFall(in RateBound ofAir, double upward) =>
        new(ofAir.PerSpeed, ofAir.PerSpin, ofAir.Constant + (Math.Sqrt(ofAir.PerSpeed) * Math.Sqrt(Math.Abs(upward))));

    /// <summary>True when a step may be taken whole: a quick test that errs towards no.</summary>
    /// <param name="h">Length of the step, s.</param>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="covered">Whether the fastest form of the laws covers it.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool AllowsWhole(double h, double speedSquared, double spinRate, bool covered)
    {
        if (covered && h <= _wholeUpTo)
        {
            return true;
        }

        // Half of the change for each of the two parts of P |u| + Q |ω| + C, so that no root is needed.
        double bySpeed = h * _bound.PerSpeed;
        double bySpin = h * ((_bound.PerSpin * spinRate) + _bound.Constant);
        return !(bySpeed * bySpeed * Math.Max(speedSquared, StillAir) > 0.25 * LargestChange * LargestChange || bySpin > 0.5 * LargestChange);
    }

    /// <summary>A bound, 1/s, for how fast anything changes the motion.</summary>
    /// <param name="speed">|u|, or a bound of it, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    public double RateAtMost(double speed, double spinRate) => _bound.At(speed, spinRate);

    /// <summary>The longest of equal parts of a step for which no force overshoots.</summary>
    /// <param name="air">The air.</param>
    /// <param name="left">Length of the step, s.</param>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="branch">Branch of the drag law.</param>
    /// <param name="spirals">Set where the method would make a velocity longer in such parts, which the Magnus force only turns.</param>
    /// <param name="damping">Rate at which a surface damps the spin, 1/s.</param>
    /// <param name="gain">By how much the friction of a surface may make the ball faster in the step, m/s.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public double PartOf(ref SceneAir air, double left, double speed, double spinRate, DragBranch branch, ref bool spirals, double damping = 0, double gain = 0)
    {
        speed = Math.Max(speed, SlowestAir);
        double fastest = speed + gain;

        // How many times over the forces could change the motion in this time.
        double pieces = left * (RateAtMost(fastest, spinRate) + damping);
        if (pieces > FewPieces && branch < DragBranch.AlongCriticalSpeed)
        {
            // The bound adds what each law could do; twice what they do here is enough, and where friction may bring the ball, and in still air what they are about to do.
            double here = RateAt(ref air, speed, spinRate, branch);
            here = gain > 0 ? Math.Max(here, RateAt(ref air, fastest, spinRate, branch)) : here;
            double closer = left * ((2.0 * here) + _bound.Constant + damping);
            pieces = closer < pieces ? closer : pieces;
        }

        if (pieces <= LargestChange)
        {
            return left;
        }

        // Equal parts: none of them longer than the limit, and no sliver at the end.
        double part = left / Math.Ceiling(pieces / LargestChange);
        spirals = _spirals || SpiralsIn(ref air, part, speed, spinRate, branch);
        return part;
    }

    /// <summary>How fast the laws change the motion at a speed and a spin, 1/s.</summary>
    private double RateAt(ref SceneAir air, double speed, double spinRate, DragBranch branch)
    {
        air.Factors(speed * speed, spinRate, speed * speed, branch, out double drag, out double lift, out double decay);
        return drag + Math.Abs(lift) + (spinRate > 0 ? Math.Min(decay / spinRate, (_bound.PerSpeed * speed) + (_bound.PerSpin * spinRate)) : 0);
    }

    /// <summary>
    /// True when a part of a divided step would make a velocity longer. The Magnus force turns it by Ω h, and does no work; explicit Euler makes
    /// it longer by (Ω h)²/2, RK2 by (Ω h)⁴/8, of which drag takes D h away again.
    /// </summary>
    private bool SpiralsIn(ref SceneAir air, double h, double speed, double spinRate, DragBranch branch)
    {
        if (_order >= 4 || !air.Lifts || !(spinRate > 0) || branch >= DragBranch.AlongCriticalSpeed)
        {
            return false;
        }

        double speedSquared = speed * speed;
        air.Factors(speedSquared, spinRate, speedSquared, branch, out double drag, out double lift, out _);
        double turn = lift * h * lift * h;
        double longer = _order == 2 ? 0.125 * turn * turn : 0.5 * turn;
        return longer > drag * h;
    }

    /// <summary>
    /// Explicit Euler comes down from a hop faster by g h than it went up: with that a bounce of less than e g h/(1 − e) would grow. So a
    /// step is divided that is longer than (1 − e)/3e of a hop: then every bounce is lower than the one before, and the ball comes to rest.
    /// </summary>
    /// <param name="h">Length of the step, s.</param>
    /// <param name="height">Height above contact, m.</param>
    /// <param name="climb">Vertical velocity, m/s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double WithinHop(double h, double height, double climb)
    {
        // A hop up to the height that the energy is enough for takes 2 √(2 g y + v²)/g.
        double up = (climb * climb) - (2.0 * _upward * Math.Max(0, height));
        double least = h * -_upward * _piecesOfHop;
        return least > 0 && least * least > 4.0 * up ? PartOfHop(h, least, up) : h;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private double PartOfHop(double h, double least, double up)
    {
        // What is shorter than the shortest hop counts as staying down, and needs no pieces.
        double hop = Math.Max(2.0 * Math.Sqrt(up), ShortestHop * -_upward);
        return least > hop ? h / Math.Ceiling(least / hop) : h;
    }
}

/// <summary>
/// How far a slip or a roll may change in one piece. Its direction turns at the rate across/size, ever faster as the size falls: a piece in which it turns by θ,
/// and changes by the share x of what is left of it, is off by some hundredths of θ x⁴ (RK4).
/// </summary>
internal static class TurnLimit
{
    /// <summary>The largest turn θ, rad.</summary>
    private const double LargestTurn = 0.125;

    /// <summary>The largest θ x⁴: the reference cases of slides with sidespin and rolls in wind hold with it (WholeRun), and fail with a hundred times it.</summary>
    private const double LargestError = 1e-5;

    /// <summary>The usual step, s.</summary>
    private const double UsualStep = 0.02;

    /// <summary>A piece takes this share of a slip or a roll that turns; in long steps up to the second, where the direction hardly turns up to the third.</summary>
    private const double LeastShare = 0.125;
    private const double LeastShareOfLong = 0.4;
    private const double LargestShare = 0.75;

    /// <summary>So much of the square of the rate across the direction is usual: with less of it pieces are longer.</summary>
    private const double OftenTurns = 0.01;

    /// <summary>Friction that changes a slip or a roll by more than this share of it turns the direction faster than a method follows.</summary>
    private const double Stiff = 2.0;

    /// <summary>The largest change across the direction times (λ h)⁴, m/s.</summary>
    private const double LargestOff = 2.5e-7;

    /// <summary>A direction that turns by less than this in a piece, rad, stays as it is.</summary>
    private const double Straight = 1e-7;

    /// <summary>
    /// The length of a piece in which friction is strong for so slow a slip or roll: the direction is locked where it does not turn; where it does, the piece is as short
    /// as the method can follow.
    /// </summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    /// <param name="friction">By how much friction changes it, m/s².</param>
    /// <param name="locks">Whether the direction is locked.</param>
    public static double Follow(double h, in Vector3d direction, double size, in Vector3d rate, double friction, out bool locks)
    {
        locks = false;
        if (!(h * friction > Stiff * size))
        {
            return h;
        }

        double along = Vector3d.Dot(in rate, in direction);
        double across = Math.Sqrt(Math.Max(0, rate.LengthSquared - (along * along)));
        locks = across * h <= Straight * (size + Math.Max(0, along * h));
        return locks ? h : Stiff * size / friction;
    }

    /// <summary>True when a piece may be taken.</summary>
    /// <param name="size">Size at its start, m/s.</param>
    /// <param name="along">Change along its direction, m/s.</param>
    /// <param name="across">Change across it, m/s; not negative.</param>
    public static bool Allows(double size, double along, double across)
    {
        double left = size + along;
        double leftSquared = left * left;
        double changed = (along * along) + (across * across);

        // θ = across/left, x² = changed/left²: θ x⁴ ≤ E, without a division.
        return left > 0 && across <= LargestTurn * left && across * (changed * changed) <= LargestError * left * (leftSquared * leftSquared);
    }

    /// <summary>
    /// Shortens a piece in which the direction of a slip or a roll would turn too fast for a method to follow: it takes a share of the size, the more, the less
    /// the direction turns, as the fourth root.
    /// </summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="step">Length of the whole step, s: a long one takes larger shares.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    /// <param name="isFlat">Whether the surface is flat: on a curved one the rate itself changes on the way.</param>
    public static double Shorten(double h, double step, in Vector3d direction, double size, in Vector3d rate, bool isFlat)
    {
        // The rate along the direction, and across it, which turns it.
        double along = Vector3d.Dot(in rate, in direction);
        double acrossSquared = Math.Max(0, rate.LengthSquared - (along * along));
        double closing = Math.Sqrt(acrossSquared + (along < 0 ? along * along : 0));

        // The less of the rate is across, the longer the piece, as the fourth root.
        double straight = isFlat && acrossSquared < closing * closing * OftenTurns ? Math.Sqrt(Math.Sqrt(OftenTurns * closing * closing / Math.Max(acrossSquared, 1e-300))) : 1.0;
        double least = Math.Min(LeastShareOfLong, LeastShare * Math.Sqrt(Coarseness(step)));
        double share = Math.Min(LargestShare, least * straight);
        return closing * h > share * size ? share * size / closing : h;
    }

    /// <summary>
    /// Shortens a piece in which friction turns a slip or a roll back to the direction in which the push leads, faster than a method follows: at the rate λ = friction/size,
    /// however slowly the size changes. What turns in a piece is off by (λ h)⁴/120 of itself (RK4).
    /// </summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="step">Length of the whole step, s: a long one is off by more.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    /// <param name="friction">By how much friction changes it, m/s².</param>
    public static double ShortenStiff(double h, double step, in Vector3d direction, double size, in Vector3d rate, double friction)
    {
        double along = Vector3d.Dot(in rate, in direction);
        double stiff = friction * h / size;
        double squared = stiff * stiff;
        double off = Math.Sqrt(Math.Max(0, rate.LengthSquared - (along * along))) * h * squared * squared;
        double coarse = Coarseness(step) * Coarseness(step);
        double most = LargestOff * coarse * coarse;
        return off > most ? h * Math.Sqrt(Math.Sqrt(most / off)) : h;
    }

    /// <summary>How many times longer than usual a step is; 1 for shorter ones.</summary>
    public static double Coarseness(double step) => Math.Max(1.0, step / UsualStep);
}
