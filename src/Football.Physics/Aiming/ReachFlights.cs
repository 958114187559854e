namespace Football.Physics;

/// <summary>How kicks of an elevation pass a target: each with the azimuth that brings it closest.</summary>
internal sealed class ReachFlights
{
    /// <summary>Flights that may be spent on the azimuth of one elevation.</summary>
    private const int MostTurns = 12;

    /// <summary>Share of its miss by which a kick may be off to the side: the miss is known to a millionth then.</summary>
    private const double SmallOffset = 2e-3;

    /// <summary>Where no wind is known yet, the drift of a ball is about this share of the wind's own way.</summary>
    private const double Drift = 0.3;

    /// <summary>Step of a roll of which only the direction counts, s.</summary>
    private const double RollingStep = 2.0;

    /// <summary>Up to so many tolerances off, a flight is taken again in shorter steps.</summary>
    private const double NearHit = 10;

    private readonly AimContext _context;
    private Vector3d _toTarget;
    private Vector3d _targetVelocity;
    private Vector3d _forward;
    private Vector3d _left;
    private Kick _kick;
    private double _tolerance;

    public ReachFlights(AimContext context) => _context = context;

    /// <summary>The best pass so far.</summary>
    public Pass Best { get; private set; }

    /// <summary>Flights so far.</summary>
    public int Flights { get; private set; }

    /// <summary>Whether flights turn with their azimuth.</summary>
    public bool Turns => _context.Passes.Turns;

    /// <summary>Prepares for a target.</summary>
    public void Aim(AimRequest request, in Vector3d from, in Kick kick, double speed, double tolerance)
    {
        _context.Passes.Aim(in from, request.Target, request.TargetVelocity, speed);
        _toTarget = request.Target - from;
        _targetVelocity = request.TargetVelocity;
        _forward = AimContext.Forward(in from, request.Target, out _);
        _left = new Vector3d(_forward.Z, 0, -_forward.X); // ŷ × f
        _kick = kick;
        _kick.Azimuth = 0;
        _tolerance = tolerance;
        Flights = 0;
        Best = new Pass { Kick = _kick, Miss = double.PositiveInfinity };
    }

    /// <summary>Flies an elevation, beginning with the azimuth of the last one.</summary>
    public Pass At(double elevation) => At(elevation, _context.LongStep);

    /// <summary>Flies an elevation, beginning with the azimuth of another.</summary>
    public Pass At(double elevation, in Pass near)
    {
        _kick.Azimuth = near.Kick.Azimuth;
        return At(elevation);
    }

    /// <summary>The same in the shorter steps of a hit.</summary>
    public Pass Near(double elevation, in Pass near)
    {
        _kick.Azimuth = near.Kick.Azimuth;
        return At(elevation, _context.ShortStep);
    }

    /// <summary>Flies a kick as it is.</summary>
    public Pass Of(in Kick kick)
    {
        _kick.Elevation = kick.Elevation;
        _kick.Azimuth = kick.Azimuth;
        return Fly(_context.LongStep);
    }

    /// <summary>Rolls along the ground, straight at the target at first.</summary>
    /// <param name="elevation">The elevation.</param>
    /// <param name="rough">Whether only its direction counts.</param>
    public Pass Along(double elevation, bool rough)
    {
        _kick.Azimuth = 0;
        _context.Passes.Roughly = rough;
        Pass pass = At(elevation, rough ? RollingStep : _context.LongStep);
        _context.Passes.Roughly = false;
        return pass;
    }

    private Pass At(double elevation, double step)
    {
        _kick.Elevation = elevation;
        Pass pass = Fly(step);
        if (pass.Miss < NearHit * _tolerance && step > _context.ShortStep)
        {
            // A hit is not said from long steps.
            step = _context.ShortStep;
            pass = Fly(step);
        }

        if (Turns)
        {
            _kick.Azimuth = pass.Kick.Azimuth;
            return pass;
        }

        pass = Turned(pass, step);
        if (pass.Time == 0 && pass.Kick.Azimuth != 0)
        {
            // Kicked the wrong way, it was never closer than at the start, which says nothing of where to turn.
            _kick.Azimuth = 0;
            Pass straight = Turned(Fly(step), step);
            pass = straight.Miss < pass.Miss ? straight : pass;
        }

        return pass;
    }

    /// <summary>In a wind: turns a kick until it passes the target as closely as that allows.</summary>
    private Pass Turned(Pass pass, double step)
    {
        // Turning a kick turns its way about a point c that the wind carries along: the target is to be seen from c where the ball is.
        Vector3d c = pass.Time * ((Drift * _context.Scene.Air.Wind) - _targetVelocity);
        for (int i = 0; i < MostTurns; i++)
        {
            Vector3d at = pass.Gap + _toTarget;
            double turn = Bearing(_toTarget - c) - Bearing(at - c);
            turn = turn > Math.PI ? turn - (2 * Math.PI) : turn < -Math.PI ? turn + (2 * Math.PI) : turn;
            double offset = Math.Abs(turn) * (at - c).Horizontal.Length;
            if (!(offset > SmallOffset * pass.Miss && offset > 0.1 * _tolerance))
            {
                break;
            }

            _kick.Azimuth = pass.Kick.Azimuth + turn;
            Pass next = Fly(step);
            Centre(at, next.Gap + _toTarget, next.Kick.Azimuth - pass.Kick.Azimuth, ref c);
            pass = next;
        }

        return pass;
    }

    /// <summary>The point about which a turn moved the closest point: p₂ − c = R (p₁ − c).</summary>
    private void Centre(in Vector3d one, in Vector3d other, double turn, ref Vector3d c)
    {
        if (!(Math.Abs(turn) > 1e-3))
        {
            return;
        }

        Elementary.SinCos(turn, out double sin, out double cos);
        double f1 = Vector3d.Dot(in one, in _forward);
        double l1 = Vector3d.Dot(in one, in _left);
        double f2 = Vector3d.Dot(in other, in _forward);
        double l2 = Vector3d.Dot(in other, in _left);

        // c = (p₂ − e^{iφ} p₁) / (1 − e^{iφ}), with 1/(1 − e^{iφ}) = ½ (1 + i cot(φ/2))
        double f = f2 - ((cos * f1) - (sin * l1));
        double l = l2 - ((sin * f1) + (cos * l1));
        double cot = sin / (1.0 - cos);
        c = (0.5 * (f - (cot * l)) * _forward) + (0.5 * (l + (cot * f)) * _left);
    }

    private double Bearing(in Vector3d way)
    {
        double f = Vector3d.Dot(in way, in _forward);
        double l = Vector3d.Dot(in way, in _left);
        return f == 0 && l == 0 ? 0 : Elementary.Atan2(l, f);
    }

    private Pass Fly(double step)
    {
        _context.Simulations++;
        Flights++;
        Pass pass = _context.Passes.Fly(in _kick, step);
        if (pass.Miss < Best.Miss)
        {
            Best = pass;
        }

        return pass;
    }
}
