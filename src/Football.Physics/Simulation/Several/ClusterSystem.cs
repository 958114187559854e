using FootballPhysics.Contacts;
using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>Balls in sustained contact as one system, with the contacts and their modes locked (contacts.md, Balls on balls).</summary>
/// <remarks>
/// With n and ṅ of the line of centres, two balls keep touching if n·(v̇₁ − v̇₂) = −ṅ·(v₁ − v₂).
/// If they stick, their slip v₁ − v₂ + n × (r₁ ω₁ + r₂ ω₂) stays zero; if they slip, F = −μ N ŝ.
/// Contacts with stationary objects are those of <see cref="ContactSystem"/>. One linear system gives all loads and friction forces,
/// and the integrator advances all balls together.
/// </remarks>
internal sealed partial class ClusterSystem
{
    /// <summary>Maximum number of balls solved together, and of their unknown forces.</summary>
    public const int MostBalls = 8;
    public const int MostRows = 64;

    /// <summary>Maximum number of their contacts.</summary>
    public const int MostContacts = 32;

    private readonly ClusterRow[] _rows;
    private readonly double[] _g;
    private readonly double[] _x;
    private readonly double[] _target;

    /// <param name="room">Memory for the equations, shared by all clusters of a group.</param>
    public ClusterSystem(ClusterRoom room)
    {
        _rows = room.Rows;
        _g = room.G;
        _x = room.X;
        _target = room.Target;
    }

    /// <summary>The balls.</summary>
    public ClusterBall[] Balls { get; } = new ClusterBall[MostBalls];

    /// <summary>Number of balls.</summary>
    public int Count { get; set; }

    /// <summary>Their contacts.</summary>
    public ClusterContact[] Contacts { get; } = new ClusterContact[MostContacts];

    /// <summary>Number of contacts.</summary>
    public int ContactCount { get; set; }

    /// <summary>The time over which the forces are limited to those possible in a flight, s.</summary>
    public double Part { get; set; }

    /// <summary>Number of force evaluations per ball.</summary>
    public int Evaluations { get; set; }

    /// <summary>Advances all balls by one step of the integrator from known rates at the start, and updates the contacts at its
    /// end.</summary>
    /// <param name="method">The integrator.</param>
    /// <param name="time">Start time, s.</param>
    /// <param name="h">Length of the step, s.</param>
    /// <returns>False if the forces of a stage do not exist.</returns>
    public bool Advance(IIntegrator method, double time, double h)
    {
        double half = 0.5 * h;
        bool holds = true;
        switch (method.Order)
        {
            case 4:
                // Evaluate the rates at the start, twice in the middle and at the end, as in ClassicalRungeKutta.
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Motion from = From(in ball);
                    ball.Second = from.After(half, in from.Velocity, in ball.First);
                    ball.At = ball.Second;
                }

                holds &= Rates(time + half);
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    ball.SecondRates = ball.Rates;
                    ball.Third = From(in ball).After(half, in ball.Second.Velocity, in ball.SecondRates);
                    ball.At = ball.Third;
                }

                holds &= Rates(time + half);
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    ball.ThirdRates = ball.Rates;
                    ball.At = From(in ball).After(h, in ball.Third.Velocity, in ball.ThirdRates);
                }

                holds &= Rates(time + h);
                for (int i = 0; i < Count; i++)
                {
                    EndClassical(ref Balls[i], h);
                }

                break;
            case 2:
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Motion from = From(in ball);
                    ball.At = from.After(half, in from.Velocity, in ball.First);
                }

                holds &= Rates(time + half);
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Vector3d rotation = h * ball.At.Spin;
                    End(ref ball, From(in ball).After(h, ball.At.Velocity, in ball.Rates), in rotation);
                }

                break;
            default:
                // First order: the position uses the velocity at the start (Euler) or the new one (semi-implicit Euler).
                for (int i = 0; i < Count; i++)
                {
                    ref ClusterBall ball = ref Balls[i];
                    Motion from = From(in ball);
                    Vector3d after = from.Velocity + (method.ShareInPath * h * ball.First.Acceleration);
                    Motion end = from.After(h, in after, in ball.First);
                    Vector3d rotation = h * (method.ShareInPath > 0 ? end.Spin : from.Spin);
                    End(ref ball, in end, in rotation);
                }

                break;
        }

        return holds;
    }

    /// <summary>Computes loads, friction and slips at the end of the step.</summary>
    public bool LookAtEnd(double time)
    {
        for (int i = 0; i < Count; i++)
        {
            ref ClusterBall ball = ref Balls[i];
            ball.At = MotionOf(in ball.End);
        }

        bool holds = Rates(time);
        for (int i = 0; i < Count; i++)
        {
            Balls[i].Last = Balls[i].Rates;
        }

        return holds;
    }

    /// <summary>Computes the forces on the balls without contacts, and updates the contacts.</summary>
    public void Look(double time)
    {
        for (int i = 0; i < Count; i++)
        {
            ref ClusterBall ball = ref Balls[i];
            BallState s = ball.Start;
            s.Time = time;
            s.Position = ball.At.Position;
            s.Velocity = ball.At.Velocity;
            s.SpinAxis = ball.At.Spin;
            s.AirDistance = ball.At.AirDistance;
            ball.Free = ball.Pile.Free(in s, Part, atRest: false);
        }

        Evaluations++;
        for (int i = 0; i < ContactCount; i++)
        {
            Look(ref Contacts[i], time);
        }
    }

    /// <summary>The motion of a ball.</summary>
    public static Motion MotionOf(in BallState s) => new(s.Position, s.Velocity, s.Spin, s.AirDistance);

    private static Motion From(in ClusterBall ball) => MotionOf(in ball.Start);

    private static void EndClassical(ref ClusterBall ball, double h)
    {
        Motion from = From(in ball);
        Motion end = ClassicalRungeKutta.End(
            in from, h, in ball.First, in ball.Second, in ball.SecondRates, in ball.Third, in ball.ThirdRates, in ball.At, in ball.Rates);
        Vector3d rotation = RotationVector.Of(in from.Spin, 0.5 * (ball.Second.Spin + ball.Third.Spin), in end.Spin, h);
        End(ref ball, in end, in rotation);
    }

    private static void End(ref ClusterBall ball, in Motion end, in Vector3d rotation)
    {
        ball.End = ball.Start;
        ball.End.BaseOrientation = ball.Start.BaseOrientation.Turned(in rotation);
        ball.End.Position = end.Position;
        ball.End.Velocity = end.Velocity;
        ball.End.SpinAxis = end.Spin;
        ball.End.AirDistance = end.AirDistance;
    }

    private void Look(ref ClusterContact contact, double time)
    {
        ref readonly ClusterBall ball = ref Balls[contact.First];
        if (contact.Second < 0)
        {
            contact.On.Look(ball.World, time, in ball.At);
            contact.Gap = contact.On.Bears ? 0 : ball.World.Colliders[contact.On.Collider].At(ball.At.Position, time).Distance - ball.Radius;
            return;
        }

        // The turning rate of the normal, ṅ = (v₁ − v₂)_t/|p₁ − p₂|.
        ref readonly ClusterBall other = ref Balls[contact.Second];
        Vector3d apart = ball.At.Position - other.At.Position;
        double distance = apart.Length;
        ref SetContact on = ref contact.On;
        on.Turn(apart / distance);
        Vector3d relative = ball.At.Velocity - other.At.Velocity;
        Vector3d along = SurfaceSystem.Tangential(in relative, in on.Normal);
        on.Turning = along / distance;
        on.Centripetal = Vector3d.Dot(in on.Turning, in relative);
        on.Slip = along + Vector3d.Cross(in on.Normal, (ball.Radius * ball.At.Spin) + (other.Radius * other.At.Spin));
        contact.Gap = distance - ball.Radius - other.Radius;
    }

    private bool Rates(double time)
    {
        Look(time);
        return Solve();
    }
}

/// <summary>Memory for the equations of a cluster and for the paths of two balls.</summary>
/// <remarks>Its contents are valid only within a call.</remarks>
internal sealed class ClusterRoom
{
    /// <summary>The unknowns.</summary>
    public ClusterRow[] Rows { get; } = new ClusterRow[ClusterSystem.MostRows];

    /// <summary>G x = b: G row by row, x, and b.</summary>
    public double[] G { get; } = new double[ClusterSystem.MostRows * ClusterSystem.MostRows];

    /// <inheritdoc cref="G"/>
    public double[] X { get; } = new double[ClusterSystem.MostRows];

    /// <inheritdoc cref="G"/>
    public double[] Target { get; } = new double[ClusterSystem.MostRows];

    /// <summary>The paths.</summary>
    public BallTrial Way { get; } = new();

    /// <inheritdoc cref="Way"/>
    public BallTrial OtherWay { get; } = new();
}
