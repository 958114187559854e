using System.Runtime.CompilerServices;
using FootballPhysics.Scenes;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>A fitted law evaluated from tables of its functions, with absent forces and constant coefficients, valid where <see cref="Covers"/> returns true.</summary>
/// <remarks>
/// It costs two table indices, a few cubics and <see cref="ITableLaw.Combine"/>. The functions define the law; the tests compare tables and functions over the
/// entire domain.
/// </remarks>
/// <typeparam name="TLaw">The type of the law.</typeparam>
internal struct TableAir<TLaw> : IFlightAir
    where TLaw : struct, ITableLaw
{
    /// <summary>The |u|, in m/s, below which there is no drag and no lift, and the spin decay stays constant.</summary>
    private const double StillAir = 1e-9;

    /// <summary>Added to (r|ω|)², in m²/s², so that a ball without spin stays within the tables.</summary>
    /// <remarks>The S² of such a ball is then without spin for <see cref="LawTables"/> at the lowest speed, and still within the tables at the highest.</remarks>
    private const double NoSpin = 1e-23;

    /// <summary>The lowest speed of a single evaluation by tables, in m/s: where the tables of the published laws begin.</summary>
    private const double SlowestPoint = 0.015625;

    /// <summary>The margin by which a step must start above the lowest speed of the tables.</summary>
    private const double AboveSlowest = 1.5;

    /// <summary>The share of the highest speed of the tables up to which they are used.</summary>
    private const double BelowFastest = 0.9375;

    private readonly ConstantParts _constant;
    private TLaw _law;
    private readonly FactorTable _speeds;
    private readonly FactorTable _spins;
    private readonly TableRange _range;
    private readonly RateBound _decay;
    private readonly double _radius;
    private readonly double _radiusSquared;
    private readonly double _slowestSquared; // |u|² within the tables
    private readonly double _fastestSquared;

    public bool Acts { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    public bool HasField => false;

    public bool HasSide => false;

    public readonly bool Tilts => false;

    public readonly Vector3d Sideways => Vector3d.Zero;

    public bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => _law.Jumps; }

    /// <summary>The highest spin that is covered at any speed, in rad/s.</summary>
    private double FastestSpin => TableRange.FastestSurface / _radius;

    /// <param name="scene">The scene.</param>
    /// <param name="others">The bound on the change of velocity by air forces other than drag and lift.</param>
    public TableAir(Scene scene, in RateBound others = default)
    {
        _law = default;
        _law.Prepare(scene);
        _constant.Prepare(scene);
        LawTables tables = _law.Tables;
        _speeds = tables.Speeds;
        _spins = tables.Spins;
        _radius = scene.Ball.Radius;
        _radiusSquared = _radius * _radius;
        double slowest = Math.Max(SlowestPoint, tables.Slowest / _law.SpeedScale);
        double fastest = Math.Min(TableRange.Fastest, BelowFastest * tables.Fastest / _law.SpeedScale);
        _slowestSquared = slowest * slowest;
        _fastestSquared = fastest * fastest;
        _decay = SceneLaws.SpinDecay(scene).Bound;
        _range = new TableRange(scene, SceneLaws.DragBound(scene, fastest) + SceneLaws.Magnus(scene).Bound + others, FastestSpin, AboveSlowest * slowest, fastest);
    }

    /// <inheritdoc cref="IFlightAir.WholeUpTo"/>
    /// <remarks>Where the tables hold, drag and lift change the motion by a quarter at most. The spin decay and the fall may change it by another quarter.</remarks>
    public double WholeUpTo(in RateBound bound) => 0.25 / ((_decay.PerSpeed * TableRange.Fastest) + (_decay.PerSpin * FastestSpin) + bound.Constant);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h) =>
        _range.Holds(speedSquared, spinRate, _radiusSquared * spinRate * spinRate, h);

    /// <summary>Returns true if the tables hold at a single point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool HoldsAt(double speedSquared, double spinSquared)
    {
        const double Largest = TableRange.LargestSpinParameter * TableRange.LargestSpinParameter;
        return speedSquared > _slowestSquared && speedSquared < _fastestSquared && _radiusSquared * spinSquared < Largest * speedSquared;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay) =>
        Factors(speedSquared, spinRate, acrossSquared, region, out drag, out lift, out decay, out _);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share)
    {
        // A stage may overshoot zero spin: in that case, use S = 0.
        double spin = spinRate > 0 ? spinRate : 0;
        double surfaceSquared = _radiusSquared * (spin * spin);
        double ofSpin;
        if (_law.NeedsSpinAcross)
        {
            // S is the spin parameter, u the velocity through the air, r the radius.
            // S² = (r|ω|)² |ω̂ × u|²/|u|⁴
            double perSpeedSquared = 1.0 / speedSquared;
            ofSpin = ((surfaceSquared * acrossSquared) + (NoSpin * speedSquared)) * (perSpeedSquared * perSpeedSquared);
        }
        else
        {
            // 1/S² = |u|²/(r|ω|)², arranged so that the division does not wait for the speed.
            ofSpin = speedSquared * (1.0 / (surfaceSquared + NoSpin));
        }

        _speeds.Evaluate(speedSquared * (_law.SpeedScale * _law.SpeedScale), out LawFactors bySpeed);
        _spins.Evaluate(ofSpin, out LawFactors bySpin);
        share = bySpeed.Fourth;
        double speed = Math.Sqrt(speedSquared);
        _law.Combine(region, in bySpeed, in bySpin, speed, spinRate, out drag, out lift, out decay);
        if (_constant.Any)
        {
            _constant.Replace(speed, spinRate, ref drag, ref lift, ref decay);
        }
    }

    /// <summary>Computes the factors at any point: from the tables in their range, otherwise from the functions.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void FactorsAnywhere(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        if (HoldsAt(speedSquared, spinRate * spinRate))
        {
            Factors(speedSquared, spinRate, acrossSquared, region, out drag, out lift, out decay);
        }
        else
        {
            // Use temporaries, because a variable passed by address is stored in memory and not in a register.
            ByFunctions(speedSquared, spinRate, acrossSquared, region, out double ofDrag, out double ofLift, out double ofDecay);
            drag = ofDrag;
            lift = ofLift;
            decay = ofDecay;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        bool spins = spinSquared > AirLaws.NoSpin;
        if (_law.NeedsSpinAcross && spins && HoldsAt(speedSquared, spinSquared))
        {
            // Lift and decay are proportional to the spin, and S² = r²|ω × u|²/|u|⁴: neither a division by the spin nor a square root is needed.
            Factors(speedSquared, 1.0, crossSquared, region, out drag, out lift, out decay);
            return true;
        }

        // |ω̂ × u|² = |ω × u|²/|ω|², arranged so that the division does not wait for the root.
        double perSquared = spins ? 1.0 / spinSquared : 0;
        double rate = spins ? Math.Sqrt(spinSquared) : 0;
        FactorsAnywhere(speedSquared, rate, perSquared * crossSquared, region, out drag, out lift, out decay);
        double perRate = spins ? perSquared * rate : 1.0;
        lift *= perRate;
        decay *= perRate;
        return spins;
    }

    /// <summary>Computes the factors by the functions of the law, at any point.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void ByFunctions(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        // At zero airspeed, there is no force, and the spin decays as at the lowest speed in the table.
        double speed = Math.Sqrt(speedSquared);
        bool moves = speed > StillAir;
        speed = moves ? speed : StillAir;
        double across = _law.NeedsSpinAcross && moves ? Math.Sqrt(acrossSquared) / speed : 1.0;

        // A stage may overshoot zero spin: the lift is then zero, but the spin continues to decay.
        double spin = spinRate > 0 ? spinRate : 0;
        _law.OfSpeed(_law.SpeedScale * speed, out LawFactors bySpeed);
        _law.OfSpin(_radius * spin * across / speed, out LawFactors bySpin);
        _law.Combine(region, in bySpeed, in bySpin, speed, spinRate, out drag, out lift, out decay);
        if (_constant.Any)
        {
            _constant.Replace(speed, spinRate, ref drag, ref lift, ref decay);
        }

        drag = moves ? drag : 0;
        lift = moves && spinRate > 0 ? lift : 0;
    }

    public Vector3d WindAt(double time, double x, double y, double z) => Vector3d.Zero;

    public void Begin(in BallState start, out SeamAxes seams) => seams = default;

    public void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned) => turned = default;

    public void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end)
    {
        middle = default;
        end = default;
    }

    public Vector3d Side(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance) => Vector3d.Zero;
}

/// <summary>The states and step lengths for which the tables hold at every stage, for any gravity and air.</summary>
internal readonly struct TableRange
{
    /// <summary>The highest speed at which the tables hold, with a margin, in m/s.</summary>
    public const double Fastest = 120;

    /// <summary>The highest r|ω| at which the tables are used, in m/s.</summary>
    public const double FastestSurface = 228;

    /// <summary>The largest spin parameter at the start of a step.</summary>
    public const double LargestSpinParameter = 20;

    /// <summary>The share of the velocity that drag and lift together may change within a step.</summary>
    private const double LargestChange = 0.25;

    /// <summary>The change of speed by gravity in a short step, in m/s.</summary>
    private const double ShortFall = 0.5;

    /// <summary>Drag and lift leave at least 0.74 of a speed in any stage; gravity may reduce the rest to the lowest speed.</summary>
    private const double Slower = 1.0 / 0.74;

    /// <summary>The same for a short step, whose margin above the lowest speed is larger.</summary>
    private const double SlowerInShort = 8.0 / 7.0;

    private readonly double _slowest;  // m/s
    private readonly double _fastest;
    private readonly double _gravity;  // upward or downward, m/s²
    private readonly double _perSpeed; // bound for drag and lift, 1/m
    private readonly double _perSpin;

    // Up to this length, in s, drag and lift are small at every speed and spin, and two constant bounds on |u|² are sufficient.
    private readonly double _short;
    private readonly double _leastSquare;
    private readonly double _mostSquare;

    /// <param name="scene">The scene.</param>
    /// <param name="forces">The bound on the change of velocity by drag and lift.</param>
    /// <param name="fastestSpin">The highest spin of an evaluation, in rad/s; infinite if there is none.</param>
    /// <param name="slowest">The lowest speed at which the tables hold, in m/s.</param>
    /// <param name="fastest">The highest speed at which the tables hold, in m/s.</param>
    public TableRange(Scene scene, in RateBound forces, double fastestSpin, double slowest, double fastest)
    {
        _slowest = slowest;
        _fastest = fastest;
        _gravity = Math.Abs(Weight.UpwardAcceleration(scene));
        _perSpeed = forces.PerSpeed;
        _perSpin = forces.PerSpin;

        // So short a step changes little at any speed and spin: two bounds on |u|² are sufficient.
        _short = Math.Min(0.5 * LargestChange / (_perSpeed * fastest), 0.5 * LargestChange / (_perSpin * fastestSpin));
        _short = Math.Min(_short, ShortFall / Math.Max(1, _gravity));
        double fall = _short * _gravity;
        _leastSquare = SlowerInShort * (slowest + fall) * SlowerInShort * (slowest + fall);
        _mostSquare = fastest > fall ? (fastest - fall) * (fastest - fall) : 0;
    }

    /// <summary>Returns true if speed and spin parameter stay within the tables at every stage.</summary>
    /// <param name="speedSquared">|u|² at the start, m²/s².</param>
    /// <param name="spinRate">|ω| at the start, rad/s.</param>
    /// <param name="surfaceSquared">(r|ω|)².</param>
    /// <param name="h">The length of the step, in s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Holds(double speedSquared, double spinRate, double surfaceSquared, double h)
    {
        // g is gravity: within h, it changes |u| by at most h g, and drag leaves at least 0.74 |u|.
        // The spin parameter starts below 20 and stays below 32: (0.74 |u| − h g)² ≥ 0.41 |u|² − 3 (h g)², and 400/0.41 and 3072/3 are at most 32².
        const double Largest = LargestSpinParameter * LargestSpinParameter;
        double fall = h * _gravity;
        bool spins = surfaceSquared + (3072.0 * fall * fall) < Largest * speedSquared && surfaceSquared < FastestSurface * FastestSurface;
        if (h <= _short)
        {
            return spins && speedSquared > _leastSquare && speedSquared < _mostSquare;
        }

        // For a longer step, bound the changes by gravity, drag and lift at this speed and spin.
        double least = Slower * (_slowest + fall);
        double most = _fastest - fall;
        double bySpeed = h * _perSpeed;
        double left = LargestChange - (h * _perSpin * spinRate);
        return spins && speedSquared > least * least && most > 0 && speedSquared < most * most
            && left > 0 && bySpeed * bySpeed * speedSquared < left * left;
    }
}
