using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>How long a piece of motion on the ground may be.</summary>
internal readonly struct GroundLimit<TAir>
    where TAir : struct, IAir
{
    /// <summary>
    /// Towards the end of a slide or a roll, where the direction turns ever faster, a piece goes this share of the way for a step of
    /// 10 ms, and more, as the root, for a longer one.
    /// </summary>
    public const double Approach = 0.125;

    /// <summary>The largest such share.</summary>
    private const double LargestApproach = 0.4;

    private readonly Surroundings<TAir> _around;
    private readonly StabilityLimit _limit;
    private readonly double _perSpeed;
    private readonly double _perSpin;
    private readonly double _constant;
    private readonly double _fastestWind;

    public GroundLimit(Surroundings<TAir> around, in StabilityLimit limit)
    {
        _around = around;
        _limit = limit;
        _perSpeed = limit.Bound.PerSpeed;
        _perSpin = limit.Bound.PerSpin;
        _constant = limit.Bound.Constant;
        _fastestWind = around.Air.FastestWind;
    }

    /// <summary>A bound, 1/s, for how fast the air and the damping change the motion, without a root.</summary>
    /// <param name="from">The ball.</param>
    /// <param name="airSpeed">A bound of the speed relative to the air, m/s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double RateAtMost(in PlanarMotion from, out double airSpeed)
    {
        // |x| + |y| + |z| is at least the length of a vector.
        ref readonly Vector3d wind = ref _around.Wind;
        airSpeed = Math.Abs(from.VX - wind.X) + Math.Abs(wind.Y) + Math.Abs(from.VZ - wind.Z) + _fastestWind;
        return (_perSpeed * airSpeed) + (_perSpin * SpinAtMost(in from)) + _constant + _around.Ground.SpinDamping;
    }

    /// <summary>A bound of the spin, rad/s, without a root.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double SpinAtMost(in PlanarMotion from) => Math.Abs(from.WX) + Math.Abs(from.WY) + Math.Abs(from.WZ);

    /// <summary>The longest of equal parts of a step for which no force overshoots, s; 0 where they would be too many.</summary>
    /// <param name="left">Length of the step, s.</param>
    /// <param name="rateAtMost">From <see cref="RateAtMost"/>.</param>
    /// <param name="from">The ball.</param>
    /// <param name="branch">The branch of the drag law.</param>
    public double PartOf(double left, double rateAtMost, in PlanarMotion from, DragBranch branch) => left * rateAtMost <= StabilityLimit.LargestChange
        ? left
        : _limit.PartOf(ref _around.Air, left, (from.Velocity - _around.Wind).Length + _fastestWind, Math.Sqrt(from.SpinSquared), branch, _around.Ground.SpinDamping);

    /// <summary>Shortens a piece in which a vector would lose, or turn by, more than a share of its size.</summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="step">Length of the whole step, s.</param>
    /// <param name="direction">Direction of the vector.</param>
    /// <param name="size">Its size.</param>
    /// <param name="rate">Its rate of change.</param>
    public static double Shorten(double h, double step, in Vector3d direction, double size, in Vector3d rate)
    {
        double along = Vector3d.Dot(in rate, in direction);
        double acrossSquared = Math.Max(0, rate.LengthSquared - (along * along));
        double closing = Math.Sqrt(acrossSquared + (along < 0 ? along * along : 0));
        double share = step > 0.01 ? Math.Min(LargestApproach, Approach * Math.Sqrt(step * 100)) : Approach;
        return closing * h > share * size ? share * size / closing : h;
    }
}
