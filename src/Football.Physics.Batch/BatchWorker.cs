using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>Simulates groups of balls one after another, on one thread.</summary>
internal sealed class BatchWorker
{
    private readonly Scene _scene;
    private readonly BatchSettings _settings;
    private readonly Simulator _simulator;

    private readonly ContactMaterial _ground;
    private readonly LaneFlight? _lanes;
    private readonly LaneDomain _domain;
    private readonly LaneGroup _group = new();
    private readonly Vector3d[] _axis = new Vector3d[LaneGroup.Size];
    private readonly int[] _order = new int[LaneGroup.Size];
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly HighestPoint _highest = new();
    private readonly double _upward;

    /// <summary>True if the scene has objects, and all of them are static.</summary>
    private readonly bool _standsStill;

    public BatchWorker(Scene scene, BatchSettings settings, int lanes)
    {
        _scene = scene;
        _settings = settings;
        _simulator = new Simulator(scene, new SolverSettings { Integrator = settings.Integrator });
        _upward = Weight.UpwardAcceleration(scene);
        _ground = new ContactMaterial(scene.Ground, scene.Ball.Bounce);
        _standsStill = !_simulator.World.Moves && scene.HasThings;
        Scene open = _standsStill ? scene with { Obstacles = [], Nets = [], Goals = [] } : scene;
        _domain = new LaneDomain(scene, settings.TimeStep);
        if (settings.Precision == BatchPrecision.Single && LaneFlight.Covers(open))
        {
            _lanes = LaneFlight.Create(open, settings.Integrator == Integrator.Rk4, settings.TimeStep, lanes, findsApex: settings.FindApex);
        }

        if (settings.FindApex)
        {
            _log.Observer = _highest;
        }
    }

    /// <summary>The number of balls in this run that were simulated one by one, in double precision.</summary>
    public int FlownSingly { get; private set; }

    /// <summary>Prepares for a run.</summary>
    public void Begin() => FlownSingly = 0;

    /// <summary>Simulates some balls.</summary>
    [MethodImpl(Hot.Path)]
    public void Fly(BatchLaunches launches, BatchFlights flights, int from, int count, double duration)
    {
        _group.Clear();
        Vector3d wind = _scene.Air.Wind;
        double contact = _simulator.ContactHeight;
        for (int i = 0; i < count; i++)
        {
            int index = from + i;
            Vector3d p = launches.Position[index];
            Vector3d v = launches.Velocity[index];
            Vector3d spin = launches.Spin[index];
            double rate = spin.Length;
            if (!(v.LengthSquared <= Limits.Speed * Limits.Speed && rate <= Limits.Spin
                && Math.Abs(p.X) <= Limits.Length && Math.Abs(p.Y) <= Limits.Length && Math.Abs(p.Z) <= Limits.Length))
            {
                Refuse(index, in p, in v, in spin);
            }

            double y = p.Y > contact ? p.Y : contact;
            bool rises = p.Y > contact || v.Y > 0;
            bool stays = p.Y <= contact && v.Y < _scene.Ground.MinimumBounceSpeed && v.Y > -_scene.Ground.MinimumBounceSpeed && !(_upward > 0);
            Vector3d u = v - wind;
            if (_lanes is not null && rises && !stays && _domain.Covers(u.LengthSquared, rate, y - contact, wind.Y, duration))
            {
                _axis[i] = rate > 0 ? spin / rate : Vector3d.Up;
                _group.Add(i, in u, in _axis[i], rate, contact - y, wind.Y);
            }
            else
            {
                FlyAlone(flights, index, in p, in v, in spin, duration);
            }
        }

        if (_group.Flying > 0)
        {
            FlyTogether(launches, flights, from, duration);
        }
    }

    [MethodImpl(Hot.Path)]
    private void FlyTogether(BatchLaunches launches, BatchFlights flights, int from, double duration)
    {
        int flying = _group.Flying;
        for (int i = 0; i < flying; i++)
        {
            _order[i] = _group.Ball[i];
        }

        _lanes!.Fly(_group, duration);
        double contact = _simulator.ContactHeight;
        Vector3d wind = _scene.Air.Wind;
        for (int k = 0; k < flying; k++)
        {
            int ball = _order[k];
            int index = from + ball;
            if (_group.GivenUp[ball])
            {
                FlyAlone(flights, index, launches.Position[index], launches.Velocity[index], launches.Spin[index], duration);
                continue;
            }

            double time = _group.EndTime[ball];
            Vector3d start = launches.Position[index];
            double y = start.Y > contact ? start.Y : contact;
            Vector3d way = _group.EndPath[ball] + (time * wind);
            bool hit = _group.Reached[ball];
            var place = new Vector3d(start.X + way.X, hit ? contact : y + way.Y, start.Z + way.Z);
            if (_standsStill && !IsClear(launches, index, new Vector3d(start.X, y, start.Z), in place, time))
            {
                FlyAlone(flights, index, in start, launches.Velocity[index], launches.Spin[index], duration);
                continue;
            }

            Vector3d velocity = _group.EndVelocity[ball] + wind;
            Vector3d spin = _group.EndSpin[ball] * _axis[ball];
            double top = _group.Apex[ball] > way.Y ? _group.Apex[ball] : way.Y;
            Write(flights, index, hit ? BatchEnd.Impact : BatchEnd.Time, time, in place, in velocity, in spin, _settings.FindApex ? y + (top > 0 ? top : 0) : 0);
        }
    }

    /// <summary>Returns true if a flight can have hit nothing but the ground.</summary>
    private bool IsClear(BatchLaunches launches, int index, in Vector3d from, in Vector3d to, double time)
    {
        Vector3d u = launches.Velocity[index] - _scene.Air.Wind;
        return time > 0 && _simulator.FliesClear(in from, in to, time, u.Length, launches.Spin[index].Length);
    }

    /// <summary>Simulates one ball in double precision.</summary>
    private void FlyAlone(BatchFlights flights, int index, in Vector3d position, in Vector3d velocity, in Vector3d spin, double duration)
    {
        FlownSingly++;
        BallState state = _simulator.Launch(position, velocity, spin);
        if (state.Motion != MotionState.Airborne)
        {
            Write(flights, index, BatchEnd.Ground, 0, state.Position, state.Velocity, in spin, _settings.FindApex ? state.Position.Y : 0);
            return;
        }

        _highest.Reset(in state);
        _log.Clear();
        bool hit = _simulator.RunChecked(ref state, (float)_settings.TimeStep, duration, StopAt.Impact, _log, null);
        double apex = _settings.FindApex ? _highest.Apex : 0;
        if (hit)
        {
            // With objects in the scene, other events may come first, and the impact need not be on the ground.
            BallEvent impact = LastImpact();
            Write(flights, index, BatchEnd.Impact, impact.Time, impact.Position, impact.VelocityBefore, impact.SpinBefore, apex);
            flights.VelocityAfter[index] = impact.Velocity;
            flights.SpinAfter[index] = impact.Spin;
        }
        else
        {
            Write(flights, index, BatchEnd.Time, state.Time, state.Position, state.Velocity, state.Spin, apex);
        }
    }

    private BallEvent LastImpact()
    {
        int i = _log.Events.Count - 1;
        while (_log.Events[i].Kind != BallEventKind.Impact)
        {
            i--;
        }

        return _log.Events[i];
    }

    [MethodImpl(Hot.Path)]
    private void Write(
        BatchFlights flights, int index, BatchEnd end, double time, in Vector3d position, in Vector3d velocity, in Vector3d spin, double apex)
    {
        Vector3d after = velocity;
        Vector3d spinAfter = spin;
        if (end == BatchEnd.Impact)
        {
            ImpactLaw.Apply(_scene.Ball, in _ground, Vector3d.Up, Vector3d.Zero, in velocity, in spin, out after, out spinAfter);
        }

        flights.End[index] = end;
        flights.Time[index] = time;
        flights.Position[index] = position;
        flights.Velocity[index] = velocity;
        flights.Spin[index] = spin;
        flights.VelocityAfter[index] = after;
        flights.SpinAfter[index] = spinAfter;
        flights.Apex[index] = apex;
    }

    private static void Refuse(int index, in Vector3d position, in Vector3d velocity, in Vector3d spin)
    {
        Check.Place(Check.Item("launch.position", index), position);
        Check.Size(Check.Item("launch.velocity", index), velocity, Limits.Speed, "m/s");
        Check.Size(Check.Item("launch.spin", index), spin, Limits.Spin, "rad/s");
    }
}
