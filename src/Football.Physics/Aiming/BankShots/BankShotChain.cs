namespace Football.Physics;

/// <summary>
/// A kick in legs, each from one contact to the next and the last to the target, flown among nothing but the ground, and that only where it is to be met: multiple
/// shooting. What is sought are the kick's elevation and azimuth and two numbers for the place of each contact, such that every leg ends where the next begins; what an
/// impact does is known in closed form.
/// </summary>
/// <remarks>
/// The kicks that meet a post are a hair's breadth of elevations and azimuths, and a post's whole side of places: in these unknowns Newton's method comes from far. How
/// the ends of the legs move is measured by flying them a little changed, and kept by Broyden's updates, row by row for what each depends on (Schubert), as long as
/// that gets closer.
/// </remarks>
internal sealed class BankShotChain
{
    /// <summary>Step of a leg, s.</summary>
    private const double TimeStep = 0.08;

    private const int MostSteps = 16;

    /// <summary>A step that leads to no smaller gap is shortened so often, to this share of it.</summary>
    private const int MostTries = 5;
    private const double Shorter = 0.35;

    /// <summary>A gap that is not this much smaller after a step calls for new derivatives.</summary>
    private const double Progress = 0.25;

    /// <summary>Derivatives are difference quotients over this share of the velocity.</summary>
    private const double Width = 1e-5;

    /// <summary>What a radian of the kick is worth in metres of a contact: for Broyden's updates.</summary>
    private const double MetresPerRadian = 10;

    /// <summary>A chain whose gaps are all below this is closed by one more step, m.</summary>
    private const double Closed = 3e-3;

    /// <summary>The most that a step turns the kick, or the normal of a contact, rad; and moves a contact, m, and of the length of the leg to it.</summary>
    private const double LargestTurn = 0.3;
    private const double LargestBend = 0.6;
    private const double LargestShare = 0.5;

    /// <summary>The time of a leg changes by this factor at most.</summary>
    private const double LargestChange = 2;

    /// <summary>A leg takes no less time, and no more, s.</summary>
    private const double ShortestLeg = 1e-4;
    private const double LongestLeg = 8;

    private readonly Simulator _open;
    private readonly Simulator _grounded;
    private readonly StepLog _log = new();
    private readonly BallProperties _ball;
    private readonly double _upward;
    private readonly Vector3d _wind;
    private double[] _times = [];
    private double[] _savedTimes = [];
    private double[] _late = [];
    private double[] _lateBy = [];
    private double[] _gaps = [];
    private double[] _before = [];
    private double[] _rows = [];
    private double[] _system = [];
    private double[] _step = [];
    private Vector3d[] _place = [];
    private Vector3d[] _velocity = [];
    private Vector3d[] _spin = [];
    private BankShotContact[] _savedContacts = [];
    private Kick _savedKick;
    private double _gap;
    private Vector3d _level;
    private Vector3d _steep;

    /// <param name="scene">The scene whose air it is.</param>
    public BankShotChain(Scene scene)
    {
        Scene empty = AimContext.WithoutThings(scene);
        _grounded = new Simulator(empty);
        _open = new Simulator(AimContext.WithoutGround(empty));
        _ball = scene.Ball;
        _upward = Weight.UpwardAcceleration(scene);
        _wind = scene.Air.Wind;
    }

    /// <summary>What is touched but for the ground, in order.</summary>
    public BankShotContact[] Contacts { get; private set; } = [];

    /// <summary>How often a leg meets the ground.</summary>
    public int[] Bounces { get; private set; } = [];

    /// <summary>How many of them there are.</summary>
    public int Count { get; private set; }

    /// <summary>The kick.</summary>
    public Kick Kick;

    /// <summary>Makes room for a number of contacts.</summary>
    public void Prepare(int count)
    {
        Count = count;
        if (Bounces.Length > count)
        {
            return;
        }

        int unknowns = 2 * (count + 1);
        Contacts = new BankShotContact[count];
        Bounces = new int[count + 1];
        _times = new double[count + 1];
        _savedTimes = new double[count + 1];
        _savedContacts = new BankShotContact[count];
        _late = new double[count + 1];
        _lateBy = new double[(count + 1) * unknowns];
        _gaps = new double[unknowns];
        _before = new double[unknowns];
        _rows = new double[unknowns * unknowns];
        _system = new double[unknowns * (unknowns + 1)];
        _step = new double[unknowns];
        _place = new Vector3d[unknowns];
        _velocity = new Vector3d[unknowns];
        _spin = new Vector3d[unknowns];
    }

    /// <summary>Closes the chain by Newton's method from where its contacts and its kick are.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="counts">Where flights and corrections are counted.</param>
    /// <returns>False where it does not come together.</returns>
    public bool Close(AimRequest request, in TargetFrame frame, BankShotFlight counts)
    {
        Array.Clear(_times, 0, Count + 1);
        bool isFresh = true;
        if (!Fly(request, in frame, measures: true, counts))
        {
            return false;
        }

        for (int i = 0; i < Math.Min(MostSteps, request.MaximumIterations); i++)
        {
            counts.Iterations++;
            if (!Solve())
            {
                return false;
            }

            double last = _gap;
            Array.Copy(_gaps, _before, _gaps.Length);
            Save();
            bool better = false;
            for (int tries = 0; tries < (isFresh ? MostTries : 1) && !better; tries++)
            {
                Restore();
                better = Take(tries == 0 ? 1.0 : Shorter, request.Speed) && Fly(request, in frame, measures: false, counts) && _gap < last;
            }

            if (!better && isFresh)
            {
                return false;
            }

            if (better && _gap < Closed)
            {
                // The last step is not flown.
                Update();
                return Solve() && Take(1.0, request.Speed);
            }

            if (better && _gap < Progress * last)
            {
                Update();
                isFresh = false;
                continue;
            }

            if (!better)
            {
                Restore();
            }

            isFresh = true;
            if (!Fly(request, in frame, measures: true, counts))
            {
                return false;
            }
        }

        return false;
    }

    /// <summary>The turn that takes away a miss of the whole kick at the target, by the derivatives of the last flight.</summary>
    /// <param name="miss">The miss, m.</param>
    /// <param name="up">By elevation, rad.</param>
    /// <param name="aside">By azimuth, rad.</param>
    public bool Correct(in Vector3d miss, out double up, out double aside)
    {
        Array.Clear(_gaps, 0, 2 * Count);
        _gaps[2 * Count] = Vector3d.Dot(in miss, in _level);
        _gaps[(2 * Count) + 1] = Vector3d.Dot(in miss, in _steep);
        bool solved = Solve();
        up = _step[0];
        aside = _step[1];
        return solved && !double.IsNaN(up + aside) && Math.Abs(up) + Math.Abs(aside) < LargestTurn;
    }

    /// <summary>Flies all legs; then the gaps are known, and where that is measured, how they change with every unknown.</summary>
    /// <returns>False where a leg leads away from what it is to touch.</returns>
    private bool Fly(AimRequest request, in TargetFrame frame, bool measures, BankShotFlight counts)
    {
        counts.Simulations += measures ? 1 + (2 * (Count + 1)) : 1;
        Kick.Vectors(request.Speed, frame.Forward, out Vector3d v, out Vector3d w);
        if (measures)
        {
            Array.Clear(_rows, 0, _rows.Length);
            Array.Clear(_lateBy, 0, _lateBy.Length);
            Array.Clear(_place, 0, _place.Length);
            Array.Clear(_velocity, 0, _velocity.Length);
            Array.Clear(_spin, 0, _spin.Length);
            Kick.Turns(request.Speed, frame.Forward, out _velocity[0], out _velocity[1], out _spin[1]);
        }

        Vector3d p = frame.From;
        double time = 0;
        _gap = 0;
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
                return !double.IsNaN(_gap);
            }

            time = state.Time + _late[leg];
            v = state.Velocity + (_late[leg] * Acceleration(in state));
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

        if (!(_times[leg] > 0))
        {
            // Straight on, and as far as it is; sideways or away, as if a part of the speed led there.
            Vector3d way = end - state.Position;
            double length = way.Length;
            double along = Vector3d.Dot(in way, state.Velocity) / length;
            _times[leg] = Math.Min(LongestLeg, Math.Max(ShortestLeg, length / Math.Max(along, 0.3 * state.Velocity.Length)));
        }

        _open.Run(ref state, TimeStep, _times[leg], StopAt.Time, _log, null);
        return true;
    }

    /// <summary>The gap at the end of a leg across the way, and how late it is there.</summary>
    private void Arrive(int leg, in BallState state, in Vector3d end)
    {
        Vector3d v = state.Velocity;
        double perSquare = 1.0 / v.LengthSquared;
        BankShotContact.Axes(v * Math.Sqrt(perSquare), out _level, out _steep);
        Vector3d e = state.Position - end;
        _gaps[2 * leg] = Vector3d.Dot(in e, in _level);
        _gaps[(2 * leg) + 1] = Vector3d.Dot(in e, in _steep);

        // The leg ends at the plane across the way through its end: τ = −e·v/v².
        double most = 0.5 * _times[leg];
        _late[leg] = Math.Min(most, Math.Max(-most, -Vector3d.Dot(in e, in v) * perSquare));
        _gap = Math.Max(_gap, e.Length);
    }

    /// <summary>How the gap, the time and the motion at the end of a leg change with what is unknown: by flights a little changed.</summary>
    private bool Measure(int leg, in Vector3d p, in Vector3d v, in Vector3d w, double time, in BallState state)
    {
        int unknowns = 2 * (Count + 1);
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
                double size = (_velocity[j].Length + (_ball.Radius * _spin[j].Length)) / speed + (_place[j].Length / (_times[leg] * speed));
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

            _rows[(2 * leg * unknowns) + j] = Vector3d.Dot(in moved, in _level);
            _rows[(((2 * leg) + 1) * unknowns) + j] = Vector3d.Dot(in moved, in _steep);
            double late = -Vector3d.Dot(in moved, state.Velocity) * perSquare;
            _lateBy[(leg * unknowns) + j] = late;
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

        ref readonly ContactMaterial material = ref contact.Thing.MaterialAt(in contact.Place);
        Vector3d surface = contact.Thing.SurfaceVelocity(contact.Place - (_ball.Radius * n), 0);
        CoulombImpact.Apply(_ball, in material, in n, in surface, in v, in w, out Vector3d velocity, out Vector3d spin);
        int own = 2 * (leg + 1);
        double speed = v.Length;
        for (int j = 0; measures && j < own + 2; j++)
        {
            Vector3d place = j < own ? Vector3d.Zero : j == own ? contact.Level : contact.Steep;
            Vector3d turn = contact.Curvature * place;
            double size = (_velocity[j].Length / speed) + (_ball.Radius * _spin[j].Length / speed) + turn.Length;
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

    /// <summary>Broyden's update of the derivatives by what the last step did, row by row: J ← J + (Δg − J s) sᵀ/sᵀs, of s what the row depends on.</summary>
    private void Update()
    {
        int n = 2 * (Count + 1);
        for (int row = 0; row < n; row++)
        {
            int last = Math.Min(n, (row & ~1) + 4);
            double off = _gaps[row] - _before[row];
            double square = 0;
            for (int j = 0; j < last; j++)
            {
                off -= _rows[(row * n) + j] * _step[j];
                square += Weight(j) * _step[j] * _step[j];
            }

            for (int j = 0; j < last && square > 0; j++)
            {
                _rows[(row * n) + j] += off * Weight(j) * _step[j] / square;
            }
        }

        static double Weight(int unknown) => unknown < 2 ? MetresPerRadian * MetresPerRadian : 1.0;
    }

    /// <summary>Newton's step.</summary>
    private bool Solve()
    {
        int n = 2 * (Count + 1);
        for (int i = 0; i < n; i++)
        {
            Array.Copy(_rows, i * n, _system, i * (n + 1), n);
            _system[(i * (n + 1)) + n] = -_gaps[i];
        }

        return Linear.Solve(_system, _step, n);
    }

    /// <summary>Remembers where the unknowns are.</summary>
    private void Save()
    {
        _savedKick = Kick;
        Array.Copy(_times, _savedTimes, _times.Length);
        Array.Copy(Contacts, _savedContacts, Contacts.Length);
    }

    /// <summary>Goes back there.</summary>
    private void Restore()
    {
        Kick = _savedKick;
        Array.Copy(_savedTimes, _times, _times.Length);
        Array.Copy(_savedContacts, Contacts, Contacts.Length);
    }

    /// <summary>Takes a share of the step, or what of it is not too large; the step is then that.</summary>
    private bool Take(double most, double speed)
    {
        int unknowns = 2 * (Count + 1);
        double share = most / Math.Max(1.0, most * Math.Sqrt((_step[0] * _step[0]) + (_step[1] * _step[1])) / LargestTurn);
        for (int i = 0; i < Count; i++)
        {
            ref BankShotContact contact = ref Contacts[i];
            Vector3d move = Move(i);
            double bend = (contact.Curvature * move).Length;
            double far = move.Length / Math.Max(0.1, _times[i] * speed);
            share = Math.Min(share, most / Math.Max(1.0, most * Math.Max(bend / LargestBend, far / LargestShare)));
        }

        if (double.IsNaN(share))
        {
            return false;
        }

        for (int j = 0; j < unknowns; j++)
        {
            _step[j] *= share;
        }

        for (int leg = 0; leg <= Count; leg++)
        {
            double late = most * _late[leg];
            for (int j = 0; j < unknowns; j++)
            {
                late += _lateBy[(leg * unknowns) + j] * _step[j];
            }

            double shortest = Math.Max(ShortestLeg, _times[leg] / LargestChange);
            double longest = Math.Min(LongestLeg, LargestChange * _times[leg]);
            _times[leg] = Math.Min(longest, Math.Max(shortest, _times[leg] + late));
        }

        Kick.Elevation = Math.Min(0.5 * Math.PI, Math.Max(-0.5 * Math.PI, Kick.Elevation + _step[0]));
        Kick.Azimuth += _step[1];
        for (int i = 0; i < Count; i++)
        {
            Contacts[i].GoTo(Contacts[i].Place + Move(i), _ball.Radius);
        }

        return true;
    }

    private Vector3d Move(int contact) => (_step[(2 * contact) + 2] * Contacts[contact].Level) + (_step[(2 * contact) + 3] * Contacts[contact].Steep);

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
