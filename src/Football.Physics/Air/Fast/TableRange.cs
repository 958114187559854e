using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Where the tables of the laws hold at every stage of a step, however strong gravity and the air are.</summary>
internal readonly struct TableRange
{
    /// <summary>The fastest speed, m/s, at which the tables hold, with something in hand.</summary>
    public const double Fastest = 120;

    /// <summary>The largest spin parameter with which a step of a smooth law may begin. At 2 one plate of the empirical spin decay stands still.</summary>
    public const double LargestSpinParameter = 1.9;

    /// <summary>Drag and lift may each change the velocity by this share within a step.</summary>
    private const double LargestChange = 0.125;

    /// <summary>A fall of this many m/s is short.</summary>
    private const double ShortFall = 0.5;

    /// <summary>Drag leaves 7/8 of a speed, and gravity takes the rest of it down to the slowest.</summary>
    private const double Slower = 1.0 / (1.0 - LargestChange);

    private readonly double _slowest;  // m/s
    private readonly double _fastest;
    private readonly double _gravity;  // upward or downward, m/s²
    private readonly double _perSpeed; // bound for drag and lift, 1/m
    private readonly double _perSpin;

    // Up to this length, s, drag and lift are small at every speed and spin, and these are the bounds of |u|².
    private readonly double _short;
    private readonly double _leastSquare;
    private readonly double _mostSquare;

    /// <param name="scene">The scene.</param>
    /// <param name="forces">How fast drag and lift change the velocity.</param>
    /// <param name="fastestSpin">The fastest spin, rad/s, that the laws are asked about; without end where there is none.</param>
    /// <param name="slowest">The slowest speed, m/s, at which the tables hold.</param>
    /// <param name="fastest">The fastest speed, m/s, at which the tables hold.</param>
    public TableRange(Scene scene, in RateBound forces, double fastestSpin, double slowest, double fastest)
    {
        _slowest = slowest;
        _fastest = fastest;
        _gravity = Math.Abs(Weight.UpwardAcceleration(scene));
        _perSpeed = forces.PerSpeed;
        _perSpin = forces.PerSpin;

        // So short a step changes little at every speed and spin: two bounds of |u|² are enough for it.
        _short = Math.Min(LargestChange / (_perSpeed * fastest), LargestChange / (_perSpin * fastestSpin));
        _short = Math.Min(_short, ShortFall / Math.Max(1, _gravity));
        double fall = _short * _gravity;
        _leastSquare = Slower * (slowest + fall) * Slower * (slowest + fall);
        _mostSquare = fastest > fall ? (fastest - fall) * (fastest - fall) : 0;
    }

    /// <summary>True when the speed stays within the tables.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Holds(double speedSquared, double spinRate, double h)
    {
        if (h <= _short)
        {
            return speedSquared > _leastSquare && speedSquared < _mostSquare;
        }

        // A longer one by what gravity, drag and lift do at this speed and spin.
        double fall = h * _gravity;
        double least = Slower * (_slowest + fall);
        double most = _fastest - fall;
        double bySpeed = h * _perSpeed;
        return speedSquared > least * least && most > 0 && speedSquared < most * most
            && bySpeed * bySpeed * speedSquared < LargestChange * LargestChange && h * _perSpin * spinRate < LargestChange;
    }

    /// <summary>True when the spin parameter stays below √8 at every stage, and begins below <see cref="LargestSpinParameter"/>.</summary>
    /// <param name="speedSquared">|u|².</param>
    /// <param name="surfaceSquared">(r|ω|)².</param>
    /// <param name="h">Length of the step, s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool HoldsSpin(double speedSquared, double surfaceSquared, double h)
    {
        // (7/8 |u| − h g)² ≥ 7/8 (7/8 |u|)² − 7 (h g)²
        double fall = h * _gravity;
        return surfaceSquared + (56.0 * fall * fall) < LargestSpinParameter * LargestSpinParameter * speedSquared;
    }
}
