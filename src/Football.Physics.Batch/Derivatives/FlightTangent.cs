namespace FootballPhysics.Batch;

/// <summary>
/// The variational equation along plain flight: the axis of the spin is constant, so velocity and size of the spin are all that changes. Several pieces are taken
/// at once by classical Runge–Kutta, which asks the laws at their start, middle and end only.
/// </summary>
internal sealed class FlightTangent
{
    /// <summary>Pieces taken at once at most.</summary>
    private const int MostPieces = 8;

    /// <summary>No more time than this at once, s: the laws are then all but quadratic.</summary>
    private const double LongestTime = 0.0801;

    /// <summary>At first, s, half of it: little has come of the spin yet.</summary>
    private const double First = 0.16;
    private const double LongestAtFirst = 0.0401;

    /// <summary>After an impact a quarter of it: bounces magnify what was wrong before them.</summary>
    private const double LongestAfterImpact = 0.0201;

    /// <summary>No more change of the speed, m/s.</summary>
    private const double LargestChange = 0.3;

    /// <summary>No more change of the flow at once than this share of it, and of its part across the spin where the laws depend on that: a piece that has more is taken in parts.</summary>
    private const double FlowShare = 0.09;
    private const double AcrossShare = 0.15;
    private const double MostParts = 32;

    /// <summary>A piece along which the part of the flow across the spin changes by more than this share of itself is left to the general form.</summary>
    private const double LeftShare = 0.25;

    /// <summary>A slower spin, rad/s, is left to the general form: its axis may be none.</summary>
    private const double SlowestSpin = 1e-2;

    /// <summary>A slower flow, m/s, likewise.</summary>
    private const double SlowestFlow = 0.5;

    /// <summary>Only where the spin parameter is larger may the lift end: by the published laws at 1.886.</summary>
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

    /// <summary>True when it is under way.</summary>
    public bool IsOpen { get; private set; }

    /// <summary>True when it can take a piece.</summary>
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

        // Any two directions across the axis
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

    /// <summary>Forgets a flight.</summary>
    public void Abandon() => IsOpen = false;

    /// <summary>Adds a piece.</summary>
    public void Add(in BallState after)
    {
        Store(++_count, after.Time, after.Velocity, after.SpinRate);

        // An even number of equal pieces has a state in the middle.
        double h = _times[_count] - _times[0];
        double longest = _times[0] < _shortUntil ? _short : LongestTime;
        bool full = _count == MostPieces || h + (h / _count) > longest
            || ((_count & 1) == 0 && (Math.Abs(_velocities[_count].Length - _velocities[0].Length) > LargestChange || Change(_count) > 0.5));
        if (full || (_count == 1 && Change(1) > 0.5))
        {
            Integrate();
        }
    }

    /// <summary>Ends the flight, and carries the tangent along.</summary>
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

    /// <summary>Takes the stored pieces.</summary>
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

    /// <summary>How much the flow changes over the first pieces, by what is allowed at once.</summary>
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

    /// <summary>The motion at a time: a state that was there, or what is between two of them.</summary>
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

        // A piece by itself, or an odd number: the cubic Hermite interpolant of the piece that the middle is in.
        Rates(i - 1, out Vector3d startAcceleration, out double startRate);
        Rates(i, out Vector3d endAcceleration, out double endRate);
        double length = _times[i] - _times[i - 1];
        double t = time - _times[i - 1];
        velocity = new CubicHermite3d(in _velocities[i - 1], in startAcceleration, in _velocities[i], in endAcceleration, length).PositionAt(t);
        spin = new CubicHermite(_spins[i - 1], length * startRate, _spins[i], length * endRate).At(t / length);
    }

    private void Rates(int i, out Vector3d acceleration, out double spinRate)
    {
        BallState at = default;
        at.SpinAxis = _axis;
        at.Branch = _branch;
        FlightRates.Of(ref _around.Air, in at, _around.Upward, in _velocities[i], _spins[i], out acceleration, out spinRate);
    }

    /// <summary>True when the flow goes so nearly along the spin that forces turn too fast with it to be integrated: the step itself is then differentiated.</summary>
    private bool IsAlongSpin(in BallState before, in BallState after)
    {
        double across = Vector3d.Cross(before.SpinAxis, before.Velocity - _around.Wind).LengthSquared;
        return (after.Velocity - before.Velocity).LengthSquared > LeftShare * LeftShare * across;
    }

    /// <summary>True when a piece leads through the kink at which the lift ends.</summary>
    private bool LiftEnds(in BallState before, in BallState after) =>
        _around.Air.Lifts && _around.RadiusSquared * before.SpinRate * before.SpinRate > FastSpin * FastSpin * (before.Velocity - _around.Wind).LengthSquared
        && LiftOf(in before) > 0 != LiftOf(in after) > 0;

    private double LiftOf(in BallState s)
    {
        double squared = (s.Velocity - _around.Wind).LengthSquared;
        _around.Air.Factors(squared, s.SpinRate, squared, s.Branch, out _, out double lift, out _);
        return lift;
    }

    /// <summary>True when the laws depend on the direction of the spin to the flow.</summary>
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
