using System.Globalization;

namespace FootballPhysics.Labs.Rebounds;

/// <summary>The reason for which a meeting is not judged.</summary>
internal enum ReboundLeftOut
{
    None,
    Squeezed,
    Endless,
    Sensitive,
}

/// <summary>The result of one meeting.</summary>
internal readonly record struct ReboundOutcome(ReboundLeftOut LeftOut, int Impacts, int Soon, double Error, string At);

/// <summary>Plays a meeting with the library, and compares its impacts with those of the event integrator.</summary>
internal sealed class MeetingPlay : IEngineColliders
{
    /// <summary>A velocity that differs by more is wrong, m/s.</summary>
    public const double Tolerance = 1e-6;

    /// <summary>The displacement of the ball at the start that shows how much a meeting magnifies errors, m.</summary>
    private const double Displaced = 1e-11;

    /// <summary>The number of events of a step up to which slow impacts are reported too.</summary>
    private const int MostReported = 14;

    private readonly Meeting _meeting;
    private readonly Dictionary<int, KinematicBody> _bodies = [];
    private readonly Dictionary<int, EngineCollider> _colliders = [];

    /// <summary>What impacts have added to the positions and velocities of bodies and colliders.</summary>
    private readonly Vector3d[] _offsets;
    private readonly Vector3d[] _gains;
    private readonly Scene _scene;

    private MeetingPlay(Meeting meeting)
    {
        _meeting = meeting;
        var bodies = new KinematicBodies();
        var obstacles = new List<Obstacle>();
        _offsets = new Vector3d[meeting.Movers.Count];
        _gains = new Vector3d[meeting.Movers.Count];
        for (int i = 0; i < meeting.Movers.Count; i++)
        {
            Mover item = meeting.Movers[i];
            string name = i.ToString(CultureInfo.InvariantCulture);
            switch (item.Kind)
            {
                case MoverKind.Body:
                    _bodies[i] = bodies.Add(name, item.ToShape(isPlaced: false), item.Surface, item.Mass);
                    break;
                case MoverKind.Engine:
                    _colliders[i] = new EngineCollider(name, item.ToShape(isPlaced: false), item.Surface) { Mass = item.Mass };
                    break;
                default:
                    obstacles.Add(new Obstacle { Name = name, Shape = item.ToShape(isPlaced: true), Surface = item.Surface, Velocity = item.Velocity, Mass = item.Mass });
                    break;
            }
        }

        _scene = new Scene
        {
            Gravity = 0,
            Air = new Air { Density = 0 },
            Ground = Ground.None,
            Ball = meeting.Balls[0].Properties,
            Bodies = bodies,
            Obstacles = obstacles,
            EngineColliders = _colliders.Count > 0 ? this : null,
        };
    }

    public double Time { get; private set; }

    public double MaximumSpeed => 50;

    public static ReboundOutcome Play(SeededRandom random, long number)
    {
        // Draw until there are two impacts.
        Meeting meeting;
        EventIntegrator exact;
        do
        {
            meeting = new Meeting(random);
            exact = new EventIntegrator(meeting, Vector3d.Zero);
            exact.PlayTo(meeting.Duration);
        }
        while (exact.Events.Count < 2);

        if (exact.IsSqueezed || exact.IsEndless)
        {
            return new ReboundOutcome(exact.IsSqueezed ? ReboundLeftOut.Squeezed : ReboundLeftOut.Endless, 0, 0, 0, "");
        }

        var displaced = new EventIntegrator(meeting, Displaced * random.Direction());
        displaced.PlayTo(meeting.Duration);
        if (exact.IsGrazing || Difference(exact.Events, displaced.Events) > Tolerance)
        {
            return new ReboundOutcome(ReboundLeftOut.Sensitive, 0, 0, 0, "");
        }

        List<ReboundEvent> found = new MeetingPlay(meeting).Events();
        List<ReboundEvent> right = [.. exact.Events, .. meeting.Balls.Select((_, i) => new ReboundEvent(meeting.Duration, i, -1, 0, exact.VelocityOf(i)))];

        // After 14 events, a step only counts slow impacts: compare the last velocities.
        double error = exact.MostOfStep < MostReported ? Difference(right, found) : Difference(right[^meeting.Balls.Count..], found[^meeting.Balls.Count..]);
        int soon = exact.Events.Zip(exact.Events.Skip(1)).Count(pair => pair.Second.Time - pair.First.Time < 0.1);
        return new ReboundOutcome(ReboundLeftOut.None, exact.Events.Count, soon, error, FormattableString.Invariant(
            $"meeting {number}, step {meeting.TimeStep:0.0000} s: {error:0.0e0} m/s; {string.Join("; ", right.Select(Text))} / {string.Join("; ", found.Select(Text))}; {string.Join(", ", meeting.Movers.Select(item => $"{item.Kind} {item.Shape} v {item.Velocity.Length:0.0} w {item.Spin.Length:0.0} M {item.Mass:0.0} e {item.Restitution:0.00}"))}"));
    }

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        foreach ((int i, EngineCollider collider) in _colliders)
        {
            MoverPose pose = _meeting.Movers[i].At(Time);
            collider.MoveTo(pose.Origin + _offsets[i], pose.Orientation, _meeting.Movers[i].Velocity + _gains[i], _meeting.Movers[i].Spin);
            hits.Add(collider);
        }
    }

    private static string Text(ReboundEvent item) => FormattableString.Invariant($"{item.Time:0.000000} {item.Ball}-{item.Other} {item.Velocity.ToString("F6")}");

    /// <summary>Returns the largest difference of two lists of impacts, m/s; infinite if they are not the same impacts.</summary>
    private static double Difference(List<ReboundEvent> one, List<ReboundEvent> other)
    {
        // The two halves of an impact between balls may come in either order.
        ReboundEvent[] first = [.. one.OrderBy(item => item.Ball)];
        ReboundEvent[] second = [.. other.OrderBy(item => item.Ball)];
        return first.Length != second.Length ? double.PositiveInfinity : first.Zip(second)
            .Select(pair => pair.First.Ball == pair.Second.Ball && pair.First.Other == pair.Second.Other ? (pair.First.Velocity - pair.Second.Velocity).Length : double.PositiveInfinity)
            .DefaultIfEmpty(0).Max();
    }

    /// <summary>Steps the balls, and returns their impacts.</summary>
    private List<ReboundEvent> Events()
    {
        var events = new List<ReboundEvent>();
        var log = new StepLog();
        bool isGroup = _meeting.Balls.Count > 1;
        BallGroup? group = isGroup ? new BallGroup(_scene, [.. _meeting.Balls.Select(item => item.Properties)], contact: Mover.Material(Meeting.BallRestitution, 0, _meeting.BallFriction)) : null;
        Simulator simulator = group?.SimulatorOf(0) ?? new Simulator(_scene);
        BallState[] states = [.. _meeting.Balls.Select((item, i) => (group?.SimulatorOf(i) ?? simulator).Launch(item.Position, item.Velocity, item.Spin))];
        for (double left = _meeting.Duration; left > 0; left -= _meeting.TimeStep)
        {
            Time = states[0].Time;
            foreach ((int i, KinematicBody body) in _bodies)
            {
                MoverPose pose = _meeting.Movers[i].At(Time);
                body.MoveTo(pose.Origin + _offsets[i], pose.Orientation, _meeting.Movers[i].Velocity + _gains[i], _meeting.Movers[i].Spin, Time);
            }

            log.Clear();
            double step = Math.Min(left, _meeting.TimeStep);
            if (group is not null)
            {
                group.Step(states, step, log);
            }
            else
            {
                simulator.Step(ref states[0], step, log);
            }

            for (int i = 0; i < _offsets.Length; i++)
            {
                _offsets[i] += step * _gains[i];
            }

            foreach (ref readonly BallEvent item in log.Events.Span)
            {
                if (item.Kind != BallEventKind.Impact)
                {
                    events.Add(new ReboundEvent(item.Time, item.Ball, -1, 0, item.Velocity));
                    continue;
                }

                int other = item.OtherBall >= 0 ? _meeting.Movers.Count + item.OtherBall : int.Parse((group?.SimulatorOf(item.Ball) ?? simulator).NameOf(item.ColliderIndex)!, CultureInfo.InvariantCulture);
                events.Add(new ReboundEvent(item.Time, item.Ball, other, 0, item.Velocity));
                if (other < _offsets.Length)
                {
                    // The game applies the opposite impulse to its body.
                    Vector3d gain = _meeting.Balls[item.Ball].Properties.Mass * (item.Velocity - item.VelocityBefore) / -_meeting.Movers[other].Mass;
                    _gains[other] += gain;
                    _offsets[other] += (states[0].Time - item.Time) * gain;
                }
            }
        }

        // The last velocities count like impacts.
        events.AddRange(states.Select((state, i) => new ReboundEvent(state.Time, i, -1, 0, state.Velocity)));

        return events;
    }
}
