using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Finds groups of kicks one after another, on one thread.</summary>
internal sealed class BatchAimWorker
{
    /// <summary>The step of the flights, in s.</summary>
    private const double Step = 0.08;

    private const int MostRounds = 8;

    private readonly Aimer _aimer;
    private readonly BatchAimStart _start;
    private readonly BatchAimNewton _newton;
    private readonly LaneFlight? _lanes;
    private readonly LaneGroup _group = new();
    private readonly BatchAimState[] _states = new BatchAimState[LaneGroup.Size];
    private readonly int[] _active = new int[LaneGroup.Size];
    private readonly double _windUp;

    /// <summary>True if the air alone can lift a ball that has begun to fall.</summary>
    private readonly bool _floats;

    /// <summary>The upward speed above which a kick leaves the ground, in m/s.</summary>
    private readonly double _leavesGround;

    /// <summary>The sines of the lowest and highest elevation.</summary>
    private double _lowest;
    private double _highest;

    public BatchAimWorker(Scene scene, int lanes)
    {
        _aimer = new Aimer(scene);
        _start = new BatchAimStart(_aimer.Context, Step);
        _newton = new BatchAimNewton(_aimer.Context);
        _windUp = scene.Air.Wind.Y;
        _floats = _aimer.Context.Upward > 0 || scene.Air.Wind.Y > 0;
        _leavesGround = _aimer.Context.Upward > 0 ? 0 : scene.Ground.MinimumBounceSpeed;
        _lanes = LaneFlight.Covers(scene) ? LaneFlight.Create(scene, fourthOrder: true, Step, lanes, upAlongX: true) : null;
    }

    public int FlownSingly { get; private set; }

    public long Flights { get; private set; }

    /// <summary>Prepares for an array of requests.</summary>
    public void Begin(BatchAims aims)
    {
        FlownSingly = 0;
        Flights = 0;
        ElevationBounds bounds = ElevationBounds.OfDegrees(aims.MinimumElevationDegrees, aims.MaximumElevationDegrees);
        Elementary.SinCos(bounds.Lowest, out _lowest, out _);
        Elementary.SinCos(bounds.Highest, out _highest, out _);
    }

    public void Find(BatchAims aims, BatchKicks kicks, int from, int count)
    {
        double tolerance = AimContext.Sharp(aims.Tolerance);
        int active = 0;
        double longest = 0;
        for (int i = 0; i < count; i++)
        {
            int index = from + i;
            aims.Validate(index);
            ref BatchAimState s = ref _states[i];
            if (_lanes is not null && _start.Prepare(aims, index, ref s))
            {
                _active[active++] = i;
                longest = s.Time > longest ? s.Time : longest;
            }
            else
            {
                HandOn(aims, kicks, index);
            }
        }

        // A bit more than twice the longest guess: a ball that arrives later is not on the low arc.
        double duration = (2.0 * longest) + 0.2;
        for (int round = 0; round < MostRounds && active > 0; round++)
        {
            FlyAll(active, duration);
            int left = 0;
            for (int k = 0; k < active; k++)
            {
                int i = _active[k];
                ref BatchAimState s = ref _states[i];
                BatchAimOutcome outcome = _newton.Improve(ref s, _group, i, isFirst: round == 0, tolerance);
                if (outcome == BatchAimOutcome.Corrected)
                {
                    _active[left++] = i;
                }
                else if (outcome == BatchAimOutcome.Hits && StaysClear(in s))
                {
                    Write(aims, kicks, from + i, in s);
                }
                else
                {
                    HandOn(aims, kicks, from + i);
                }
            }

            active = left;
        }

        for (int k = 0; k < active; k++)
        {
            HandOn(aims, kicks, from + _active[k]);
        }
    }

    /// <summary>Simulates all active kicks to the vertical planes through their targets.</summary>
    /// <remarks>The lanes use x up, y backward and z right, so that a flight ends when its y falls below minus the distance.</remarks>
    private void FlyAll(int active, double duration)
    {
        _group.Clear();
        for (int k = 0; k < active; k++)
        {
            int i = _active[k];
            ref BatchAimState s = ref _states[i];
            double flat = Math.Sqrt((s.DirectionForward * s.DirectionForward) + (s.DirectionLeft * s.DirectionLeft));
            var u = new Vector3d(
                (s.Speed * s.DirectionUp) - _windUp,
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

    /// <summary>Returns true if a kick that hits respects the elevations, leaves the ground, and cannot touch it before the target.</summary>
    /// <remarks>A ball that rises, or that nothing lifts, falls only once.</remarks>
    private bool StaysClear(in BatchAimState s) =>
        s.DirectionUp >= _lowest && s.DirectionUp <= _highest && (s.DirectionUp >= 0 || (s.Top >= 0 && !_floats))
        && !(s.OnGround && s.Speed * s.DirectionUp < _leavesGround);

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
        FlownSingly++;
        AimRequest request = aims.Request(index);

        // These requests are hard: a flight may graze the jump in the drag law, where large steps can miss it. Only the true miss decides.
        AimResult result = _aimer.Find(request);
        kicks.Status[index] = result.Status;
        kicks.Velocity[index] = result.Velocity;
        kicks.Spin[index] = result.Spin;
        kicks.Miss[index] = result.Miss;
        kicks.Time[index] = result.Time;
    }
}
