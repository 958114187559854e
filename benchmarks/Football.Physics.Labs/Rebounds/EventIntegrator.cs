namespace FootballPhysics.Labs.Rebounds;

/// <summary>
/// Balls and moving objects in empty space, from impact to impact: paths in closed form, times of impact by advancing until the gap is closed, and the
/// impact law of two things that both move. It shares no code with the library's steps.
/// </summary>
internal sealed class EventIntegrator
{
    /// <summary>A gap below this is closed, m.</summary>
    private const double Closed = 1e-13;

    /// <summary>A ball and a rotating object that have met part for this time, s.</summary>
    private const double Parting = 1e-8;

    /// <summary>A ball that leaves a rotating object more slowly than this may stay on it, m/s.</summary>
    private const double Pressed = 0.15;

    /// <summary>The number of advances after which a gap neither closes nor opens.</summary>
    private const int MostAdvances = 5000;

    /// <summary>After this many impacts in a step, the balls are in an endless series.</summary>
    private const int MostInStep = 60;

    private readonly Meeting _meeting;
    private readonly MovingBall[] _balls;
    private readonly Pushed[] _objects;

    /// <summary>True for pairs that have met and not parted yet.</summary>
    private readonly bool[,] _together;

    private double _time;

    public EventIntegrator(Meeting meeting, in Vector3d displacement)
    {
        _meeting = meeting;
        _balls = [.. meeting.Balls.Select(ball => new MovingBall { Position = ball.Position, Velocity = ball.Velocity, Spin = ball.Spin })];
        _balls[0].Position += displacement;
        _objects = new Pushed[meeting.Movers.Count];
        _together = new bool[_balls.Length, _objects.Length + _balls.Length];
    }

    /// <summary>True if a gap stayed so small that its time of impact is not known, or if a rotating object keeps pressing the ball.</summary>
    public bool IsGrazing { get; private set; }

    /// <summary>The impacts so far.</summary>
    public List<ReboundEvent> Events { get; } = [];

    /// <summary>The largest number of impacts in a step.</summary>
    public int MostOfStep { get; private set; }

    /// <summary>True if a step had no end: the objects leave a ball no room.</summary>
    public bool IsSqueezed { get; private set; }

    /// <summary>True if a step had no end although there is room.</summary>
    public bool IsEndless { get; private set; }

    public Vector3d PositionOf(int ball) => _balls[ball].Position;

    public Vector3d VelocityOf(int ball) => _balls[ball].Velocity;

    /// <summary>Plays until a time, or until a ball is in an endless series of impacts.</summary>
    public void PlayTo(double until)
    {
        for (int step = 1; _time < until && !IsSqueezed && !IsEndless; step++)
        {
            PlayStep(Math.Min(until, step * _meeting.TimeStep));
        }
    }

    private void PlayStep(double end)
    {
        int first = Events.Count;
        while (FindNext(end, out int ball, out int other))
        {
            Meet(ball, other);
            if (Events.Count - first > MostInStep)
            {
                IsSqueezed = !HasRoom(ball, end, [.. Events.Skip(first).Where(item => item.Ball == ball && item.Other < _objects.Length).Select(item => item.Other).Distinct()]);
                IsEndless = !IsSqueezed;
                return;
            }
        }

        MostOfStep = Math.Max(MostOfStep, Events.Count - first);
        Advance(end);
    }

    /// <summary>Moves everything to the next impact.</summary>
    private bool FindNext(double end, out int ball, out int other)
    {
        double earliest = end;
        ball = -1;
        other = -1;
        for (int i = 0; i < _balls.Length; i++)
        {
            for (int j = 0; j < _objects.Length + i; j++)
            {
                double at = TimeOf(i, j, earliest);
                if (at < earliest)
                {
                    earliest = at;
                    ball = i;
                    other = j;
                }
            }
        }

        if (ball >= 0)
        {
            Advance(earliest);
        }

        return ball >= 0;
    }

    /// <summary>Returns the time at which a pair meets; the end if it does not meet before.</summary>
    private double TimeOf(int ball, int other, double end)
    {
        // After an impact, a gap to a convex surface that only translates opens until a velocity changes.
        double fastest = SpeedBound(ball, other);
        bool turns = other < _objects.Length && _meeting.Movers[other].Spin != Vector3d.Zero;
        if (!(fastest > 0) || (_together[ball, other] && !turns))
        {
            return end;
        }

        double time = _together[ball, other] ? _time + Parting : _time;
        for (int i = 0; i < MostAdvances && time < end; i++)
        {
            double gap = GapAt(ball, other, time, out _);
            if (gap <= Closed)
            {
                return time;
            }

            // Nothing closes a gap faster than this.
            time += gap / fastest;
        }

        IsGrazing |= time < end;
        return end;
    }

    /// <summary>Returns a bound of the speed at which a gap closes, m/s.</summary>
    private double SpeedBound(int ball, int other) => other >= _objects.Length
        ? (_balls[ball].Velocity - _balls[other - _objects.Length].Velocity).Length
        : (_balls[ball].Velocity - Motion(other)).Length + (_meeting.Movers[other].Spin.Length * _meeting.Movers[other].Reach);

    private Vector3d Motion(int other) => _meeting.Movers[other].Velocity + _objects[other].Velocity;

    private double GapAt(int ball, int other, double time, out Vector3d normal)
    {
        Vector3d at = _balls[ball].Position + ((time - _time) * _balls[ball].Velocity);
        double radius = _meeting.Balls[ball].Radius;
        if (other >= _objects.Length)
        {
            int second = other - _objects.Length;
            Vector3d way = at - (_balls[second].Position + ((time - _time) * _balls[second].Velocity));
            normal = way / way.Length;
            return way.Length - radius - _meeting.Balls[second].Radius;
        }

        (double distance, Vector3d n) = _meeting.Movers[other].From(in at, PoseOf(other, time));
        normal = n;
        return distance - radius;
    }

    private MoverPose PoseOf(int other, double time)
    {
        MoverPose pose = _meeting.Movers[other].At(time);
        return pose with { Origin = pose.Origin + _objects[other].Offset + ((time - _time) * _objects[other].Velocity) };
    }

    private void Advance(double time)
    {
        for (int i = 0; i < _balls.Length; i++)
        {
            _balls[i].Position += (time - _time) * _balls[i].Velocity;
        }

        for (int i = 0; i < _objects.Length; i++)
        {
            _objects[i].Offset += (time - _time) * _objects[i].Velocity;
        }

        _time = time;
    }

    /// <summary>Applies the impact law: u, J_n, J_t and what they change, with both masses and both inertias.</summary>
    private void Meet(int ball, int other)
    {
        GapAt(ball, other, _time, out Vector3d n);
        ref MovingBall b = ref _balls[ball];
        MeetingBall own = _meeting.Balls[ball];
        int second = other - _objects.Length;
        Mover? mover = second < 0 ? _meeting.Movers[other] : null;
        MeetingBall? met = second < 0 ? null : _meeting.Balls[second];
        Vector3d contact = b.Position - (own.Radius * n);
        Vector3d surface = mover is not null
            ? Motion(other) + Vector3d.Cross(mover.Spin, contact - PoseOf(other, _time).Origin)
            : _balls[second].Velocity + (met!.Radius * Vector3d.Cross(_balls[second].Spin, n));
        Vector3d u = b.Velocity - (own.Radius * Vector3d.Cross(b.Spin, n)) - surface;
        double closing = -Vector3d.Dot(b.Velocity - (mover is not null ? surface : _balls[second].Velocity), n);
        for (int i = 0; i < _together.GetLength(0); i++)
        {
            for (int j = 0; j < _together.GetLength(1); j++)
            {
                _together[i, j] &= i != ball && i != second && j - _objects.Length != ball;
            }
        }

        _together[ball, other] = true;
        IsGrazing |= mover is not null && mover.Spin != Vector3d.Zero && mover.Restitution * closing < Pressed;
        double e = mover?.Restitution ?? Meeting.BallRestitution;
        double tangential = mover?.TangentialRestitution ?? 0;
        double friction = mover?.Friction ?? _meeting.BallFriction;
        double yields = (1 / own.Mass) + (1 / (mover?.Mass ?? met!.Mass));
        double turns = (own.Radius * own.Radius / own.Inertia) + (met is null ? 0 : met.Radius * met.Radius / met.Inertia);
        double normal = (1 + e) * Math.Max(0, closing) / yields;
        Vector3d slip = u - (Vector3d.Dot(u, n) * n);
        Vector3d grip = -(1 + tangential) / (yields + turns) * slip;
        double most = friction * normal;
        Vector3d impulse = (normal * n) + (grip.Length > most ? most / grip.Length * grip : grip);
        b.Velocity += impulse / own.Mass;
        b.Spin -= own.Radius / own.Inertia * Vector3d.Cross(n, impulse);
        if (mover is not null)
        {
            _objects[other].Velocity -= impulse / mover.Mass;
        }
        else
        {
            _balls[second].Velocity -= impulse / met!.Mass;
            _balls[second].Spin -= met.Radius / met.Inertia * Vector3d.Cross(n, impulse);
            Events.Add(new ReboundEvent(_time, second, _objects.Length + ball, closing, _balls[second].Velocity));
        }

        Events.Add(new ReboundEvent(_time, ball, other, closing, b.Velocity));
    }

    /// <summary>
    /// Decides whether something squeezes a ball: at the end of the step, no position of its centre within the distance that the moving objects travel in
    /// that step overlaps none of the objects that touch it. Positions are tried on a grid.
    /// </summary>
    private bool HasRoom(int ball, double end, int[] touched)
    {
        const int Half = 12;
        double travel = touched.Select(other => (Motion(other).Length + (_meeting.Movers[other].Spin.Length * _meeting.Movers[other].Reach)) * _meeting.TimeStep).DefaultIfEmpty(0).Max();
        for (int i = 0; i < (1 + (2 * Half)) * (1 + (2 * Half)) * (1 + (2 * Half)); i++)
        {
            const int Side = 1 + (2 * Half);
            Vector3d way = (travel / Half) * new Vector3d((i % Side) - Half, (i / Side % Side) - Half, (i / Side / Side) - Half);
            Vector3d at = _balls[ball].Position + way;
            if (way.Length <= travel && Array.TrueForAll(touched, other => _meeting.Movers[other].From(in at, PoseOf(other, end)).Distance >= _meeting.Balls[ball].Radius))
            {
                return true;
            }
        }

        return false;
    }

    private struct MovingBall
    {
        public Vector3d Position;
        public Vector3d Velocity;
        public Vector3d Spin;
    }

    /// <summary>What impacts have added to an object's position and velocity.</summary>
    private struct Pushed
    {
        public Vector3d Offset;
        public Vector3d Velocity;
    }
}

/// <summary>An impact of a ball.</summary>
/// <param name="Time">The time, s.</param>
/// <param name="Ball">The ball.</param>
/// <param name="Other">The object; from the number of objects on, the other ball.</param>
/// <param name="Closing">The closing speed, m/s.</param>
/// <param name="Velocity">The ball's velocity after it, m/s.</param>
internal readonly record struct ReboundEvent(double Time, int Ball, int Other, double Closing, Vector3d Velocity);
