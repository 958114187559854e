using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Limits the length of a piece so that no force changes the motion by more than itself: explicit Euler's limit without
/// overshoot.</summary>
internal readonly struct StabilityLimit
{
    /// <summary>Maximum relative change of the motion by any force per piece.</summary>
    public const double LargestChange = 1.0;

    /// <summary>Up to this restitution every ball comes to rest, with any integrator and step length.</summary>
    private const double MostElastic = 0.95;

    /// <summary>Below this number of pieces the cheap bound is good enough.</summary>
    private const double FewPieces = 16;

    /// <summary>Below this airspeed, spin decays as at this speed, m/s.</summary>
    private const double SlowestAir = 3.2e-9;

    /// <summary>Its square, m²/s².</summary>
    private const double StillAir = SlowestAir * SlowestAir;

    /// <summary>The airspeed up to which <see cref="AirLaws.OrdinaryBound"/> holds for a whole step, m/s: a step that the limit allows at most doubles it.</summary>
    private const double UsualSpeed = 0.5 * AirLaws.OrdinarySpeed;

    /// <summary>The largest weight for which the same holds, m/s²: beyond it, the fall within a step may exceed that speed.</summary>
    private const double UsualWeight = 50;

    private readonly RateBound _bound;
    private readonly RateBound _usual; // the same up to UsualSpeed, for a coefficient that grows with speed
    private readonly double _upward;

    /// <summary>Up to this length, the fastest form of the laws never needs a division of the step, s.</summary>
    private readonly double _wholeUpTo;

    /// <summary>Minimum number of pieces of a hop, see <see cref="PiecesOfHop"/>.</summary>
    private readonly double _piecesOfHop;

    /// <summary>True if only the Magnus force acts, and the integrator increases a velocity that it turns.</summary>
    private readonly bool _spirals;

    /// <summary>Order of the integrator.</summary>
    private readonly int _order;

    private StabilityLimit(in RateBound bound, in RateBound usual, double upward, double wholeUpTo, double piecesOfHop, bool spirals, int order)
    {
        _order = order;
        _bound = bound;
        _usual = usual;
        _upward = upward;
        _wholeUpTo = wholeUpTo;
        _piecesOfHop = piecesOfHop;
        _spirals = spirals;
    }

    /// <summary>Bounds how fast the air and gravity can change the motion.</summary>
    public RateBound Bound => _bound;

    /// <summary>Creates the limit of a scene for an integrator.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="air">Its air.</param>
    /// <param name="wholeUpTo">Length up to which the fast form of the laws never needs a division, s; 0 if unknown.</param>
    /// <param name="upward">Upward acceleration, m/s².</param>
    /// <param name="order">Order of the integrator.</param>
    public static StabilityLimit Of(Scene scene, in SceneAir air, double wholeUpTo, double upward, int order)
    {
        RateBound ofAir = air.Bound;
        double weight = Math.Max(Math.Abs(upward), Scenes.Weight.Of(scene).Length);
        RateBound bound = WithFall(in ofAir, weight);

        // Use the largest restitution, which applies to the slowest and most oblique impacts. Without weight there are no hops.
        double pieces = -upward > ContactTolerances.LeastLoad ? PiecesOfHop(ContactMaterial.LargestOn(scene.Ground, scene.Ball)) : 0;

        // Without drag, a low-order integrator increases the ball's speed whenever the velocity turns.
        bool spirals = order < 4 && air.Lifts && !(air.Drags && ofAir.PerSpeed > 0);

        // In a wind field, a long step would miss changes of the wind: keep the shorter pieces of the full bound.
        RateBound usual = weight <= UsualWeight && !air.HasField ? WithFall(air.OrdinaryBound, weight) : bound;
        return new StabilityLimit(in bound, in usual, upward, wholeUpTo, pieces, spirals, order);
    }

    /// <summary>Returns the minimum number of pieces of a hop, 3e/(1 − e), for an integrator that increases the ball's speed in hops.</summary>
    /// <remarks>Each bounce is then lower than the previous one.</remarks>
    public static double PiecesOfHop(double restitution)
    {
        double e = Math.Min(restitution, MostElastic);
        return 3.0 * e / (1.0 - e);
    }

    /// <summary>Adds gravity to the bound of the air.</summary>
    /// <remarks>A ball that falls from rest reaches terminal velocity within about 1/√(P a).</remarks>
    public static RateBound WithFall(in RateBound ofAir, double weight) =>
        new(ofAir.PerSpeed, ofAir.PerSpin, ofAir.Constant + (Math.Sqrt(ofAir.PerSpeed) * Math.Sqrt(weight)));

    /// <summary>True if a step can be taken whole, by a fast, conservative test.</summary>
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

        // Allow half of the change for each of two parts of P |u| + Q |ω| + C: that of the airspeed |u|, and the rest. This avoids a square root.
        RateBound bound = speedSquared <= UsualSpeed * UsualSpeed ? _usual : _bound;
        double bySpeed = h * bound.PerSpeed;
        double bySpin = h * ((bound.PerSpin * spinRate) + bound.Constant);
        return !(bySpeed * bySpeed * Math.Max(speedSquared, StillAir) > 0.25 * LargestChange * LargestChange || bySpin > 0.5 * LargestChange);
    }

    /// <summary>Upper bound of the rate at which any force changes the motion, 1/s.</summary>
    /// <param name="speed">|u|, or an upper bound of it, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    public double RateAtMost(double speed, double spinRate) => (speed <= UsualSpeed ? _usual : _bound).At(speed, spinRate);

    /// <summary>Returns the longest of equal parts of a step in which no force overshoots, s.</summary>
    /// <param name="air">The air.</param>
    /// <param name="left">Length of the step, s.</param>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="branch">Branch of the drag law.</param>
    /// <param name="spirals">Set to true if the integrator would increase a velocity that the Magnus force only turns.</param>
    /// <param name="damping">Rate at which a surface damps the spin, 1/s.</param>
    /// <param name="gain">Maximum speed gain by surface friction within the step, m/s.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public double PartOf(ref SceneAir air, double left, double speed, double spinRate, DragBranch branch, ref bool spirals, double damping = 0, double gain = 0)
    {
        speed = Math.Max(speed, SlowestAir);
        double fastest = speed + gain;

        // The number of times that the forces could change the motion completely in this time.
        double pieces = left * (RateAtMost(fastest, spinRate) + damping);
        if (pieces > FewPieces && branch < DragBranch.AlongCriticalSpeed)
        {
            // This bound sums the worst case of each law. Twice the actual rates are sufficient, at the present speed and at the speed after
            // friction.
            double here = RateAt(ref air, speed, spinRate, branch);
            here = gain > 0 ? Math.Max(here, RateAt(ref air, fastest, spinRate, branch)) : here;
            double closer = left * ((2.0 * here) + _bound.Constant + damping);
            pieces = closer < pieces ? closer : pieces;
        }

        if (pieces <= LargestChange)
        {
            return left;
        }

        // Use equal parts: none exceeds the limit, and no sliver remains at the end.
        double part = left / Math.Ceiling(pieces / LargestChange);
        spirals = _spirals || SpiralsIn(ref air, part, speed, spinRate, branch);
        return part;
    }

    /// <summary>Returns how fast the laws change the motion at a speed and a spin, 1/s.</summary>
    private double RateAt(ref SceneAir air, double speed, double spinRate, DragBranch branch)
    {
        air.Factors(speed * speed, spinRate, speed * speed, branch, out double drag, out double lift, out double decay);
        return drag + Math.Abs(lift) + (spinRate > 0 ? Math.Min(decay / spinRate, (_bound.PerSpeed * speed) + (_bound.PerSpin * spinRate)) : 0);
    }

    /// <summary>True if a part of a divided step would increase a velocity that only turns.</summary>
    /// <remarks>
    /// The Magnus force turns it by Ω h and does no work; explicit Euler increases it by (Ω h)²/2 and RK2 by (Ω h)⁴/8, while drag removes D
    /// h.
    /// </remarks>
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

    /// <summary>Limits a piece near the ground so that bounces do not grow.</summary>
    /// <remarks>
    /// Explicit Euler returns from a hop faster by g h than it left, so a bounce below e g h/(1 − e) would grow. A step longer than (1 −
    /// e)/3e of a hop is divided; every bounce is then lower than the previous one.
    /// </remarks>
    /// <param name="h">Length of the step, s.</param>
    /// <param name="height">Height above contact, m.</param>
    /// <param name="climb">Vertical velocity, m/s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double WithinHop(double h, double height, double climb)
    {
        // From the height y with the upward speed v, a hop takes at most 2 √(2 g y + v²)/g.
        double up = (climb * climb) - (2.0 * _upward * Math.Max(0, height));
        double least = h * -_upward * _piecesOfHop;
        return least > 0 && least * least > 4.0 * up ? PartOfHop(h, least, up) : h;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private double PartOfHop(double h, double least, double up)
    {
        // A hop shorter than the shortest leaves the ball on the ground, so it needs no pieces.
        double hop = Math.Max(2.0 * Math.Sqrt(up), ContactTolerances.ShortestHop * -_upward);
        return least > hop ? h / Math.Ceiling(least / hop) : h;
    }
}

/// <summary>Limits how far a slip or a roll may change in one piece.</summary>
/// <remarks>
/// Its direction turns at the rate across/size, ever faster as the size falls. If a piece turns it by θ and changes it by the share x of
/// the rest, the error of RK4 is some hundredths of θ x⁴.
/// </remarks>
internal static class TurnLimit
{
    /// <summary>Maximum of θ x⁴. The reference cases of slides with sidespin and rolls in wind pass with it (WholeRun) and fail at a
    /// hundred times it.</summary>
    private const double LargestError = 1e-5;

    /// <summary>The standard step, s.</summary>
    private const double UsualStep = 0.02;

    /// <summary>Share of a turning slip or roll that a piece may change; the second value in long steps, the third if the direction hardly
    /// turns.</summary>
    private const double LeastShare = 0.125;
    private const double LeastShareOfLong = 0.4;
    private const double LargestShare = 0.75;

    /// <summary>Typical share of the squared rate across the direction; if the share is smaller, pieces may be longer.</summary>
    private const double OftenTurns = 0.01;

    /// <summary>If friction changes a slip or a roll by more than this multiple, its direction turns faster than the integrator can
    /// follow.</summary>
    private const double Stiff = 2.0;

    /// <summary>Maximum of the change across the direction times (λ h)⁴, m/s.</summary>
    private const double LargestOff = 2.5e-7;

    /// <summary>A turn per piece below this counts as zero, rad.</summary>
    private const double Straight = 1e-7;

    /// <summary>Limits a piece in which friction is strong compared with a slow slip or roll.</summary>
    /// <remarks>
    /// If the direction does not turn, it is locked. If it turns, the piece becomes as short as the integrator needs.
    /// </remarks>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    /// <param name="friction">The part of the rate due to friction, m/s².</param>
    /// <param name="locks">Whether the direction is locked.</param>
    public static double Follow(double h, in Vector3d direction, double size, in Vector3d rate, double friction, out bool locks)
    {
        locks = false;
        if (!IsStiff(h, size, friction))
        {
            return h;
        }

        double along = Vector3d.Dot(in rate, in direction);
        double across = Math.Sqrt(Math.Max(0, rate.LengthSquared - (along * along)));
        locks = across * h <= Straight * (size + Math.Max(0, along * h));
        return locks ? h : Stiff * size / friction;
    }

    /// <summary>True if the direction turns faster than the integrator can follow.</summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="friction">The part of its rate due to friction, m/s².</param>
    public static bool IsStiff(double h, double size, double friction) => h * friction > Stiff * size;

    /// <summary>True if a piece changes the slip or the roll little enough.</summary>
    /// <param name="size">Size at its start, m/s.</param>
    /// <param name="along">Change along its direction, m/s.</param>
    /// <param name="across">Change across it, m/s; not negative.</param>
    public static bool Allows(double size, double along, double across)
    {
        double left = size + along;
        double leftSquared = left * left;
        double changed = (along * along) + (across * across);

        // With θ = across/left and x² = changed/left², test θ x⁴ ≤ E, the largest error, without a division. As x ≥ θ, θ is at most the fifth root of E.
        return left > 0 && across * (changed * changed) <= LargestError * left * (leftSquared * leftSquared);
    }

    /// <summary>Shortens a piece in which the direction of a slip or a roll would turn too fast for the integrator.</summary>
    /// <remarks>
    /// The piece changes a share of the size; the share grows with the fourth root as the direction turns less.
    /// </remarks>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="step">Length of the whole step, s: a long one allows larger shares.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    /// <param name="turning">Rate at which the normal turns, 1/s: the rate turns with it.</param>
    public static double Shorten(double h, double step, in Vector3d direction, double size, in Vector3d rate, double turning)
    {
        // Split the rate into components along and across the direction; the component across turns the direction.
        double along = Vector3d.Dot(in rate, in direction);
        double acrossSquared = Math.Max(0, rate.LengthSquared - (along * along));
        double closing = Math.Sqrt(acrossSquared + (along < 0 ? along * along : 0));
        acrossSquared = Math.Max(acrossSquared, turning * turning * size * size);

        // The smaller the component across, the longer the piece: its length grows with the fourth root.
        double straight = acrossSquared < closing * closing * OftenTurns ? Math.Sqrt(Math.Sqrt(OftenTurns * closing * closing / Math.Max(acrossSquared, 1e-300))) : 1.0;
        double least = Math.Min(LeastShareOfLong, LeastShare * Math.Sqrt(Coarseness(step)));
        double share = Math.Min(LargestShare, least * straight);
        return closing * h > share * size ? share * size / closing : h;
    }

    /// <summary>Ends a piece before a slip or a roll that closes at its present rate ends.</summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    public static double Close(double h, in Vector3d direction, double size, in Vector3d rate)
    {
        double growth = Math.Max(0, Vector3d.Dot(in rate, in direction));
        double closing = Math.Sqrt(Math.Max(0, rate.LengthSquared - (growth * growth)));
        return closing * h > LargestShare * size ? LargestShare * size / closing : h;
    }

    /// <summary>Shortens a piece in which friction turns a slip or a roll back to the direction of the push faster than the integrator can
    /// follow.</summary>
    /// <remarks>
    /// The rate is λ = friction/size, however slowly the size changes. The relative error of RK4 is (λ h)⁴/120.
    /// </remarks>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="step">Length of the whole step, s: a long one allows a larger error.</param>
    /// <param name="direction">The direction.</param>
    /// <param name="size">Size of the slip or the roll, m/s.</param>
    /// <param name="rate">Its rate of change, m/s².</param>
    /// <param name="friction">The part of the rate due to friction, m/s².</param>
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

    /// <summary>Ratio of a step to the standard step; 1 for shorter steps.</summary>
    public static double Coarseness(double step) => Math.Max(1.0, step / UsualStep);
}
