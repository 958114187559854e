using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Batch;

/// <summary>The variational equation along plain flight, in which only velocity and spin magnitude change.</summary>
/// <remarks>Classical Runge–Kutta covers several segments at once, and evaluates the laws only at their start, middle and end.</remarks>
internal sealed class FlightTangent
{
    /// <summary>The maximum number of segments in one step.</summary>
    private const int MostPieces = 8;

    /// <summary>The longest step, in s: over it, the laws are nearly quadratic.</summary>
    private const double LongestTime = 0.0801;

    /// <summary>Steps are half as long during this time after the start, in s, while the effect of the spin is still small.</summary>
    private const double First = 0.16;
    private const double LongestAtFirst = 0.0401;

    /// <summary>Steps after an impact are a quarter as long, because bounces magnify earlier errors.</summary>
    private const double LongestAfterImpact = 0.0201;

    /// <summary>The largest change of speed in a step, in m/s.</summary>
    private const double LargestChange = 0.3;

    /// <summary>The largest relative change of the flow in a step, and of its part across the spin if the laws depend on it. Segments with more are split.</summary>
    private const double FlowShare = 0.09;
    private const double AcrossShare = 0.15;
    private const double MostParts = 32;

    /// <summary>The relative change of the flow across the spin, in one segment, above which the general form takes over.</summary>
    private const double LeftShare = 0.25;

    /// <summary>The spin below which the general form takes over, in rad/s: its axis may be undefined.</summary>
    private const double SlowestSpin = 1e-2;

    /// <summary>The flow speed below which the general form takes over, in m/s.</summary>
    private const double SlowestFlow = 0.5;

    /// <summary>The spin parameter above which the lift may vanish; under the published laws it does at 1.886.</summary>
    private const double FastSpin = 1.5;

    private readonly Surroundings _around;
    private readonly bool _needsAcross;
    private readonly Vector3d[] _velocities = new Vector3d[MostPieces + 1];
    private readonly double[] _spins = new double[MostPieces + 1];
    private readonly double[] _times = new double[MostPieces + 1];
    private double _shortUntil;
    private double _short;
    private DragBranch _branch;
    private Vector3d _axis;
    private Vector3d _first;
    private Vector3d _second;
    private double _startSpin;
    private int _count;
    private FlightGenerator _start;
    private FlightColumns _columns;
    private FlightRow _x;
    private FlightRow _y;
    private FlightRow _z;

    public FlightTangent(Surroundings around)
    {
        _around = around;
        _needsAcross = NeedsAcross();
    }

    /// <summary>True while a flight is in progress.</summary>
    public bool IsOpen { get; private set; }

    /// <summary>Returns true if the segment qualifies.</summary>
    public bool Takes(in BallState before, in BallState after) =>
        before.SpinRate > SlowestSpin && after.SpinRate > SlowestSpin && (before.Velocity - _around.Wind).LengthSquared > SlowestFlow * SlowestFlow
        && (after.Velocity - _around.Wind).LengthSquared > SlowestFlow * SlowestFlow && !(_needsAcross && IsAlongSpin(in before, in after))
        && !LiftEnds(in before, in after);

    /// <summary>Begins a flight.</summary>
    public void Begin(in BallState s, DragBranch branch, bool afterImpact)
    {
        IsOpen = true;
        _shortUntil = afterImpact ? double.PositiveInfinity : s.Time + First;
        _short = afterImpact ? LongestAfterImpact : LongestAtFirst;
        _branch = branch;
        _axis = s.SpinAxis;
        _startSpin = s.SpinRate;

        // Any two unit vectors across the axis.
        bool upright = Math.Abs(_axis.Y) > 0.7;
        _first = Vector3d.Cross(in _axis, upright ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0));
        _first /= _first.Length;
        _second = Vector3d.Cross(in _axis, in _first);
        _columns = FlightColumns.Identity;
        _x = default;
        _y = default;
        _z = default;
        Store(0, s.Time, s.Velocity, s.SpinRate);
        FlightGenerator.At(ref _around.Air, _branch, _needsAcross, in _velocities[0], _spins[0], in _axis, in _first, in _second, out _start);
        _count = 0;
    }

    /// <summary>Discards a flight.</summary>
    public void Abandon() => IsOpen = false;

    /// <summary>Adds a segment.</summary>
    public void Add(in BallState after)
    {
        Store(++_count, after.Time, after.Velocity, after.SpinRate);

        // An even number of equal segments has a stored state in the middle.
        double h = _times[_count] - _times[0];
        double longest = _times[0] < _shortUntil ? _short : LongestTime;
        bool full = _count == MostPieces || h + (h / _count) > longest
            || ((_count & 1) == 0 && (Math.Abs(_velocities[_count].Length - _velocities[0].Length) > LargestChange || Change(_count) > 0.5));
        if (full || (_count == 1 && Change(1) > 0.5))
        {
            Integrate();
        }
    }

    /// <summary>Ends the flight, and updates the tangent.</summary>
    public void End(Tangent tangent)
    {
        Integrate();
        IsOpen = false;
        tangent.Fly(in _x, in _y, in _z, in _columns, in _axis, in _first, in _second, _startSpin, _spins[0]);
    }

    private void Store(int index, double time, in Vector3d velocity, double spin)
    {
        _times[index] = time;
        _velocities[index] = velocity - _around.Wind;
        _spins[index] = spin;
    }

    /// <summary>Integrates over the stored segments.</summary>
    private void Integrate()
    {
        if (_count == 0)
        {
            return;
        }

        double h = _times[_count] - _times[0];
        int parts = _count == 1 ? 1 + (int)Math.Min(MostParts, Change(1)) : 1;
        double part = h / parts;
        for (int i = 0; i < parts; i++)
        {
            Motion(_times[0] + ((i + 0.5) * part), out Vector3d velocity, out double spin);
            FlightGenerator.At(ref _around.Air, _branch, _needsAcross, in velocity, spin, in _axis, in _first, in _second, out FlightGenerator middle);
            Motion(i == parts - 1 ? _times[_count] : _times[0] + ((i + 1) * part), out velocity, out spin);
            FlightGenerator.At(ref _around.Air, _branch, _needsAcross, in velocity, spin, in _axis, in _first, in _second, out FlightGenerator end);
            Advance(part, in middle, in end);
            _start = end;
        }

        Store(0, _times[_count], _velocities[_count] + _around.Wind, _spins[_count]);
        _count = 0;
    }

    /// <summary>Returns the change of the flow over the first segments, relative to the limit of one step.</summary>
    private double Change(int pieces)
    {
        Vector3d change = _velocities[pieces] - _velocities[0];
        double least = FlowShare * FlowShare * Math.Min(_velocities[0].LengthSquared, _velocities[pieces].LengthSquared);
        if (_needsAcross)
        {
            double across = Math.Min(Vector3d.Cross(in _axis, in _velocities[0]).LengthSquared, Vector3d.Cross(in _axis, in _velocities[pieces]).LengthSquared);
            least = Math.Min(least, (AcrossShare * AcrossShare * across) + 1e-6);
        }

        return Math.Sqrt(change.LengthSquared / least);
    }

    private void Advance(double h, in FlightGenerator middle, in FlightGenerator end)
    {
        double half = 0.5 * h;
        _start.Apply(in _columns, out FlightColumns k1);
        FlightColumns.Sum(in _columns, half, in k1, out FlightColumns stage);
        middle.Apply(in stage, out FlightColumns k2);
        FlightColumns.Sum(in _columns, half, in k2, out stage);
        middle.Apply(in stage, out FlightColumns k3);
        FlightColumns.Sum(in _columns, h, in k3, out stage);
        end.Apply(in stage, out FlightColumns k4);

        // δp' = δp + h (δv + h/6 (k₁ + k₂ + k₃)),  δv' = δv + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄)
        double sixth = h / 6.0;
        FlightColumns.Sum(in k1, 1.0, in k2, out FlightColumns sum);
        FlightColumns.Sum(in sum, 1.0, in k3, out sum);
        FlightColumns.Sum(in _columns, sixth, in sum, out stage);
        _x = FlightRow.Sum(in _x, h, in stage.X);
        _y = FlightRow.Sum(in _y, h, in stage.Y);
        _z = FlightRow.Sum(in _z, h, in stage.Z);
        FlightColumns.Sum(in sum, 1.0, in k2, out sum);
        FlightColumns.Sum(in sum, 1.0, in k3, out sum);
        FlightColumns.Sum(in sum, 1.0, in k4, out sum);
        FlightColumns.Sum(in _columns, sixth, in sum, out _columns);
    }

    /// <summary>Computes the motion at a time, from a stored state or by interpolation.</summary>
    private void Motion(double time, out Vector3d velocity, out double spin)
    {
        int i = 0;
        while (_times[i] < time - 1e-9)
        {
            i++;
        }

        if (_times[i] <= time + 1e-9)
        {
            velocity = _velocities[i];
            spin = _spins[i];
            return;
        }

        // A single segment, or an odd number: interpolate the middle one with its cubic Hermite polynomial.
        Rates(i - 1, out Vector3d startAcceleration, out double startRate);
        Rates(i, out Vector3d endAcceleration, out double endRate);
        double length = _times[i] - _times[i - 1];
        double t = time - _times[i - 1];
        velocity = PathSegment.Cubic(in _velocities[i - 1], in startAcceleration, in _velocities[i], in endAcceleration, length).PositionAt(t);
        spin = new CubicHermite(_spins[i - 1], length * startRate, _spins[i], length * endRate).At(t / length);
    }

    private void Rates(int i, out Vector3d acceleration, out double spinRate)
    {
        BallState at = default;
        at.SpinAxis = _axis;
        at.Branch = _branch;
        FlightRates.Of(ref _around.Air, in at, _around.Upward, in _velocities[i], _spins[i], out acceleration, out spinRate);
    }

    /// <summary>Returns true if the flow is so nearly along the spin that forces turn too fast to integrate. The step itself is then differentiated.</summary>
    private bool IsAlongSpin(in BallState before, in BallState after)
    {
        double across = Vector3d.Cross(before.SpinAxis, before.Velocity - _around.Wind).LengthSquared;
        return (after.Velocity - before.Velocity).LengthSquared > LeftShare * LeftShare * across;
    }

    /// <summary>Returns true if a segment passes the kink at which the lift vanishes.</summary>
    private bool LiftEnds(in BallState before, in BallState after) =>
        _around.Air.Lifts && _around.RadiusSquared * before.SpinRate * before.SpinRate > FastSpin * FastSpin * (before.Velocity - _around.Wind).LengthSquared
        && LiftOf(in before) > 0 != LiftOf(in after) > 0;

    private double LiftOf(in BallState s)
    {
        double squared = (s.Velocity - _around.Wind).LengthSquared;
        _around.Air.Factors(squared, s.SpinRate, squared, s.Branch, out _, out double lift, out _);
        return lift;
    }

    /// <summary>Returns true if the laws depend on the angle between spin and flow.</summary>
    private bool NeedsAcross()
    {
        if (!(_around.Air.Drags || _around.Air.Lifts || _around.Air.SpinDecays) || _around.Air.Varies)
        {
            return true;
        }

        _around.Air.Factors(400, 30, 400, DragBranch.Spinning, out double drag, out double lift, out double decay);
        _around.Air.Factors(400, 30, 100, DragBranch.Spinning, out double otherDrag, out double otherLift, out double otherDecay);
        return drag != otherDrag || lift != otherLift || decay != otherDecay;
    }
}
