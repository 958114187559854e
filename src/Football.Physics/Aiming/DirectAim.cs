namespace Football.Physics;

/// <summary>
/// The library's own solver for one target. Its unknowns are elevation and azimuth, its equations the crossing of the vertical plane
/// through the target, flown without ground so that they are smooth. Start in closed form; Newton with a Jacobian read off the flight
/// itself, then Broyden; where that fails or leaves the bounds, a bracket on the height at the target's distance, whose largest value
/// over all elevations decides whether the target can be reached at all.
/// </summary>
internal sealed class DirectAim : IAimMethod
{
    private const double Degree = Math.PI / 180.0;

    /// <summary>A miss well below any tolerance worth having, m: a hit is within it even where a request is content with less.</summary>
    private const double FineMiss = 1e-3;

    /// <summary>What the solver's own steps may be off, m: a closer miss is none, even where a request is content with less.</summary>
    private const double FineStepError = 1e-4;

    /// <summary>The top of the heights is known when the elevation moves by less, rad: what that hides is below a tenth of a millimetre.</summary>
    private const double TopAngle = 5e-4;

    private readonly AimContext _context;
    private readonly ReachSearch _reach;
    private AimRequest _request = new();
    private Vector3d _from;
    private Vector3d _forward;
    private Vector3d _left;
    private double _distance;
    private double _speed;
    private double _step;
    private double _lowest;
    private double _highest;
    private readonly Probe[] _probes = new Probe[24];
    private Kick _kick;
    private Probe _last;
    private int _iterations;

    public DirectAim(AimContext context)
    {
        _context = context;
        _reach = new ReachSearch(context);
    }

    public AimAnswer Find(AimRequest request) => Find(request, request.Speed, request.Arc);

    /// <summary>Finds a kick with a speed and on an arc other than the request's.</summary>
    public AimAnswer Find(AimRequest request, double speed, AimArc arc) => Find(request, speed, arc, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with spins other than the request's.</summary>
    public AimAnswer FindSpun(AimRequest request, double top, double side) => Find(request, request.Speed, request.Arc, top, side);

    private AimAnswer Find(AimRequest request, double speed, AimArc arc, double top, double side)
    {
        Prepare(request, speed, top, side);
        double tolerance = Sharp(request);
        if (arc == AimArc.Low && _distance >= 1e-6 && Newton(tolerance) && Flies(in _last))
        {
            return Answer(AimStatus.Hit, in _last);
        }

        bool hit = _reach.Find(request, in _from, in _kick, speed, arc, tolerance);
        Pass found = _reach.Found;
        return new AimAnswer
        {
            // Straight above or below only the elevation matters; at the ball there is no direction at all.
            Status = hit || found.Miss <= request.Tolerance ? AimStatus.Hit
                : _distance < 1e-6 && Math.Abs(request.Target.Y - _from.Y) < 1e-6 ? AimStatus.Degenerate
                : found.Miss < FineStepError ? AimStatus.NotConverged
                : AimStatus.OutOfReach,
            Kick = found.Kick,
            Forward = _forward,
            Speed = _speed,
            Miss = found.Miss,
            Time = found.Time,
            Iterations = _iterations + _reach.Flights,
        };
    }

    /// <summary>The largest height above the target at its distance, over all elevations within the bounds: positive where it can be reached.</summary>
    public double Certificate(AimRequest request, double speed)
    {
        Prepare(request, speed, request.TopSpin, request.SideSpin);
        if (_distance < 1e-6)
        {
            return double.NaN;
        }

        _ = Guess();
        Probe low = Aligned(Fly(_lowest));
        Probe high = Aligned(Fly(_highest));
        return Highest(in low, in high, stopAbove: double.PositiveInfinity).Up;
    }

    /// <summary>The miss that is good enough, m.</summary>
    private static double Sharp(AimRequest request) => 0.8 * Math.Min(request.Tolerance, FineMiss);

    private void Prepare(AimRequest request, double speed, double top, double side)
    {
        _request = request;
        _speed = speed;
        _from = _context.Start(request);
        _forward = AimContext.Forward(in _from, request.Target, out _distance);
        _left = new Vector3d(_forward.Z, 0, -_forward.X); // ŷ × f
        _lowest = request.MinimumElevation * Degree;
        _highest = request.MaximumElevation * Degree;
        _step = _context.StepFor(Sharp(request));
        _iterations = 0;
        _kick = new Kick { Top = top, Side = side };
        _last = new Probe { Kick = _kick };
        double floor = Math.Min(_from.Y, request.Target.Y) - (2.0 * _distance) - 10.0;
        _context.Flight.Aim(request.Target, request.TargetVelocity, in _forward, floor);
    }

    /// <summary>Start in closed form.</summary>
    /// <returns>False where the model does not reach the target.</returns>
    private bool Guess()
    {
        double spinRate = Math.Sqrt((_kick.Top * _kick.Top) + (_kick.Side * _kick.Side));
        FlatFire model = _context.Model(_speed, spinRate, _distance);
        Vector3d toTarget = _request.Target - _from;
        double time = _distance / _speed * (1.0 + (0.5 * model.Drag * _distance));
        Vector3d direction = toTarget / toTarget.Length;
        Vector3d axis = Vector3d.Zero;
        bool reached = false;
        Vector3d wind = _context.Scene.Air.Wind;
        for (int i = 0; i < 2; i++)
        {
            // The axis turns with the azimuth: once more with the right one.
            if (spinRate > 0)
            {
                Vector3d d = direction.Horizontal;
                double flat = d.Length;
                d = flat > 0 ? d / flat : _forward;
                axis = new Vector3d(_kick.Top * d.Z, _kick.Side, -(_kick.Top * d.X)) / spinRate;
            }

            reached = model.Solve(in toTarget, wind - _request.TargetVelocity, in wind, _speed, in axis, ref direction, ref time);
            if (!reached)
            {
                break;
            }
        }

        double horizontal = direction.Horizontal.Length;
        _kick.Elevation = Math.Min(Math.Max(Elementary.Atan2(direction.Y, horizontal), _lowest), _highest);
        _kick.Azimuth = Elementary.Atan2(Vector3d.Dot(in direction, in _left), Vector3d.Dot(in direction, in _forward));
        return reached;
    }

    private Probe Fly(double elevation)
    {
        _kick.Elevation = elevation;
        return Fly(in _kick);
    }

    /// <summary>Flies a kick to the target's plane.</summary>
    private Probe Fly(in Kick kick)
    {
        kick.Vectors(_speed, in _forward, out Vector3d velocity, out Vector3d spin);
        _context.Fly(in _from, in velocity, in spin, _step);
        _iterations++;
        KickFlight flight = _context.Flight;
        var probe = new Probe { Kick = kick, Crossed = flight.Crossed, Lowest = flight.Lowest };
        if (flight.Crossed)
        {
            probe.Up = flight.Offset.Y;
            probe.Left = Vector3d.Dot(flight.Offset, in _left);
            probe.Time = flight.Time;
            probe.Velocity = flight.Velocity;
            probe.Miss = Math.Sqrt((probe.Up * probe.Up) + (probe.Left * probe.Left));
        }
        else
        {
            // Too short: the lower, the further it was from the plane.
            double gap = Vector3d.Dot(_request.Target - flight.End, in _forward);
            probe.Up = -(10.0 + (2.0 * _distance) + Math.Max(0, gap));
            probe.Miss = double.PositiveInfinity;
        }

        return probe;
    }

    /// <summary>Newton from the closed-form start, with Broyden's updates.</summary>
    private bool Newton(double tolerance)
    {
        if (!Guess())
        {
            return false;
        }

        _last = Fly(in _kick);
        if (!_last.Crossed)
        {
            return false;
        }

        Jacobian j = Jacobian.Of(in _last, in _from, in _forward, in _left, _context, _request.Target, _request.TargetVelocity);
        double before = double.PositiveInfinity;
        int limit = Math.Min(_request.MaximumIterations, 10);
        while (_last.Miss > tolerance)
        {
            if (_iterations >= limit || !j.Solve(in _last, out double up, out double turn) || _last.Miss > 0.7 * before)
            {
                return false;
            }

            double elevation = _last.Kick.Elevation + up;
            if (!(Math.Abs(up) < 0.35 && Math.Abs(turn) < 0.5) || elevation < _lowest || elevation > _highest)
            {
                return false;
            }

            Kick next = _last.Kick;
            next.Elevation = elevation;
            next.Azimuth += turn;

            // The last correction shrank the miss by a factor; the next one will by no less. Where that is plenty, no flight is needed.
            double contraction = _last.Miss / before;
            if (contraction > 0 && contraction < 0.1 && contraction * _last.Miss < 0.1 * tolerance)
            {
                _last.Kick = next;
                _last.Miss *= contraction;
                return true;
            }

            before = _last.Miss;
            Probe flown = Fly(in next);
            if (!flown.Crossed)
            {
                return false;
            }

            j.Update(up, turn, flown.Up - _last.Up, flown.Left - _last.Left);
            _last = flown;
        }

        return true;
    }

    /// <summary>Whether a flight to the target leaves the ground and stays above it, so that no impact comes first.</summary>
    private bool Flies(in Probe probe)
    {
        Elementary.SinCos(probe.Kick.Elevation, out double sine, out _);
        if (_context.StaysDown(in _from, _speed * sine))
        {
            return false;
        }

        double lowest = Math.Min(probe.Lowest, _request.Target.Y + (probe.Time * _request.TargetVelocity.Y) + probe.Up);
        return lowest >= _context.Game.ContactHeight - 1e-9;
    }

    /// <summary>Flies once more with the azimuth that the last flight asks for, where it was far off.</summary>
    private Probe Aligned(Probe probe)
    {
        Align(probe);
        return probe.Crossed && Math.Abs(probe.Left) > 0.02 * _distance ? Fly(probe.Kick.Elevation) : probe;
    }

    /// <summary>Turns the kick by the angle by which a flight passed the target.</summary>
    private void Align(Probe probe)
    {
        _kick = probe.Kick;
        if (probe.Crossed)
        {
            // The whole flight turns with the azimuth; its crossing moves along the plane by that much and a little more.
            double across = -probe.Left;
            double along = _distance;
            double slope = Vector3d.Dot(in probe.Velocity, in _left) / Math.Max(Vector3d.Dot(in probe.Velocity, in _forward), 1e-3);
            _kick.Azimuth += Elementary.Atan2(across, Math.Max(0.2 * _distance, along + (slope * probe.Left)));
        }
    }

    /// <summary>The elevation with the greatest height at the target's distance: successive parabolas through the best probe and its neighbours.</summary>
    private Probe Highest(in Probe low, in Probe high, double stopAbove)
    {
        _probes[0] = low;
        _probes[1] = high;
        int count = 2;
        int best = low.Up >= high.Up ? 0 : 1;
        while (count < _probes.Length && _probes[best].Up < stopAbove)
        {
            Probe at = _probes[best];
            double next;
            if (best == 0)
            {
                next = 0.5 * (at.Kick.Elevation + _probes[1].Kick.Elevation);
            }
            else if (best == count - 1)
            {
                next = 0.5 * (at.Kick.Elevation + _probes[best - 1].Kick.Elevation);
            }
            else
            {
                next = Vertex(in _probes[best - 1], in at, in _probes[best + 1]);
            }

            // A parabola that no longer moves has found the top: what is left is of second order in its last move.
            if (Math.Abs(next - at.Kick.Elevation) < TopAngle)
            {
                break;
            }

            Align(at.Crossed ? at : _probes[count - 1]);
            Probe flown = Fly(next);
            int place = count;
            while (_probes[place - 1].Kick.Elevation > next)
            {
                _probes[place] = _probes[place - 1];
                place--;
            }

            _probes[place] = flown;
            count++;
            best = flown.Up > at.Up ? place : place <= best ? best + 1 : best;
        }

        return _probes[best];
    }

    /// <summary>The vertex of the parabola through three probes, kept off the outer ones.</summary>
    private static double Vertex(in Probe a, in Probe b, in Probe c)
    {
        double left = b.Kick.Elevation - a.Kick.Elevation;
        double right = c.Kick.Elevation - b.Kick.Elevation;
        if (!a.Crossed || !c.Crossed)
        {
            // A probe that fell short has no true height: halve towards it.
            return !a.Crossed && (c.Crossed || left > right) ? b.Kick.Elevation - (0.5 * left) : b.Kick.Elevation + (0.5 * right);
        }

        double riseLeft = b.Up - a.Up;
        double riseRight = b.Up - c.Up;
        double below = (left * riseRight) + (right * riseLeft);
        double move = below > 0 ? 0.5 * ((right * right * riseLeft) - (left * left * riseRight)) / below : 0;

        // Neighbours of very different distance make bad parabolas: then the larger gap is halved first.
        if (Math.Max(left, right) > 8 * Math.Min(left, right) && Math.Max(left, right) > 0.05)
        {
            return left > right ? b.Kick.Elevation - (0.3 * left) : b.Kick.Elevation + (0.3 * right);
        }

        return b.Kick.Elevation + Math.Min(Math.Max(move, -0.9 * left), 0.9 * right);
    }

    private AimAnswer Answer(AimStatus status, in Probe probe) => new()
    {
        Status = status,
        Kick = probe.Kick,
        Forward = _forward,
        Speed = _speed,
        Miss = probe.Miss,
        Time = probe.Time,
        Iterations = _iterations,
    };
}
