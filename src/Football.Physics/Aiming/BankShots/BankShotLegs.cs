namespace Football.Physics;

/// <summary>
/// A kick in legs, each from one contact to the next and the last to the target, flown among nothing but the ground, and that only where it is to be met: there is always
/// something to miss by. What an impact does is known in closed form. What may be changed are the kick's elevation and azimuth, and two numbers for the place of each contact.
/// </summary>
internal sealed class BankShotLegs
{
    /// <summary>A leg takes no less time after its last bounce, and no more, s.</summary>
    public const double ShortestLeg = 1e-4;
    public const double LongestLeg = 8;

    /// <summary>Step of a leg, s.</summary>
    private const double TimeStep = 0.08;

    /// <summary>Derivatives are difference quotients over this share of the velocity.</summary>
    private const double Width = 1e-5;

    /// <summary>A leg is at least as fast as this share of the ball, where its time is guessed.</summary>
    private const double LeastShare = 0.3;

    private readonly Simulator _open;
    private readonly Simulator _grounded;
    private readonly StepLog _log = new();
    private readonly BallProperties _ball;
    private readonly double _upward;
    private readonly Vector3d _wind;
    private Vector3d[] _place = [];
    private Vector3d[] _velocity = [];
    private Vector3d[] _spin = [];
    private Vector3d _level;
    private Vector3d _steep;

    /// <param name="scene">The scene whose air, ball and ground they are.</param>
    public BankShotLegs(Scene scene)
    {
        Scene empty = AimContext.WithoutThings(scene);
        _grounded = new Simulator(empty);
        _open = new Simulator(AimContext.WithoutGround(empty));
        _ball = scene.Ball;
        _upward = Weight.UpwardAcceleration(scene);
        _wind = scene.Air.Wind;
    }

    /// <summary>How many contacts there are.</summary>
    public int Count { get; private set; }

    /// <summary>How many numbers may be changed: two of the kick, two of every contact.</summary>
    public int Unknowns => 2 * (Count + 1);

    /// <summary>What is touched but for the ground, in order.</summary>
    public BankShotContact[] Contacts { get; private set; } = [];

    /// <summary>How often a leg meets the ground.</summary>
    public int[] Bounces { get; private set; } = [];

    /// <summary>How long a leg goes on after that, s; 0 for as long as seems right.</summary>
    public double[] Times { get; private set; } = [];

    /// <summary>The gaps at the ends of the legs, two numbers each, across the way, m.</summary>
    public double[] Gaps { get; private set; } = [];

    /// <summary>How they change with what is unknown, row by row.</summary>
    public double[] Rows { get; private set; } = [];

    /// <summary>How much later a leg would be at its end, s.</summary>
    public double[] Late { get; private set; } = [];

    /// <summary>How that changes with what is unknown, row by row.</summary>
    public double[] LateBy { get; private set; } = [];

    /// <summary>The widest gap, along the way too, m.</summary>
    public double Gap { get; private set; }

    /// <summary>The kick.</summary>
    public Kick Kick { get; set; }

    /// <summary>Makes room for a number of contacts.</summary>
    public void Prepare(int count)
    {
        Count = count;
        if (Bounces.Length > count)
        {
            return;
        }

        Contacts = new BankShotContact[count];
        Bounces = new int[count + 1];
        Times = new double[count + 1];
        Late = new double[count + 1];
        LateBy = new double[(count + 1) * Unknowns];
        Gaps = new double[Unknowns];
        Rows = new double[Unknowns * Unknowns];
        _place = new Vector3d[Unknowns];
        _velocity = new Vector3d[Unknowns];
        _spin = new Vector3d[Unknowns];
    }

    /// <summary>Flies all legs; then the gaps are known, and where that is measured, how they change with every unknown.</summary>
    /// <returns>False where a leg leads away from what it is to touch.</returns>
    public bool Fly(AimRequest request, in TargetFrame frame, bool measures, BankShotFlight counts)
    {
        // Leg by leg: flown to about its end, the gap there taken, its derivatives with it, then the impact at the place that was assumed; the next begins there.
        counts.Simulations += measures ? 1 + Unknowns : 1;
        Kick.Vectors(request.Speed, frame.Forward, out Vector3d v, out Vector3d w);
        if (measures)
        {
            Array.Clear(Rows, 0, Rows.Length);
            Array.Clear(LateBy, 0, LateBy.Length);
            Array.Clear(_place, 0, _place.Length);
            Array.Clear(_velocity, 0, _velocity.Length);
            Array.Clear(_spin, 0, _spin.Length);
            Kick.Turns(request.Speed, frame.Forward, out _velocity[0], out _velocity[1], out _spin[1]);
        }

        Vector3d p = frame.From;
        double time = 0;
        Gap = 0;
        for (int leg = 0; ; leg++)
        {
            bool isLast = leg == Count;
            Vector3d end = isLast ? frame.Target : Contacts[leg].Place;
            if (!Flown(leg, in p, in v, in w, time, in end, out BallState state))
            {
                return false;
            }

            Arrive(leg, in state, in end);
            if (measures && !Measure(leg, in p, in v, in w, time, in state))
            {
                return false;
            }

            if (isLast)
            {
                return !double.IsNaN(Gap);
            }

            time = state.Time + Late[leg];
            v = state.Velocity + (Late[leg] * Acceleration(in state));
            w = state.Spin;
            if (!Bounce(leg, ref v, ref w, measures))
            {
                return false;
            }

            p = end;
        }
    }

    /// <summary>Flies a leg: over its bounces, and for its time after them.</summary>
    /// <returns>False where the ball does not bounce that often.</returns>
    private bool Flown(int leg, in Vector3d p, in Vector3d v, in Vector3d w, double time, in Vector3d end, out BallState state)
    {
        Simulator simulator = Bounces[leg] > 0 ? _grounded : _open;
        state = simulator.LaunchAt(in p, in v, in w, time);
        _log.Clear();
        for (int i = 0; i < Bounces[leg]; i++)
        {
            if (!_grounded.Run(ref state, TimeStep, LongestLeg, StopAt.Impact, _log, null) || state.Motion != MotionState.Airborne)
            {
                return false;
            }
        }

        if (Bounces[leg] > 0)
        {
            state = _open.LaunchAt(state.Position, state.Velocity, state.Spin, state.Time);
        }

        if (!(Times[leg] > 0))
        {
            // Straight on, and as far as it is; sideways or away, as if a part of the speed led there.
            Vector3d way = end - state.Position;
            double length = way.Length;
            double along = Vector3d.Dot(in way, state.Velocity) / length;
            Times[leg] = Math.Min(LongestLeg, Math.Max(ShortestLeg, length / Math.Max(along, LeastShare * state.Velocity.Length)));
        }

        _open.Run(ref state, TimeStep, Times[leg], StopAt.Time, _log, null);
        return true;
    }

    /// <summary>The gap at the end of a leg across the way, and how late it is there.</summary>
    private void Arrive(int leg, in BallState state, in Vector3d end)
    {
        Vector3d v = state.Velocity;
        double perSquare = 1.0 / v.LengthSquared;
        BankShotContact.Axes(v * Math.Sqrt(perSquare), out _level, out _steep);
        Vector3d e = state.Position - end;
        Gaps[2 * leg] = Vector3d.Dot(in e, in _level);
        Gaps[(2 * leg) + 1] = Vector3d.Dot(in e, in _steep);

        // The leg ends at the plane across the way through its end: τ = −e·v/v².
        double most = 0.5 * Times[leg];
        Late[leg] = Math.Min(most, Math.Max(-most, -Vector3d.Dot(in e, in v) * perSquare));
        Gap = Math.Max(Gap, e.Length);
    }

    /// <summary>How the gap, the time and the motion at the end of a leg change with what is unknown: by flights a little changed.</summary>
    private bool Measure(int leg, in Vector3d p, in Vector3d v, in Vector3d w, double time, in BallState state)
    {
        // What comes before moves start, velocity and spin of the leg together: one flight beside it for each number. The leg's own place moves its end alone.
        int known = 2 * (leg + 1);
        Vector3d a = Acceleration(in state);
        double speed = v.Length;
        double perSquare = 1.0 / state.Velocity.LengthSquared;
        int last = leg == Count ? known : known + 2;
        for (int j = 0; j < last; j++)
        {
            Vector3d moved;
            if (j < known)
            {
                double size = (_velocity[j].Length + (_ball.Radius * _spin[j].Length) + (_place[j].Length / Times[leg])) / speed;
                double width = size > 0 ? Width / size : 0;
                double perWidth = size > 0 ? size / Width : 0;
                if (!Flown(leg, p + (width * _place[j]), v + (width * _velocity[j]), w + (width * _spin[j]), time, Vector3d.Zero, out BallState other))
                {
                    return false;
                }

                moved = perWidth * (other.Position - state.Position);
                _velocity[j] = perWidth * (other.Velocity - state.Velocity);
                _spin[j] = perWidth * (other.Spin - state.Spin);
            }
            else
            {
                moved = j == known ? -Contacts[leg].Level : -Contacts[leg].Steep;
            }

            Rows[(2 * leg * Unknowns) + j] = Vector3d.Dot(in moved, in _level);
            Rows[(((2 * leg) + 1) * Unknowns) + j] = Vector3d.Dot(in moved, in _steep);
            double late = -Vector3d.Dot(in moved, state.Velocity) * perSquare;
            LateBy[(leg * Unknowns) + j] = late;
            _velocity[j] += late * a;
        }

        return true;
    }

    /// <summary>What the impact at the end of a leg does to the motion, and to its derivatives: those by difference quotients.</summary>
    /// <returns>False where the ball comes from inside.</returns>
    private bool Bounce(int leg, ref Vector3d v, ref Vector3d w, bool measures)
    {
        ref BankShotContact contact = ref Contacts[leg];
        Vector3d n = contact.Normal;
        if (!(Vector3d.Dot(in v, in n) < 0))
        {
            return false;
        }

        // The law of the impact, and its derivatives by velocity, spin and the turn of the normal.
        ref readonly ContactMaterial material = ref contact.Thing.MaterialAt(in contact.Place);
        Vector3d surface = contact.Thing.SurfaceVelocity(contact.Place - (_ball.Radius * n), 0);
        CoulombImpact.Apply(_ball, in material, in n, in surface, in v, in w, out Vector3d velocity, out Vector3d spin);
        int own = 2 * (leg + 1);
        double speed = v.Length;
        for (int j = 0; measures && j < own + 2; j++)
        {
            Vector3d place = j < own ? Vector3d.Zero : j == own ? contact.Level : contact.Steep;
            Vector3d turn = contact.Curvature * place;
            double size = ((_velocity[j].Length + (_ball.Radius * _spin[j].Length)) / speed) + turn.Length;
            double width = size > 0 ? Width / size : 0;
            double perWidth = size > 0 ? size / Width : 0;
            Vector3d turned = n + (width * turn);
            CoulombImpact.Apply(_ball, in material, in turned, in surface, v + (width * _velocity[j]), w + (width * _spin[j]), out Vector3d otherVelocity, out Vector3d otherSpin);
            _place[j] = place;
            _velocity[j] = perWidth * (otherVelocity - velocity);
            _spin[j] = perWidth * (otherSpin - spin);
        }

        v = velocity;
        w = spin;
        return true;
    }

    /// <summary>v̇ of a ball in flight: weight, drag and lift.</summary>
    private Vector3d Acceleration(in BallState state)
    {
        Vector3d air = state.Velocity - _wind;
        Vector3d w = state.Spin;
        double rate = w.Length;
        _open.AirFactors(air.Length, rate, out double drag, out double lift);
        Vector3d a = new Vector3d(0, _upward, 0) - (drag * air);
        return rate > 0 ? a + (lift / rate * Vector3d.Cross(in w, in air)) : a;
    }
}

/// <summary>A place at which the ball is to touch something: of its centre, on the surface that lies a radius off the thing. It moves along that surface by two numbers.</summary>
internal struct BankShotContact
{
    /// <summary>A place is put back onto a surface that is curved in so many steps.</summary>
    private const int MostRaises = 8;

    /// <summary>What is touched.</summary>
    public Collider Thing;

    /// <summary>Centre of the ball, m.</summary>
    public Vector3d Place;

    /// <summary>Normal of the thing there.</summary>
    public Vector3d Normal;

    /// <summary>How the normal turns with the place, 1/m.</summary>
    public SymmetricMatrix3d Curvature;

    /// <summary>The directions along the surface: level, and as steep as it gets.</summary>
    public Vector3d Level;
    public Vector3d Steep;

    /// <summary>Goes to the place on the surface nearest to one.</summary>
    public void GoTo(in Vector3d near, double radius)
    {
        Place = near;
        ShapePoint at = Thing.At(in Place);
        for (int i = 0; i < MostRaises && Math.Abs(at.Distance - radius) > 1e-12; i++)
        {
            Place += (radius - at.Distance) * at.Normal;
            at = Thing.At(in Place);
        }

        Normal = at.Normal;
        Curvature = at.Curvature;
        Axes(in Normal, out Level, out Steep);
    }

    /// <summary>Two directions across a third one, of which the first is level.</summary>
    public static void Axes(in Vector3d direction, out Vector3d level, out Vector3d steep)
    {
        var flat = new Vector3d(direction.Z, 0, -direction.X);
        double size = flat.Length;
        level = size > 1e-9 ? flat / size : new Vector3d(1, 0, 0);
        steep = Vector3d.Cross(in direction, in level);
    }
}
