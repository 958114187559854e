namespace FootballPhysics.Aiming;

/// <summary>
/// A kick in legs, each from one contact to the next and the last to the target, flown among nothing but the ground, and that only where it is to be met: there is always
/// something to miss by (multiple shooting). Unknown are the kick's elevation and azimuth, how long each leg lasts, and two numbers
/// for the place of each contact on the surface that it is on; what is left over are the gaps at the ends of the legs.
/// </summary>
/// <remarks>
/// The kicks that meet a post are a hair's breadth of elevations and azimuths, but a post's whole side of places: in these unknowns Newton's method comes from far.
/// </remarks>
internal sealed class BankShotProblem : ILeastSquares
{
    public const int Elevation = 0;
    public const int Azimuth = 1;
    private const int FirstTime = 2;

    /// <summary>A leg takes no less time after its last bounce, and no more, s.</summary>
    private const double ShortestLeg = 1e-4;
    private const double LongestLeg = 8;

    /// <summary>A leg is at least as fast as this share of the ball, where its time is guessed.</summary>
    private const double LeastShare = 0.3;

    /// <summary>The most that an iteration turns the kick, or the normal of a contact, rad; and of the length of the leg to it, that it moves a contact; and that a time changes, s.</summary>
    private const double LargestTurn = 1;
    private const double LargestBend = 1.2;
    private const double LargestShare = 2;
    private const double LargestDelay = 2;

    /// <summary>Columns are difference quotients over so much, rad, m or s.</summary>
    private const double Width = 1e-5;

    /// <summary>
    /// Legs are closed within this share of the tolerance: a post spreads what is left, which is corrected by the whole flight then. At 1e-3 that is no cheaper
    /// (<c>football lab bankshots --requests 60</c>).
    /// </summary>
    private const double Closed = 3e-2;

    private readonly Simulator _open;
    private readonly Simulator _grounded;
    private readonly BallProperties _ball;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly Vector3d[] _arrival;
    private readonly double[] _reach;
    private AimRequest _request = new();
    private TargetFrame _frame;
    private double _step;
    private BankShotFlight? _counts;

    /// <param name="open">The scene with nothing in it.</param>
    /// <param name="grounded">The scene with its ground alone.</param>
    /// <param name="count">How many contacts there are.</param>
    public BankShotProblem(Simulator open, Simulator grounded, int count)
    {
        _open = open;
        _grounded = grounded;
        _ball = grounded.Scene.Ball;
        Count = count;
        Contacts = new BankShotContact[count];
        Bounces = new int[count + 1];
        X = new double[Unknowns];
        _arrival = new Vector3d[count + 1];
        _reach = new double[count];
        Solver = new LeastSquares(this, Equations);
    }

    /// <summary>How many contacts there are.</summary>
    public int Count { get; }

    public int Unknowns => FirstTime + Count + 1 + (2 * Count);

    public int Equations => 3 * (Count + 1);

    /// <summary>The things touched, in order, without the ground.</summary>
    public BankShotContact[] Contacts { get; }

    /// <summary>How often a leg meets the ground.</summary>
    public int[] Bounces { get; }

    /// <summary>The unknowns.</summary>
    public double[] X { get; }

    /// <summary>Solves it.</summary>
    public LeastSquares Solver { get; }

    public bool IsSpent => Solver.Iterations >= _request.MaximumIterations;

    /// <summary>The kick.</summary>
    public Kick Kick => Kick.Of(_request, X[Elevation], X[Azimuth]);

    /// <summary>Solves it from a kick, and from where its contacts are.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="step">Step of a leg, s.</param>
    /// <param name="counts">Where flights and corrections are counted.</param>
    public void Close(AimRequest request, in TargetFrame frame, in Kick kick, double step, BankShotFlight counts)
    {
        // The first flight goes on for as long as seems right.
        Array.Clear(X, 0, Unknowns);
        Array.Fill(X, double.NaN, FirstTime, Count + 1);
        X[Elevation] = kick.Elevation;
        X[Azimuth] = kick.Azimuth;
        _counts = counts;
        _request = request;
        _frame = frame;
        _step = step;
        Solver.Iterations = 0;
        Solver.Solve(X);
        counts.Iterations += Solver.Iterations;
    }

    public bool IsFree(int unknown) => true;

    public double Clamp(int unknown, double value) =>
        unknown == Elevation ? Math.Min(Math.Max(value, -0.5 * Math.PI), 0.5 * Math.PI)
        : unknown >= FirstTime && unknown <= FirstTime + Count ? Math.Min(Math.Max(value, ShortestLeg), LongestLeg)
        : value;

    public double LargestChange(int unknown) =>
        unknown < FirstTime ? LargestTurn : unknown <= FirstTime + Count ? LargestDelay : _reach[(unknown - FirstTime - Count - 1) / 2];

    public double Difference(int unknown) => unknown == FirstTime + Count ? 0 : Width;

    public bool IsHit(double[] r)
    {
        double squares = 0;
        for (int i = 0; i < Equations; i++)
        {
            squares += r[i] * r[i];
        }

        return squares <= Closed * Closed * _request.Tolerance * _request.Tolerance;
    }

    public bool Fly(double[] x, double[] r)
    {
        // Leg by leg. 1. The place of its end is put onto the surface that it is on: the two numbers lead along the plane that touches it where the guess was.
        // 2. The leg is flown for its time, and the gap is taken. 3. The impact happens where it was assumed, not where the leg ended, so that a kick that would miss the
        // thing has a next leg, too. 4. The next leg begins there. Only a ball that comes from behind, or bounces too seldom, has no residuals.
        _counts!.Simulations++;
        Kick.Of(_request, x[Elevation], x[Azimuth]).Vectors(_request.Speed, in _frame.Forward, out Vector3d v, out Vector3d w);
        Vector3d p = _frame.From;
        double time = _request.KickTime;
        for (int leg = 0; ; leg++)
        {
            BankShotContact contact = leg == Count ? default : Contacts[leg];
            int place = FirstTime + Count + 1 + (2 * leg);
            Vector3d end = leg == Count ? _frame.Target : contact.Place + (x[place] * contact.Level) + (x[place + 1] * contact.Steep);
            if (!FlyLeg(leg, in p, in v, in w, time, in end, ref x[FirstTime + leg], out BallState state))
            {
                return false;
            }

            if (leg < Count)
            {
                contact.GoTo(in end, _ball.Radius, state.Time);
                end = contact.Place;
            }

            Vector3d gap = state.Position - end;
            (r[3 * leg], r[(3 * leg) + 1], r[(3 * leg) + 2]) = (gap.X, gap.Y, gap.Z);
            _arrival[leg] = state.Velocity;
            if (leg == Count)
            {
                return gap.IsFinite;
            }

            // How far the contact may move in an iteration: by its leg's length, and by what turns its normal.
            double bend = (contact.Curvature * new Vector3d(1, 1, 1)).Length;
            _reach[leg] = Math.Min(LargestShare * Math.Max(0.1, x[FirstTime + leg] * state.Velocity.Length), LargestBend / Math.Max(bend, 1e-9));
            Vector3d touched = end - (_ball.Radius * contact.Normal);
            Vector3d surface = contact.Thing.SurfaceVelocity(in touched, state.Time);
            if (!(Vector3d.Dot(state.Velocity - surface, contact.Normal) < 0))
            {
                return false;
            }

            CoulombImpact.Apply(_ball, in contact.Thing.MaterialAt(in end), in contact.Normal, in surface, state.Velocity, state.Spin, out v, out w);
            p = end;
            time = state.Time;
        }
    }

    public void KnownColumns(double[] x, double[] j)
    {
        // A time moves the end of its leg along the way; what it changes of the legs after that is little, and left to Broyden's updates.
        for (int leg = 0; leg <= Count; leg++)
        {
            for (int i = 0; i < Equations; i++)
            {
                j[(i * Unknowns) + FirstTime + leg] = i == 3 * leg ? _arrival[leg].X : i == (3 * leg) + 1 ? _arrival[leg].Y : i == (3 * leg) + 2 ? _arrival[leg].Z : 0;
            }
        }
    }

    /// <summary>Flies a leg: over its bounces, and for its time after them.</summary>
    /// <returns>False where the ball does not bounce that often.</returns>
    private bool FlyLeg(int leg, in Vector3d p, in Vector3d v, in Vector3d w, double time, in Vector3d end, ref double duration, out BallState state)
    {
        state = (Bounces[leg] > 0 ? _grounded : _open).LaunchAt(in p, in v, in w, time);
        _log.Clear();
        for (int i = 0; i < Bounces[leg]; i++)
        {
            if (!_grounded.RunChecked(ref state, _step, LongestLeg, StopAt.Impact, _log, null) || state.Motion != MotionState.Airborne)
            {
                return false;
            }
        }

        // After its last bounce a leg goes on without ground: what lies below it still has a gap that changes smoothly.
        if (Bounces[leg] > 0)
        {
            state = _open.LaunchAt(state.Position, state.Velocity, state.Spin, state.Time);
        }

        if (double.IsNaN(duration))
        {
            // Straight on, and as far as it is; sideways or away, as if a part of the speed led there.
            Vector3d way = end - state.Position;
            double length = way.Length;
            double along = Vector3d.Dot(in way, state.Velocity) / length;
            duration = Clamp(FirstTime, length / Math.Max(along, LeastShare * state.Velocity.Length));
        }

        _open.RunChecked(ref state, _step, duration, StopAt.Time, _log, null);
        return true;
    }
}
