using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A bank shot as a chain of legs, from contact to contact and to the target, solved by multiple shooting.</summary>
/// <remarks>
/// Each leg flies in an empty scene, with the ground only for its bounces, so it always has a gap to measure. The unknowns are elevation and azimuth
/// of the kick, the duration of each leg, and two numbers for each contact's position on its surface. The residuals are the gaps at the ends of the
/// legs. Only a tiny range of elevations and azimuths hits a post, but a large range of contact positions does: in these unknowns, Newton's method
/// converges from far away.
/// </remarks>
internal sealed class BankShotProblem : ILeastSquares
{
    public const int Elevation = 0;
    public const int Azimuth = 1;
    private const int FirstTime = 2;

    /// <summary>The minimum and maximum duration of a leg after its last bounce, in s.</summary>
    private const double ShortestLeg = 1e-4;
    private const double LongestLeg = 8;

    /// <summary>The minimum speed used to guess the duration of a leg, as a share of the ball's speed.</summary>
    private const double LeastShare = 0.3;

    /// <summary>The maximum changes per iteration.</summary>
    /// <remarks>They limit the kick's angles and a contact's normal, in rad; a contact's position, as a share of its leg; and a time, in s.</remarks>
    private const double LargestTurn = 1;
    private const double LargestBend = 1.2;
    private const double LargestShare = 2;
    private const double LargestDelay = 2;

    /// <summary>The width of difference quotients, in rad, m or s.</summary>
    private const double Width = 1e-5;

    /// <summary>The share of the tolerance to which legs are closed.</summary>
    /// <remarks>
    /// A post amplifies the remaining gap, but the full flight corrects this error anyway. A value of 1e-3 is no cheaper (<c>football lab bankshots
    /// --requests 60</c>).
    /// </remarks>
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

    /// <param name="open">The empty scene.</param>
    /// <param name="grounded">The scene with its ground only.</param>
    /// <param name="count">The number of contacts.</param>
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

    /// <summary>The number of contacts.</summary>
    public int Count { get; }

    public int Unknowns => FirstTime + Count + 1 + (2 * Count);

    public int Equations => 3 * (Count + 1);

    /// <summary>The contacts in order, without the ground.</summary>
    public BankShotContact[] Contacts { get; }

    /// <summary>The number of ground bounces of each leg.</summary>
    public int[] Bounces { get; }

    /// <summary>The unknowns.</summary>
    public double[] X { get; }

    /// <summary>The least-squares solver.</summary>
    public LeastSquares Solver { get; }

    public bool IsSpent => Solver.Iterations >= _request.MaximumIterations;

    /// <summary>The kick of the current unknowns.</summary>
    public Kick Kick => Kick.Of(_request, X[Elevation], X[Azimuth]);

    /// <summary>Solves from a kick and from the current contacts.</summary>
    /// <param name="request">The request.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="step">The step of a leg, in s.</param>
    /// <param name="counts">Receives the numbers of flights and corrections.</param>
    public void Close(AimRequest request, in TargetFrame frame, in Kick kick, double step, BankShotFlight counts)
    {
        // Set the durations to NaN, so that the first flight estimates them.
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

    /// <summary>Simulates all legs for their durations; the residuals are the gaps at their ends.</summary>
    public bool Evaluate(double[] x, double[] r)
    {
        // For each leg: 1. Project its end from the tangent plane at the guess onto the surface. 2. Simulate its duration, and store the gap. 3.
        // Apply the impact at the assumed contact, so that the next leg exists even after a miss. 4. Start the next leg there.
        _counts!.Simulations++;
        Kick.Of(_request, x[Elevation], x[Azimuth]).Vectors(_request.Speed, in _frame.Forward, out Vector3d v, out Vector3d w);
        Vector3d p = _frame.From;
        double time = _request.KickTime;
        BallState state = default;
        for (int leg = 0; ; leg++)
        {
            BankShotContact contact = leg == Count ? default : Contacts[leg];
            int place = FirstTime + Count + 1 + (2 * leg);
            Vector3d end = leg == Count ? _frame.Target : contact.Place + (x[place] * contact.Level) + (x[place + 1] * contact.Steep);
            if (!FlyLeg(leg, in p, in v, in w, time, in end, ref x[FirstTime + leg], ref state))
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

            // Limit the step of a contact by the length of its leg and by the rotation of its normal.
            double bend = (contact.Curvature * new Vector3d(1, 1, 1)).Length;
            _reach[leg] = Math.Min(LargestShare * Math.Max(0.1, x[FirstTime + leg] * state.Velocity.Length), LargestBend / Math.Max(bend, 1e-9));
            Vector3d touched = end - (_ball.Radius * contact.Normal);
            Vector3d surface = contact.Thing.SpinVelocity(in touched, state.Time);
            if (!(Vector3d.Dot(state.Velocity - surface, contact.Normal) < 0))
            {
                return false;
            }

            ImpactLaw.Apply(_ball, in contact.Thing.MaterialAt(in end), in contact.Normal, in surface, state.Velocity, state.Spin, out v, out w);
            p = end;
            time = state.Time;
        }
    }

    public void KnownColumns(double[] x, double[] j)
    {
        // A duration moves the end of its own leg along the path. Broyden's updates handle the small effect on later legs.
        for (int leg = 0; leg <= Count; leg++)
        {
            for (int i = 0; i < Equations; i++)
            {
                j[(i * Unknowns) + FirstTime + leg] = i == 3 * leg ? _arrival[leg].X : i == (3 * leg) + 1 ? _arrival[leg].Y : i == (3 * leg) + 2 ? _arrival[leg].Z : 0;
            }
        }
    }

    /// <summary>Simulates a leg through its bounces, and then for its duration.</summary>
    /// <returns>False if the ball does not bounce that often.</returns>
    private bool FlyLeg(int leg, in Vector3d p, in Vector3d v, in Vector3d w, double time, in Vector3d end, ref double duration, ref BallState state)
    {
        // An impact changes neither the orientation of the ball nor the distance flown.
        Simulator simulator = Bounces[leg] > 0 ? _grounded : _open;
        state = leg == 0 ? simulator.LaunchAt(in p, in v, in w, time, AimContext.OrientationOf(simulator, _request)) : simulator.LaunchOn(in p, in v, in w, time, in state);
        _log.Clear();
        for (int i = 0; i < Bounces[leg]; i++)
        {
            if (!_grounded.RunChecked(ref state, _step, LongestLeg, StopAt.Impact, _log, null) || state.Motion != MotionState.Airborne)
            {
                return false;
            }
        }

        // After its last bounce, continue the leg without ground, so that the gap changes smoothly even below the ground.
        if (Bounces[leg] > 0)
        {
            state = _open.LaunchOn(state.Position, state.Velocity, state.Spin, state.Time, in state);
        }

        if (double.IsNaN(duration))
        {
            // Estimate the duration from the distance and the speed towards the contact. Use a minimum speed, because the ball may move sideways or backwards.
            Vector3d way = end - state.Position;
            double length = way.Length;
            double along = Vector3d.Dot(in way, state.Velocity) / length;
            duration = Clamp(FirstTime, length / Math.Max(along, LeastShare * state.Velocity.Length));
        }

        _open.RunChecked(ref state, _step, duration, StopAt.Time, _log, null);
        return true;
    }
}
