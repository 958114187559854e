using System.Globalization;

namespace Football.Physics;

/// <summary>Finds one group of kicks after the other, on one thread.</summary>
internal sealed class BatchAimWorker
{
    /// <summary>Step of the flights, s.</summary>
    private const double Step = 0.08;

    private const int MostRounds = 8;

    /// <summary>A miss well below any tolerance worth having, m.</summary>
    private const double FineMiss = 1e-3;

    private const double Degree = Math.PI / 180.0;

    private readonly Scene _scene;
    private readonly Simulator _simulator;
    private readonly Aimer _aimer;
    private readonly AimContext _judge;
    private readonly LaneFlight? _lanes;
    private readonly LaneDomain _domain;
    private readonly LaneGroup _group = new();
    private readonly BatchAimState[] _states = new BatchAimState[LaneGroup.Size];
    private readonly int[] _active = new int[LaneGroup.Size];
    private readonly double _upward;
    private double _lowest;
    private double _highest;

    public BatchAimWorker(Scene scene, int lanes)
    {
        _scene = scene;
        _simulator = new Simulator(scene);
        _aimer = new Aimer(scene);
        _judge = new AimContext(scene, SolverSettings.Default, Step);
        _domain = new LaneDomain(scene, Step);
        _upward = Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
        _lanes = LaneFlight.Covers(scene) ? LaneFlight.Create(scene, fourthOrder: true, Step, lanes, upAlongX: true) : null;
    }

    public int HandedOn { get; private set; }

    public long Flights { get; private set; }

    /// <summary>Prepares for the requests.</summary>
    public void Begin(BatchAims aims)
    {
        HandedOn = 0;
        Flights = 0;
        Elementary.SinCos(aims.MinimumElevation * Degree, out _lowest, out _);
        Elementary.SinCos(aims.MaximumElevation * Degree, out _highest, out _);
    }

    public void Find(BatchAims aims, BatchKicks kicks, int from, int count)
    {
        double tolerance = 0.8 * Math.Min(aims.Tolerance, FineMiss);
        int active = 0;
        double longest = 0;
        for (int i = 0; i < count; i++)
        {
            int index = from + i;
            Refuse(aims, index);
            ref BatchAimState s = ref _states[i];
            if (_lanes is not null && Prepare(aims, index, ref s))
            {
                _active[active++] = i;
                longest = s.Time > longest ? s.Time : longest;
            }
            else
            {
                HandOn(aims, kicks, index);
            }
        }

        // Twice the longest guess, and a little: what has not arrived by then is not on the low arc.
        double duration = (2.0 * longest) + 0.2;
        for (int round = 0; round < MostRounds && active > 0; round++)
        {
            FlyAll(active, duration);
            int left = 0;
            for (int k = 0; k < active; k++)
            {
                int i = _active[k];
                ref BatchAimState s = ref _states[i];
                int outcome = Improve(ref s, i, round, tolerance);
                if (outcome > 0)
                {
                    if (StaysClear(in s))
                    {
                        Write(aims, kicks, from + i, in s);
                    }
                    else
                    {
                        HandOn(aims, kicks, from + i);
                    }
                }
                else if (outcome < 0)
                {
                    HandOn(aims, kicks, from + i);
                }
                else
                {
                    _active[left++] = i;
                }
            }

            active = left;
        }

        for (int k = 0; k < active; k++)
        {
            HandOn(aims, kicks, from + _active[k]);
        }
    }

    /// <summary>The frame of the target, and a start in closed form.</summary>
    /// <returns>False for what is better left to the single aimer.</returns>
    private bool Prepare(BatchAims aims, int index, ref BatchAimState s)
    {
        double contact = _simulator.ContactHeight;
        double fromY = aims.From.Y[index];
        fromY = fromY < contact ? contact : fromY;
        double dx = aims.Target.X[index] - aims.From.X[index];
        double dz = aims.Target.Z[index] - aims.From.Z[index];
        double distance = Math.Sqrt((dx * dx) + (dz * dz));
        double top = aims.TopSpin[index];
        double side = aims.SideSpin[index];
        double speed = aims.Speed[index];
        Vector3d wind = _scene.Air.Wind;
        s = default;
        s.Distance = distance;
        s.Rise = aims.Target.Y[index] - fromY;
        s.Speed = speed;
        s.Top = top;
        s.Side = side;
        s.SpinRate = Math.Sqrt((top * top) + (side * side));
        if (!(distance > 0.1 && distance < 200) || aims.Target.Y[index] < contact)
        {
            return false;
        }

        s.ForwardX = dx / distance;
        s.ForwardZ = dz / distance;
        s.WindForward = (wind.X * s.ForwardX) + (wind.Z * s.ForwardZ);
        s.WindLeft = (wind.X * s.ForwardZ) - (wind.Z * s.ForwardX);
        double most = speed + wind.Length;
        return _domain.Covers(most * most, s.SpinRate, 100, wind.Y, 10) && Guess(ref s);
    }

    /// <summary>
    /// The flight in closed form (<see cref="FlatFire"/>, its damping by rational functions), by iteration on the slant: where the kick must point
    /// so that with fall, bend and wind it comes out at the target.
    /// </summary>
    private bool Guess(ref BatchAimState s)
    {
        double v = s.Speed;
        double slant = Math.Sqrt((s.Distance * s.Distance) + (s.Rise * s.Rise));
        double middle = v / (1.0 + (0.006 * slant));
        _simulator.AirFactors(middle, s.SpinRate, out double drag, out double lift);
        double k = drag / middle;
        double windUp = _scene.Air.Wind.Y;
        double windSquared = _scene.Air.Wind.LengthSquared;
        double df = s.Distance / slant;
        double du = s.Rise / slant;
        double dl = 0;
        double x = v;
        double af = df;
        double au = du;
        double al = dl;
        double t = 0;
        for (int i = 0; i < 4; i++)
        {
            // s = ln(1 + k x t)/k, so x t = s (1 + ks/2 + (ks)²/6 + …)
            double ks = k * slant;
            double tau = ks * (1.0 + (ks * (0.5 + (ks * ((1.0 / 6.0) + (ks * (1.0 / 24.0)))))));
            t = slant / x * (1.0 + (ks * (0.5 + (ks * ((1.0 / 6.0) + (ks * (1.0 / 24.0)))))));
            double fall = _upward * t * t * 0.5 / (1.0 + (tau * (1.0 / 3.0)));
            double bend = lift * x * t * t * 0.5 / (1.0 + (tau * (2.0 / 3.0)));

            // ω = top (ŷ × d) + side ŷ, and ŷ × forward = left; ω̂ × û in (forward, up, left).
            double flat = Math.Sqrt((df * df) + (dl * dl));
            double wf = 0;
            double wu = 0;
            double wl = 0;
            if (s.SpinRate > 0)
            {
                wf = -(s.Top * dl / flat) / s.SpinRate;
                wu = s.Side / s.SpinRate;
                wl = s.Top * df / flat / s.SpinRate;
            }

            double cf = (wu * al) - (wl * au);
            double cu = (wl * af) - (wf * al);
            double cl = (wf * au) - (wu * af);

            double f = s.Distance - (t * s.WindForward) - (bend * -cf);
            double u = s.Rise - (t * windUp) - fall - (bend * -cu);
            double l = -(t * s.WindLeft) - (bend * -cl);
            slant = Math.Sqrt((f * f) + (u * u) + (l * l));
            af = f / slant;
            au = u / slant;
            al = l / slant;
            double along = (af * s.WindForward) + (au * windUp) + (al * s.WindLeft);
            double discriminant = (along * along) + (v * v) - windSquared;
            if (!(discriminant > 0))
            {
                return false;
            }

            x = Math.Sqrt(discriminant) - along;
            if (!(x > 0.1 * v))
            {
                return false;
            }

            df = ((x * af) + s.WindForward) / v;
            du = ((x * au) + windUp) / v;
            dl = ((x * al) + s.WindLeft) / v;
        }

        s.DirectionForward = df;
        s.DirectionUp = du;
        s.DirectionLeft = dl;
        s.Time = t;

        // Steeper than that, the target is near the end of the reach, or beyond.
        return df > 0.5 && t > 0 && t < 8;
    }

    /// <summary>
    /// Flies all active kicks to the vertical planes through their targets. In the lanes x is up, y is backward and z is right, so that a flight ends
    /// where its way along y falls below minus the distance.
    /// </summary>
    private void FlyAll(int active, double duration)
    {
        _group.Clear();
        double windUp = _scene.Air.Wind.Y;
        for (int k = 0; k < active; k++)
        {
            int i = _active[k];
            ref BatchAimState s = ref _states[i];
            double flat = Math.Sqrt((s.DirectionForward * s.DirectionForward) + (s.DirectionLeft * s.DirectionLeft));
            var u = new Vector3d(
                (s.Speed * s.DirectionUp) - windUp,
                s.WindForward - (s.Speed * s.DirectionForward),
                s.WindLeft - (s.Speed * s.DirectionLeft));
            Vector3d axis = Vector3d.Up;
            if (s.SpinRate > 0)
            {
                double across = s.Top / (flat * s.SpinRate);
                axis = new Vector3d(s.Side / s.SpinRate, across * s.DirectionLeft, -(across * s.DirectionForward));
            }

            _group.Add(i, in u, in axis, s.SpinRate, -s.Distance, -s.WindForward);
        }

        Flights += active;
        _lanes!.Fly(_group, duration);
    }

    /// <summary>Reads the crossing off the last flight, and turns the kick by what it asks for.</summary>
    /// <returns>1 when done, −1 when it does not converge, else 0.</returns>
    private int Improve(ref BatchAimState s, int i, int round, double tolerance)
    {
        if (!_group.Reached[i])
        {
            return -1;
        }

        double t = _group.EndTime[i];
        Vector3d path = _group.EndPath[i];
        Vector3d velocity = _group.EndVelocity[i];
        double windUp = _scene.Air.Wind.Y;
        double up = path.X + (t * windUp) - s.Rise;
        double left = (t * s.WindLeft) - path.Z;
        double miss = Math.Sqrt((up * up) + (left * left));
        s.Time = t;
        if (miss <= tolerance)
        {
            s.Miss = miss;
            return 1;
        }

        if (round == 0)
        {
            StartJacobian(ref s, t, up, left, s.WindForward - velocity.Y, velocity.X + windUp, s.WindLeft - velocity.Z);
        }
        else
        {
            if (!(miss < 0.7 * s.Miss))
            {
                return -1;
            }

            // Broyden
            double squared = (s.StepElevation * s.StepElevation) + (s.StepAzimuth * s.StepAzimuth);
            double moreUp = (up - s.Up - (s.UpByElevation * s.StepElevation) - (s.UpByAzimuth * s.StepAzimuth)) / squared;
            double moreLeft = (left - s.Left - (s.LeftByElevation * s.StepElevation) - (s.LeftByAzimuth * s.StepAzimuth)) / squared;
            s.UpByElevation += moreUp * s.StepElevation;
            s.UpByAzimuth += moreUp * s.StepAzimuth;
            s.LeftByElevation += moreLeft * s.StepElevation;
            s.LeftByAzimuth += moreLeft * s.StepAzimuth;
        }

        double contraction = round > 0 ? miss / s.Miss : 1.0;
        s.Up = up;
        s.Left = left;
        s.Miss = miss;
        double determinant = (s.UpByElevation * s.LeftByAzimuth) - (s.UpByAzimuth * s.LeftByElevation);
        s.StepElevation = ((s.UpByAzimuth * left) - (s.LeftByAzimuth * up)) / determinant;
        s.StepAzimuth = ((s.LeftByElevation * up) - (s.UpByElevation * left)) / determinant;
        if (!(Math.Abs(s.StepElevation) < 0.2 && Math.Abs(s.StepAzimuth) < 0.2))
        {
            return -1;
        }

        s.Turn(s.StepElevation, s.StepAzimuth);
        if (!(s.DirectionForward > 0.5))
        {
            return -1;
        }

        // The last correction shrank the miss by a factor; the next one will by no less. Where that is plenty, no flight is needed.
        if (contraction < 0.1 && contraction * miss < 0.1 * tolerance)
        {
            s.Miss = contraction * miss;
            return 1;
        }

        return 0;
    }

    /// <summary>As <see cref="Jacobian.Of"/>: the way turns with the kick, but for the displacements by gravity and wind.</summary>
    private void StartJacobian(ref BatchAimState s, double t, double up, double left, double vf, double vu, double vl)
    {
        double flat = Math.Sqrt((s.DirectionForward * s.DirectionForward) + (s.DirectionLeft * s.DirectionLeft));
        double df = s.DirectionForward / flat;
        double dl = s.DirectionLeft / flat;
        double qf = s.Distance - (0.3 * t * s.WindForward);
        double qu = s.Rise + up - (0.45 * _upward * t * t) - (0.3 * t * _scene.Air.Wind.Y);
        double ql = left - (0.3 * t * s.WindLeft);

        // Raising turns the plane of d and up; the azimuth turns forward to left.
        double ef = -(df * qu);
        double eu = (qf * df) + (ql * dl);
        double el = -(dl * qu);
        double af = -ql;
        double al = qf;

        // Back along the velocity to the plane.
        double slopeUp = vf > 1e-3 ? vu / vf : 0;
        double slopeLeft = vf > 1e-3 ? vl / vf : 0;
        s.UpByElevation = eu - (ef * slopeUp);
        s.LeftByElevation = el - (ef * slopeLeft);
        s.UpByAzimuth = -(af * slopeUp);
        s.LeftByAzimuth = al - (af * slopeLeft);
    }

    /// <summary>Whether a kick that hits keeps to the bounds and cannot touch the ground before: a ball that rises or has no lift up falls but once.</summary>
    private bool StaysClear(in BatchAimState s) =>
        s.DirectionUp >= _lowest && s.DirectionUp <= _highest && (s.DirectionUp >= 0 || s.Top >= 0);

    private static void Write(BatchAims aims, BatchKicks kicks, int index, in BatchAimState s)
    {
        double flat = Math.Sqrt((s.DirectionForward * s.DirectionForward) + (s.DirectionLeft * s.DirectionLeft));

        // left = ŷ × forward = (f_z, 0, −f_x)
        double x = (s.DirectionForward * s.ForwardX) + (s.DirectionLeft * s.ForwardZ);
        double z = (s.DirectionForward * s.ForwardZ) - (s.DirectionLeft * s.ForwardX);
        kicks.Status[index] = s.Miss <= aims.Tolerance ? AimStatus.Hit : AimStatus.NotConverged;
        kicks.Velocity[index] = new Vector3d(s.Speed * x, s.Speed * s.DirectionUp, s.Speed * z);
        kicks.Spin[index] = new Vector3d(s.Top * z / flat, s.Side, -(s.Top * x / flat));
        kicks.Miss[index] = s.Miss;
        kicks.Time[index] = s.Time;
    }

    private void HandOn(BatchAims aims, BatchKicks kicks, int index)
    {
        HandedOn++;
        AimRequest request = aims.Request(index);
        AimResult result = _aimer.Find(request, AimMethod.Direct, measure: false);
        AimStatus status = result.Status;
        double miss = result.Miss;
        if (status == AimStatus.Hit)
        {
            // What comes here is hard: also a flight that grazes the drag law's jump, where large steps may miss it. The true miss decides.
            miss = _judge.Judge(request, result.Velocity, result.Spin).Miss;
            status = miss <= aims.Tolerance ? AimStatus.Hit : AimStatus.NotConverged;
        }

        kicks.Status[index] = status;
        kicks.Velocity[index] = result.Velocity;
        kicks.Spin[index] = result.Spin;
        kicks.Miss[index] = miss;
        kicks.Time[index] = result.Time;
    }

    private static void Refuse(BatchAims aims, int index)
    {
        double speed = aims.Speed[index];
        Vector3d from = aims.From[index];
        Vector3d target = aims.Target[index];
        double size = Math.Abs(from.X) + Math.Abs(from.Y) + Math.Abs(from.Z) + Math.Abs(target.X) + Math.Abs(target.Y) + Math.Abs(target.Z);
        double spins = Math.Abs(aims.TopSpin[index]) + Math.Abs(aims.SideSpin[index]);
        if (speed > 0 && speed <= Limits.Speed && size <= Limits.Length && spins <= Limits.Spin)
        {
            return;
        }

        string at = string.Format(CultureInfo.InvariantCulture, "[{0}]", index);
        Check.Place("aim.from" + at, from);
        Check.Place("aim.target" + at, target);
        Check.Within("aim.speed" + at, speed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within("aim.spin.top" + at, aims.TopSpin[index], -Limits.Spin, Limits.Spin);
        Check.Within("aim.spin.side" + at, aims.SideSpin[index], -Limits.Spin, Limits.Spin);
    }
}
