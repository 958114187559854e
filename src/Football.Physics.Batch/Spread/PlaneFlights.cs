namespace FootballPhysics.Batch;

/// <summary>Simulates many kicks from one point to the plane of a goal: in SIMD lanes if nothing is in between, otherwise ball by ball.</summary>
internal sealed class PlaneFlights
{
    /// <summary>The step of the lanes, in s.</summary>
    private const double Step = 0.04;

    /// <summary>The longest flight, in s.</summary>
    private const double Longest = 15;

    private readonly Simulator _simulator;
    private readonly LaneFlight? _lanes;
    private readonly LaneDomain _domain;
    private readonly LaneGroup _group = new();
    private readonly Trajectory _path = new();
    private readonly Vector3d _wind;
    private LookAheadRequest? _request; // that of the last plane

    public PlaneFlights(Simulator simulator)
    {
        Scene scene = simulator.Scene;
        _simulator = simulator;
        _wind = scene.Air.Wind;
        _domain = new LaneDomain(scene, Step);
        _lanes = LaneFlight.Covers(scene) ? LaneFlight.Create(scene, fourthOrder: true, Step, LaneFlight.BestLanes, upAlongX: true) : null;
    }

    /// <summary>Simulates a group of kicks.</summary>
    /// <param name="kick">The position of the ball, not below the ground, and its orientation.</param>
    /// <param name="goal">The plane.</param>
    /// <param name="velocities">The velocities, in m/s.</param>
    /// <param name="spins">The spins, in rad/s.</param>
    /// <param name="count">The number of kicks; at most a group.</param>
    /// <param name="crossings">Receives the crossings; the time is −1 for kicks that do not cross.</param>
    public void Fly(in SpreadKick kick, in GoalPlane goal, Vector3d[] velocities, Vector3d[] spins, int count, PlaneCrossingPoint[] crossings)
    {
        Vector3d from = kick.Position;
        Vector3d way = goal.Center - from;
        double side = Vector3d.Dot(in way, goal.Out) <= 0 ? -1.0 : 1.0;
        Vector3d forward = side * goal.Out;
        Vector3d left = Vector3d.Cross(Vector3d.Up, in forward);
        double distance = Vector3d.Dot(in way, in forward);
        double windForward = Vector3d.Dot(in _wind, in forward);
        double windLeft = Vector3d.Dot(in _wind, in left);
        double duration = 0;
        bool onGround = from.Y <= _simulator.ContactHeight;
        _group.Clear();
        for (int i = 0; i < count; i++)
        {
            Vector3d u = velocities[i] - _wind;
            double speed = Vector3d.Dot(velocities[i], in forward);
            double rate = spins[i].Length;

            // A rising ball falls only once: it touches the ground before the plane only if it is below the ground at the plane.
            bool rises = velocities[i].Y >= _simulator.Scene.Ground.MinimumBounceSpeed || (!onGround && velocities[i].Y >= 0);
            double time = speed > 0 ? 4.0 * distance / speed : Longest;
            if (_lanes is not null && rises && time < Longest && _domain.Covers(u.LengthSquared, rate, 0, 0, time))
            {
                Vector3d axis = rate > 0 ? spins[i] / rate : Vector3d.Up;
                duration = Math.Max(duration, time);
                _group.Add(i, Turned(in u, in forward, in left), Turned(in axis, in forward, in left), rate, -distance, -windForward);
            }
            else
            {
                crossings[i] = Alone(in kick, in goal, in velocities[i], in spins[i]);
            }
        }

        int flying = _group.Flying;
        if (flying == 0)
        {
            return;
        }

        Span<bool> together = stackalloc bool[LaneGroup.Size];
        together.Clear();
        for (int k = 0; k < flying; k++)
        {
            together[_group.Ball[k]] = true;
        }

        _lanes!.Fly(_group, duration);
        for (int i = 0; i < count; i++)
        {
            if (!together[i])
            {
                continue;
            }

            Vector3d path = _group.EndPath[i];
            double time = _group.EndTime[i];
            double height = from.Y + path.X + (time * _wind.Y);
            if (_group.GivenUp[i] || !_group.Reached[i] || height < _simulator.ContactHeight)
            {
                crossings[i] = Alone(in kick, in goal, in velocities[i], in spins[i]);
                continue;
            }

            Vector3d flat = (distance * forward) + (((time * windLeft) - path.Z) * left);
            crossings[i] = new PlaneCrossingPoint(time, new Vector3d(from.X + flat.X, height, from.Z + flat.Z));
        }
    }

    /// <summary>Simulates one kick in double precision, including everything before the plane.</summary>
    public PlaneCrossingPoint Alone(in SpreadKick kick, in GoalPlane goal, in Vector3d velocity, in Vector3d spin)
    {
        BallState ball = _simulator.Launch(kick.Position, velocity, spin, kick.Orientation);
        Plane3d plane = goal.Plane;
        if (_request?.UntilPlane is not { } known || known.Point != plane.Point || known.Normal != plane.Normal)
        {
            _request = new LookAheadRequest { Duration = Longest, UntilPlane = plane };
        }

        _simulator.LookAhead(in ball, _request, _path);
        return _path.TryGetCrossing(in plane, out PathPoint at) ? new PlaneCrossingPoint(at.Time, at.Position) : new PlaneCrossingPoint(-1, kick.Position);
    }

    /// <summary>Converts to the axes of the lanes: x up, y backward, z right.</summary>
    private static Vector3d Turned(in Vector3d v, in Vector3d forward, in Vector3d left) =>
        new(v.Y, -Vector3d.Dot(in v, in forward), -Vector3d.Dot(in v, in left));
}
