using FootballPhysics.Numerics;

namespace FootballPhysics.Game;

/// <summary>A touch as a least-squares problem: the unknowns are the ball's new velocity and spin; its simulated path gives the residuals.</summary>
internal abstract class TouchProblem : ILeastSquares
{
    /// <summary>The step of the simulated path, in s.</summary>
    private const double TimeStep = 0.01;

    private const int MostFlights = 120;

    private readonly Foot _foot;
    private readonly double _closeness;
    private readonly LeastSquares _solver;
    private int _flights;

    /// <param name="simulator">The scene.</param>
    /// <param name="foot">The foot that strikes the ball.</param>
    /// <param name="unknowns">The number of unknowns.</param>
    /// <param name="equations">The maximum number of residuals.</param>
    /// <param name="closeness">The size of each of the first two residuals below which the touch is a hit.</param>
    protected TouchProblem(Simulator simulator, Foot foot, int unknowns, int equations, double closeness)
    {
        Simulator = simulator;
        _foot = foot;
        _closeness = closeness;
        Unknowns = unknowns;
        Equations = equations;
        _solver = new LeastSquares(this, equations);
    }

    /// <summary>The incoming ball.</summary>
    public BallState Ball;

    /// <summary>The strike of the last flight.</summary>
    public FootStrike Strike { get; private set; }

    /// <summary>The ball after the touch, at the evaluated moment.</summary>
    public BallState End;

    public int Unknowns { get; }

    public int Equations { get; protected set; }

    public bool IsSpent => _flights >= MostFlights;

    protected Simulator Simulator { get; }

    protected StepLog Log { get; } = new() { IgnoresZones = true };

    public virtual bool IsFree(int unknown) => true;

    public abstract double Clamp(int unknown, double value);

    public abstract double LargestChange(int unknown);

    public abstract double Difference(int unknown);

    public void KnownColumns(double[] x, double[] j)
    {
    }

    public bool Evaluate(double[] x, double[] r)
    {
        _flights++;
        TargetMotion(x, out Vector3d velocity, out Vector3d spin);
        if (!((velocity - Ball.Velocity).Length > 1e-9))
        {
            // The ball already moves as required, so let the foot barely touch it.
            velocity += 1e-6 * Vector3d.Up;
        }

        Strike = _foot.StrikeFor(Simulator.Scene.Ball, Ball.Velocity, Ball.Spin, velocity, spin);
        return Follow(Strike.Velocity, Strike.Spin, r);
    }

    public virtual bool IsHit(double[] r) => Math.Abs(r[0]) < _closeness && Math.Abs(r[1]) < _closeness;

    /// <summary>Solves from a start, which is overwritten with the best solution; the last flight is that of the solution.</summary>
    public bool Solve(double[] x)
    {
        _flights = 0;

        // The last trial of the solver may have been rejected. Simulate the best solution again, so that Strike and End belong to it.
        bool hit = _solver.Solve(x);
        bool flies = Evaluate(x, _solver.Residuals);
        return hit && flies;
    }

    /// <summary>The residuals of the solution.</summary>
    public double[] Residuals => _solver.Residuals;

    /// <summary>Simulates the ball after a touch and computes the residuals.</summary>
    /// <returns>False if the path has no residuals.</returns>
    public abstract bool Follow(in Vector3d velocity, in Vector3d spin, double[] r);

    /// <summary>Returns the velocity and spin that the foot must give the ball.</summary>
    protected abstract void TargetMotion(double[] x, out Vector3d velocity, out Vector3d spin);

    /// <summary>Simulates the ball for a time after a touch.</summary>
    protected void Run(in Vector3d velocity, in Vector3d spin, double duration)
    {
        End = Kicked(in velocity, in spin);

        // Simulate up to the requested time, including bounces.
        Log.Clear();
        Simulator.Run(ref End, TimeStep, duration, StopAt.Time, Log, null);
    }

    /// <summary>Returns the ball right after a touch.</summary>
    protected BallState Kicked(in Vector3d velocity, in Vector3d spin)
    {
        BallState kicked = Ball;
        Simulator.Kick(ref kicked, KickVectors.Limited(in velocity, Limits.Speed), KickVectors.Limited(in spin, Limits.Spin));
        return kicked;
    }

    /// <summary>Returns the spin of a ball that rolls on level ground, in rad/s.</summary>
    protected Vector3d Rolling(in Vector3d velocity) => Vector3d.Cross(Vector3d.Up, velocity.Horizontal) / Simulator.Scene.Ball.Radius;
}

/// <summary>A dribbling touch: solves for the horizontal velocity and, if necessary, the topspin, that give the wanted position and speed.</summary>
internal sealed class DribbleProblem(Simulator simulator, Foot foot) : TouchProblem(simulator, foot, unknowns: 3, equations: 3, closeness: 2e-4)
{
    private bool _spins;
    private double _after;
    private Vector3d _place;
    private double _pace;

    /// <summary>Sets the request.</summary>
    public void Set(in BallState ball, DribbleRequest request)
    {
        Ball = ball;
        _after = request.Duration;
        _place = request.BallTarget;
        _pace = request.RunSpeed;
        Free(spin: false);
    }

    /// <summary>Frees or fixes the topspin, which controls the speed.</summary>
    public void Free(bool spin)
    {
        _spins = spin;
        Equations = spin ? 3 : 2;
    }

    public override bool IsFree(int unknown) => unknown < 2 || _spins;

    public override double Clamp(int unknown, double value) => unknown < 2 ? Math.Clamp(value, -40, 40) : Math.Clamp(value, -120, 120);

    public override double LargestChange(int unknown) => unknown < 2 ? 5 : 40;

    public override double Difference(int unknown) => unknown < 2 ? 0.02 : 2;

    public override bool IsHit(double[] r) => base.IsHit(r) && (!_spins || Math.Abs(r[2]) < 0.01);

    public override bool Follow(in Vector3d velocity, in Vector3d spin, double[] r)
    {
        Run(in velocity, in spin, _after);
        Vector3d off = (End.Position - _place).Horizontal;
        r[0] = off.X;
        r[1] = off.Z;
        r[2] = End.Velocity.Horizontal.Length - _pace;
        return true;
    }

    protected override void TargetMotion(double[] x, out Vector3d velocity, out Vector3d spin)
    {
        velocity = new Vector3d(x[0], 0, x[1]);
        Vector3d rolling = Rolling(in velocity);
        double rate = rolling.Length;

        // Add a topspin x₂ to the rolling spin, about the same axis.
        spin = rolling + (rate > 0 ? x[2] / rate * rolling : Vector3d.Zero);
    }
}

/// <summary>A trap: solves for the horizontal velocity after which the ball, with its remaining spin, settles as required.</summary>
internal sealed class TrapProblem(Simulator simulator, Foot foot) : TouchProblem(simulator, foot, unknowns: 2, equations: 2, closeness: 1e-3)
{
    private Vector3d _velocity;
    private double _after;

    /// <summary>Sets the request.</summary>
    public void Set(in BallState ball, TrapRequest request)
    {
        Ball = ball;
        _velocity = request.Velocity.Horizontal;
        _after = request.Duration;
    }

    public override double Clamp(int unknown, double value) => Math.Clamp(value, -40, 40);

    public override double LargestChange(int unknown) => 3;

    public override double Difference(int unknown) => 0.02;

    public override bool Follow(in Vector3d velocity, in Vector3d spin, double[] r)
    {
        Run(in velocity, in spin, _after);
        Vector3d off = (End.Velocity - _velocity).Horizontal;
        r[0] = off.X;
        r[1] = off.Z;
        return true;
    }

    protected override void TargetMotion(double[] x, out Vector3d velocity, out Vector3d spin)
    {
        velocity = new Vector3d(x[0], 0, x[1]);
        spin = Rolling(in velocity);
    }
}

/// <summary>A first-time shot: solves for elevation and azimuth at a given speed, from the point at which the ball crosses the target plane.</summary>
internal sealed class FirstTimeProblem(Simulator simulator, Foot foot) : TouchProblem(simulator, foot, unknowns: 2, equations: 2, closeness: 1e-4)
{
    private const double Longest = 6;
    private readonly Trajectory _path = new(2048);
    private LookAheadRequest _look = new();
    private FirstTimeRequest _request = new();
    private Plane3d _plane;
    private Vector3d _aside;
    private double _speed;

    /// <summary>The closest approach of the last flight.</summary>
    public PathPoint Closest { get; private set; }

    /// <summary>The distance of the closest approach from the target, in m.</summary>
    public double Miss { get; private set; }

    /// <summary>Sets the request and the speed.</summary>
    public void Set(in BallState ball, FirstTimeRequest request, double speed)
    {
        Ball = ball;
        _request = request;
        _speed = speed;

        // Use the plane through the target, perpendicular to the ball's direction there. The residuals are the vertical and lateral offsets in this plane.
        Vector3d flat = (request.Target - ball.Position).Horizontal;
        Vector3d forward = flat / flat.Length;
        _plane = new Plane3d(request.Target, forward);
        _aside = Vector3d.Cross(Vector3d.Up, in forward);

        // Continue slightly beyond the plane, because a descending ball may be closest behind the plane.
        _look = new LookAheadRequest
        {
            Duration = Longest,
            TimeStep = 0.02,
            StopAt = StopAt.Rest,
            UntilPlane = new Plane3d(request.Target + (0.5 * forward), forward),
        };
    }

    public override double Clamp(int unknown, double value) => unknown == 0 ? Math.Clamp(value, -5, _request.MaximumElevationDegrees) : Math.Clamp(value, -350, 350);

    public override double LargestChange(int unknown) => 8;

    public override double Difference(int unknown) => 0.02;

    public override bool Follow(in Vector3d velocity, in Vector3d spin, double[] r)
    {
        BallState kicked = Kicked(in velocity, in spin);

        // Search the complete flight: the solver uses the offsets in the plane, but the result contains the closest approach.
        Simulator.LookAhead(in kicked, _look, _path);
        Closest = _path.ClosestApproach(_request.Target);
        Miss = (Closest.Position - _request.Target).Length;
        if (!_path.TryGetCrossing(in _plane, out PathPoint at))
        {
            return false;
        }

        r[0] = at.Position.Y - _request.Target.Y;
        r[1] = Vector3d.Dot(at.Position - _request.Target, in _aside);
        return true;
    }

    protected override void TargetMotion(double[] x, out Vector3d velocity, out Vector3d spin)
    {
        KickVectors.FromAngles(_speed, x[0], x[1], _request.TopSpin, _request.SideSpin, out velocity, out spin);
    }
}
