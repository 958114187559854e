namespace FootballPhysics.Labs.Verdicts;

/// <summary>The fault of a simulated track.</summary>
internal enum TrackFault
{
    None,
    Clock,
    Turned,
    Lines,
    Held,
    DragLaw,
    Heights,
    Rate,
}

/// <summary>
/// A simulated match by an integrator of its own: nothing of the library computes it. A football by the measured laws, or by other laws of drag and bounce;
/// then the track as a tracker writes it, with a fault or without.
/// </summary>
internal sealed class VerdictMatch
{
    private const double Mass = 0.43;
    private const double Radius = 0.11;
    private const double Alpha = 2.0 / 3;
    private const double Gravity = 9.81;
    private const double Density = 1.2;
    private const double Viscosity = 1.5e-5;
    private const double Step = 0.004;
    private const double BetweenKicks = 2.8;

    /// <summary>The states of the truth per second.</summary>
    private const int Rate = 250;

    private readonly SeededRandom _random;
    private readonly List<double[]> _states = [];
    private Func<double, (double Slow, double Drag)> _drag = Measured;
    private double _restitution = 0.622;
    private double _friction = 1.2;
    private double _windX;
    private double _windZ;

    private VerdictMatch(SeededRandom random) => _random = random;

    /// <summary>The wind, in m/s.</summary>
    public Vector3d Wind => new(_windX, 0, _windZ);

    /// <summary>The fault.</summary>
    public TrackFault Fault { get; private init; }

    /// <summary>True if drag and bounce are not the library's.</summary>
    public bool IsForeign { get; private init; }

    /// <summary>The standard deviation of a coordinate, in m.</summary>
    public double Noise { get; private set; }

    /// <summary>The points of the tracker, with y up.</summary>
    public TrackPoint[] Track { get; private set; } = [];

    /// <summary>The seconds that the track's clock counts in one second.</summary>
    public double Clock { get; private set; } = 1;

    /// <summary>The factor of the heights.</summary>
    public double HeightFactor { get; private set; } = 1;

    /// <summary>The time from which the positions are turned by half a turn; infinite if never.</summary>
    public double TurnedFrom { get; private set; } = double.PositiveInfinity;

    /// <summary>Plays a match. Every second one has a fault, and every third one other laws of drag and bounce.</summary>
    public static VerdictMatch Play(SeededRandom random, int number)
    {
        TrackFault fault = number % 2 == 0 ? TrackFault.None : (TrackFault)(1 + (number / 2 % 7));
        var match = new VerdictMatch(random) { Fault = fault, IsForeign = number % 3 == 2 };
        match.Play();
        match.See();
        return match;
    }

    /// <summary>
    /// Returns the errors of a flight's velocity and spin at its start, in the clock and the frame of the track. The truth a tenth of a second later, which is
    /// surely in the same flight, is traced back by the true laws; null if the track does not reach so far.
    /// </summary>
    public double[]? Errors(MatchPiece flight)
    {
        double from = flight.StartTime / Clock;
        int at = (int)Math.Ceiling((from + 0.1) * Rate);
        if (at + (Rate / 12) >= _states.Count)
        {
            return null;
        }

        double turn = flight.StartTime >= TurnedFrom ? -1 : 1;
        Vector3d v = flight.Velocity * Clock;
        double[] state = [0, 100, 0, turn * v.X, v.Y / HeightFactor, turn * v.Z, turn * flight.Spin.X * Clock, flight.Spin.Y * Clock, turn * flight.Spin.Z * Clock];
        double late = ((double)at / Rate) - from;
        double[] truth = (double[])_states[at].Clone();
        truth[1] = 100;
        for (int i = 0; i < 20; i++)
        {
            truth = Fly(truth, -late / 20);
        }

        double[] off = new double[6];
        for (int k = 0; k < 6; k++)
        {
            off[k] = (state[3 + k] - truth[3 + k]) / Clock * (k == 1 ? HeightFactor : 1);
        }

        return off;
    }

    /// <summary>The drag coefficient that the library uses for its generic ball.</summary>
    private static (double Slow, double Drag) Measured(double reynolds)
    {
        double slow = Sigma((reynolds - 1.86e5) / 1.7e4);
        return (slow, ((0.49 - 0.155) * slow) + 0.155 + ((reynolds - 2.3e5) * Sigma((2.3e5 - reynolds) / 1.7e4) * 0.03 / 2.8e5));
    }

    private static double Sigma(double x) => 0.5 * (1 - Math.Tanh(0.5 * x));

    private static Func<double, (double Slow, double Drag)> Falling(double low, double high, double before, double after) => reynolds =>
    {
        double slow = Math.Clamp((high - (reynolds * Viscosity / (2 * Radius))) / (high - low), 0, 1);
        return (slow, after + ((before - after) * slow));
    };

    private void Play()
    {
        if (IsForeign)
        {
            double low = _random.Uniform(6, 11);
            _drag = Falling(low, low + _random.Uniform(3, 7), _random.Uniform(0.42, 0.5), _random.Uniform(0.14, 0.22));
            _restitution = _random.Uniform(0.5, 0.75);
            _friction = _random.Uniform(0.3, 1.2);
        }

        if (Fault == TrackFault.DragLaw)
        {
            double low = _random.Uniform(10, 16);
            double constant = _random.Uniform(0.12, 0.5);
            _drag = _random.Chance(0.5) ? Falling(low, low + _random.Uniform(2, 10), _random.Uniform(0.4, 0.6), _random.Uniform(0.08, 0.25)) : _ => (0.5, constant);
        }

        (_windX, _windZ) = (Normal(1.5), Normal(1.5));
        int kicks = 7 + _random.Below(6);
        double[] state = [_random.Uniform(-20, 20), Radius, _random.Uniform(-15, 15), 0, 0, 0, 0, 0, 0];
        int steps = (int)(kicks * BetweenKicks * Rate);
        double next = 0.2;
        for (int i = 0; i < steps; i++)
        {
            if ((double)i / Rate >= next)
            {
                Kick(state);
                next += BetweenKicks + _random.Uniform(-0.6, 0.6);
            }

            _states.Add(state);
            state = Advance((double[])state.Clone(), Step);
        }
    }

    private void Kick(double[] state)
    {
        double speed = _random.Uniform(11, 26);
        double elevation = _random.Uniform(12, 45) * Math.PI / 180;
        double heading = Math.Atan2(-state[2] + _random.Uniform(-10, 10), -state[0] + _random.Uniform(-15, 15)) + _random.Uniform(-0.5, 0.5);
        (state[3], state[4], state[5]) = (speed * Math.Cos(elevation) * Math.Cos(heading), speed * Math.Sin(elevation), speed * Math.Cos(elevation) * Math.Sin(heading));
        (state[6], state[7], state[8]) = (Normal(22), Normal(22), Normal(22));
    }

    private void See()
    {
        int rate = _random.Any(25, 50);
        Noise = _random.Log(0.002, 0.03);
        double length = _states.Count / (double)Rate;
        Clock = Fault == TrackFault.Clock ? 1 + (Sign() * _random.Uniform(0.02, 0.1)) : Fault == TrackFault.Rate ? _random.Any(25.0 / 30, 30.0 / 25, 24.0 / 25, 25.0 / 24, 0.5, 2) : 1;
        HeightFactor = Fault == TrackFault.Heights ? 1 + (Sign() * _random.Uniform(0.02, 0.1)) : 1;
        TurnedFrom = Fault == TrackFault.Turned ? Math.Round(length / 2) : double.PositiveInfinity;
        var points = new List<TrackPoint>();
        int stride = Rate / rate;
        for (int i = 0; i < _states.Count; i += stride)
        {
            double time = i / (double)Rate;
            double turn = time >= TurnedFrom ? -1 : 1;
            double[] state = _states[i];
            points.Add(new TrackPoint(
                Round(time * Clock), new Vector3d(Round((turn * state[0]) + Normal(Noise)), Round((HeightFactor * state[1]) + Normal(Noise)), Round((turn * state[2]) + Normal(Noise))), 1e-4));
        }

        if (Fault is TrackFault.Lines or TrackFault.Held)
        {
            Fill(points, rate);
        }

        Track = [.. points];
    }

    /// <summary>Fills the gaps of a second each by straight lines, or by the last point.</summary>
    private void Fill(List<TrackPoint> points, int rate)
    {
        double share = _random.Uniform(0.12, 0.4);
        double every = _random.Uniform(0.8, 2);
        int last = 0;
        bool IsGone(int i) => i > 0 && i < points.Count - 1 && (double)i / rate % every < share;
        for (int i = 1; i < points.Count; i++)
        {
            if (IsGone(i))
            {
                continue;
            }

            for (int k = last + 1; k < i; k++)
            {
                double part = (double)(k - last) / (i - last);
                Vector3d place = Fault == TrackFault.Held ? points[last].Position : points[last].Position + (part * (points[i].Position - points[last].Position));
                points[k] = new TrackPoint(points[k].Time, new Vector3d(Round(place.X), Round(place.Y), Round(place.Z)), 1e-4);
            }

            last = i;
        }
    }

    private double[] Advance(double[] state, double dt)
    {
        if (state[1] <= Radius + 1e-9 && Math.Abs(state[4]) < 0.3)
        {
            double speed = Math.Sqrt((state[3] * state[3]) + (state[5] * state[5]));
            double kept = speed > 0 ? Math.Max(0, speed - (0.7 * dt)) / speed : 0;
            return [state[0] + (dt * kept * state[3]), Radius, state[2] + (dt * kept * state[5]), kept * state[3], 0, kept * state[5], kept * state[5] / Radius, state[7], -kept * state[3] / Radius];
        }

        double[] next = Fly(state, dt);
        if (next[1] >= Radius || next[4] >= 0)
        {
            return next;
        }

        double low = 0;
        double high = dt;
        for (int i = 0; i < 40; i++)
        {
            double middle = 0.5 * (low + high);
            (low, high) = Fly(state, middle)[1] > Radius ? (middle, high) : (low, middle);
        }

        next = Fly(state, high);
        next[1] = Radius;
        Bounce(next);
        return next[4] < 0.3 ? next : Fly(next, dt - high);
    }

    private double[] Fly(double[] s, double h)
    {
        double[] a = Rates(s);
        double[] b = Rates(At(s, a, h / 2));
        double[] c = Rates(At(s, b, h / 2));
        double[] d = Rates(At(s, c, h));
        double[] next = new double[9];
        for (int i = 0; i < 9; i++)
        {
            next[i] = s[i] + (h / 6 * (a[i] + (2 * b[i]) + (2 * c[i]) + d[i]));
        }

        return next;
    }

    private static double[] At(double[] s, double[] rates, double h)
    {
        double[] next = new double[9];
        for (int i = 0; i < 9; i++)
        {
            next[i] = s[i] + (h * rates[i]);
        }

        return next;
    }

    private double[] Rates(double[] s)
    {
        var u = new Vector3d(s[3] - _windX, s[4], s[5] - _windZ);
        var w = new Vector3d(s[6], s[7], s[8]);
        double speed = u.Length;
        double area = Math.PI * Radius * Radius;
        double decay = (0.0096 * Math.PI * Density * Radius * Radius / (Alpha * Mass) * speed) + 0.004;
        double rise = (4.0 / 3 * Math.PI * Radius * Radius * Radius * Density * Gravity / Mass) - Gravity;
        Vector3d air = Vector3d.Zero;
        if (speed > 1e-9)
        {
            Vector3d cross = Vector3d.Cross(in w, in u);
            double across = cross.Length / speed;
            double turn = Radius * across / speed;
            (double slow, double drag) = _drag(2 * Radius * speed / Viscosity);
            drag += 0.30 * turn / Math.Sqrt((turn * turn) + (0.577 * 0.577)) * (1 - (0.5 * slow));
            double lift = 0.32 * turn / Math.Sqrt((turn * turn) + (0.14 * 0.14)) * (1 - (0.6 * slow));
            double k = 0.5 * Density * area / Mass;
            air = (-k * drag * speed * u) + (across > 0 ? k * lift * speed / across * cross : Vector3d.Zero);
        }

        return [s[3], s[4], s[5], air.X, air.Y + rise, air.Z, -decay * s[6], -decay * s[7], -decay * s[8]];
    }

    private void Bounce(double[] s)
    {
        double down = -s[4];
        double e = _restitution * Math.Sqrt(1 + (6 / 30.0 * (6 / 30.0))) / Math.Sqrt(1 + (down / 30 * (down / 30)));
        double x = s[3] + (Radius * s[8]);
        double z = s[5] - (Radius * s[6]);
        double slip = Math.Sqrt((x * x) + (z * z));
        double j = Math.Min(_friction * (1 + e) * down, Alpha / (1 + Alpha) * 1.2 * slip);
        (double jx, double jz) = slip > 0 ? (j * x / slip, j * z / slip) : (0, 0);
        s[4] = e * down;
        s[3] -= jx;
        s[5] -= jz;
        s[6] += jz / (Alpha * Radius);
        s[8] -= jx / (Alpha * Radius);
        double lost = Math.Min(Math.Abs(s[7]), 0.020 * 0.5 * (1 + e) * down / (Alpha * Radius * Radius));
        s[7] -= Math.CopySign(lost, s[7]);
    }

    private int Sign() => _random.Chance(0.5) ? 1 : -1;

    private double Normal(double deviation) => deviation * Math.Sqrt(-2 * Math.Log(1 - _random.Next())) * Math.Cos(2 * Math.PI * _random.Next());

    private static double Round(double value) => Math.Round(value, 4);
}
