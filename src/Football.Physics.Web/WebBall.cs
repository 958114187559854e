using System.Runtime.CompilerServices;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Web;

/// <summary>A ball, and the memory from which JavaScript reads it.</summary>
internal sealed class WebBall
{
    /// <summary>The length of a ball's numbers: time, position, velocity, spin, orientation, motion, the number of events and their address.</summary>
    private const int Numbers = 17;

    /// <summary>The length of an event's numbers: kind, collider, time, position, velocity before and after, spin before and after, normal, added energy.</summary>
    private const int EventNumbers = 22;

    private const int MostSamples = 1_000_000;

    private readonly WebScene _scene;
    private readonly double[] _numbers = GC.AllocateArray<double>(Numbers, pinned: true);
    private double[] _events = GC.AllocateArray<double>(32 * EventNumbers, pinned: true);
    private double[] _eventsAhead = [];
    private double[] _rows = [];
    private NetBulges? _bulges;
    private BallSquash? _squash;

    public WebBall(WebScene scene)
    {
        _scene = scene;
        Ball = new Ball(scene.Simulator);
        Publish();
    }

    /// <summary>The ball.</summary>
    public Ball Ball { get; }

    /// <summary>The last prediction.</summary>
    public Trajectory Ahead { get; } = new();

    /// <summary>The address of the ball's numbers, which <see cref="Numbers"/> counts.</summary>
    public int Memory => Address(_numbers);

    /// <summary>Changes the ball, and writes its numbers.</summary>
    public void Change(Action<Ball> change)
    {
        change(Ball);
        _squash?.Clear();
        Publish();
    }

    /// <summary>Places the ball with a motion and an orientation, keeps its time, and writes its numbers.</summary>
    /// <param name="numbers">Position, velocity, spin and orientation.</param>
    public void Restart(double[] numbers)
    {
        BallState state = Ball.State;
        new PlaceInput(0, 0, 0, Vector(0), Vector(3), Vector(6), new Quaterniond(numbers[9], numbers[10], numbers[11], numbers[12])).Apply(_scene.Simulator, ref state);
        Ball.State = state;
        Publish();

        Vector3d Vector(int at) => new(numbers[at], numbers[at + 1], numbers[at + 2]);
    }

    /// <summary>Places the bodies, steps, and writes numbers and events.</summary>
    public void Step(double dt)
    {
        _scene.PlaceBodies(Ball.Time);
        Ball.Step(dt);
        Publish();
    }

    /// <summary>Predicts the path, and returns the address of its evenly spaced rows t, x, y, z. After the end of the prediction, the last row repeats.</summary>
    public int LookAhead(double seconds, int samples, double timeStep, string stopAt)
    {
        if (samples is < 2 or > MostSamples)
        {
            throw new ArgumentException(FormattableString.Invariant($"samples is {samples}; allowed: 2 … {MostSamples}."));
        }

        StopAt stop = stopAt switch
        {
            "rest" => StopAt.Rest,
            "impact" => StopAt.Impact,
            "time" => StopAt.Time,
            _ => throw new ArgumentException($"stopAt is {stopAt}; allowed: rest, impact, time."),
        };
        _scene.PlaceBodies(Ball.Time);
        Ball.LookAhead(new LookAheadRequest { Duration = seconds, TimeStep = timeStep, StopAt = stop }, Ahead);
        if (_rows.Length < 4 * samples)
        {
            _rows = GC.AllocateArray<double>(4 * samples, pinned: true);
        }

        for (int i = 0; i < samples; i++)
        {
            double time = Math.Min(Ahead.StartTime + (seconds * i / (samples - 1)), Ahead.EndTime);
            Vector3d position = Ahead.PositionAt(time);
            _rows[4 * i] = time;
            Put(position, _rows, (4 * i) + 1);
        }

        return Address(_rows);
    }

    /// <summary>Returns the outputs of an impact of the last step, in the order of the members in JavaScript.</summary>
    public double[] Impact(int index)
    {
        Impact impact = Ball.Simulator.ImpactOf(in Ball.Events[index]);
        return
        [
            impact.NormalImpulse, impact.TangentialImpulse, impact.SlipBefore, impact.SlipAfter, impact.Grips ? 1 : 0, impact.ContactTime, impact.Compression,
            impact.PeakForce, impact.EnergyLost,
        ];
    }

    /// <summary>Returns the sound of an impact of the last step: loudness, brightness, brush, and then the samples of its wave.</summary>
    public double[] Sound(int index, int rate)
    {
        var sound = new ImpactSound(Ball.Simulator.ImpactOf(in Ball.Events[index]));
        float[] samples = new float[ImpactSound.SamplesAt(rate)];
        sound.Write(samples, rate);
        var numbers = new double[3 + samples.Length];
        numbers[0] = sound.Loudness;
        numbers[1] = sound.Brightness;
        numbers[2] = sound.Brush;
        for (int i = 0; i < samples.Length; i++)
        {
            numbers[3 + i] = samples[i];
        }

        return numbers;
    }

    /// <summary>Updates the squash to the events of the last step, and returns the scales along and across its axis, and the axis.</summary>
    public double[] Squash()
    {
        _squash ??= new BallSquash(_scene.Simulator);
        foreach (ref readonly BallEvent happened in Ball.Events.Span)
        {
            _squash.Follow(in happened);
        }

        BallStretch stretch = _squash.At(Ball.Time);
        var numbers = new double[5];
        numbers[0] = stretch.Along;
        numbers[1] = stretch.Across;
        Put(stretch.Axis, numbers, 2);
        return numbers;
    }

    /// <summary>Returns the forces with which the next step begins, in the order of the members in JavaScript, followed by 13 numbers for each contact.</summary>
    public double[] Forces(double dt)
    {
        if (Ball.GetForces(dt) is not { } forces)
        {
            return [];
        }

        var numbers = new List<double>();
        void Add(in Vector3d vector) => numbers.AddRange([vector.X, vector.Y, vector.Z]);
        foreach (Vector3d force in (Vector3d[])
            [forces.Weight, forces.Buoyancy, forces.Drag, forces.Magnus, forces.Knuckle, forces.Nets, forces.Load, forces.Friction, forces.Sum, forces.Acceleration])
        {
            Add(in force);
        }

        foreach (ContactForce contact in forces.Contacts)
        {
            numbers.Add(contact.ColliderIndex);
            Add(contact.Point);
            Add(contact.Normal);
            Add(contact.Load);
            Add(contact.Friction);
        }

        return [.. numbers];
    }

    /// <summary>Returns the number of events of the last prediction, and their address.</summary>
    public int[] LookAheadEvents()
    {
        Write(Ahead.Events, ref _eventsAhead);
        return [Ahead.Events.Count, Ahead.Events.Count > 0 ? Address(_eventsAhead) : 0];
    }

    /// <summary>Computes, as JSON, whether a goalkeeper saves the ball on the last predicted path.</summary>
    /// <exception cref="RefusedException">A member is unknown, of the wrong type or out of range.</exception>
    public string Keeper(ReadOnlySpan<byte> text, int goal)
    {
        IReadOnlyList<Goal> goals = _scene.Simulator.Scene.Goals;
        if (goal < 0 || goal >= goals.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"goal is {goal}; allowed: 0 … {goals.Count - 1}."));
        }

        InputFields fields = Json.Fields(text);
        InputObject root = fields.Root;
        var defaults = new Player();
        var player = new Player
        {
            Position = root.Vector("position"),
            Velocity = root.Vector("velocity", defaults.Velocity),
            Reaction = root.Number("reaction", defaults.Reaction),
            Acceleration = root.Number("acceleration", defaults.Acceleration),
            Speed = root.Number("speed", defaults.Speed),
            Reach = root.Number("reach", defaults.Reach),
            MinimumHeight = root.Number("minimumHeight", defaults.MinimumHeight),
            MaximumHeight = root.Number("maximumHeight", defaults.MaximumHeight),
        };
        fields.Check();
        KeeperResult answer = new Interception().FindSave(Ahead, player, goals[goal]);
        return Json.Text(json =>
        {
            json.WriteBoolean("crosses", answer.Crosses);
            json.WriteBoolean("isOnTarget", answer.IsOnTarget);
            json.WriteBoolean("saves", answer.Saves);
            Json.Write(json, "time", answer.Crossing.Time);
            Json.Write(json, "position", answer.Crossing.Position);
            Json.Write(json, "lateralOffset", answer.LateralOffset);
            Json.Write(json, "reachLeft", answer.ReachLeft);
            Json.Write(json, "reachRight", answer.ReachRight);
            Json.Write(json, "reachHeight", answer.ReachHeight);
            Json.Write(json, "latestReaction", answer.LatestReaction);
        });
    }

    /// <summary>Updates the bulges of the nets to the ball, and returns depth, position and direction of each.</summary>
    public double[] Bulges()
    {
        _bulges ??= new NetBulges(_scene.Simulator);
        BallState state = Ball.State;
        _bulges.Follow(in state);
        var numbers = new double[7 * _bulges.Count];
        for (int i = 0; i < _bulges.Count; i++)
        {
            NetBulge bulge = _bulges[i];
            numbers[7 * i] = bulge.Depth;
            Put(bulge.Position, numbers, (7 * i) + 1);
            Put(bulge.Direction, numbers, (7 * i) + 4);
        }

        return numbers;
    }

    private static unsafe int Address(double[] pinned) => (int)Unsafe.AsPointer(ref pinned[0]);

    private static void Put(Vector3d v, double[] into, int at)
    {
        into[at] = v.X;
        into[at + 1] = v.Y;
        into[at + 2] = v.Z;
    }

    private void Publish()
    {
        _numbers[0] = Ball.Time;
        Put(Ball.Position, _numbers, 1);
        Put(Ball.Velocity, _numbers, 4);
        Put(Ball.Spin, _numbers, 7);
        Quaterniond q = Ball.Orientation;
        _numbers[10] = q.X;
        _numbers[11] = q.Y;
        _numbers[12] = q.Z;
        _numbers[13] = q.W;
        _numbers[14] = (int)Ball.Motion;
        _numbers[15] = Ball.Events.Count;
        Write(Ball.Events, ref _events);
        _numbers[16] = Address(_events);
    }

    private static void Write(EventBuffer events, ref double[] into)
    {
        if (into.Length < EventNumbers * events.Count)
        {
            into = GC.AllocateArray<double>(2 * EventNumbers * events.Count, pinned: true);
        }

        int at = 0;
        foreach (ref readonly BallEvent happened in events.Span)
        {
            into[at] = (int)happened.Kind;
            into[at + 1] = happened.ColliderIndex;
            into[at + 2] = happened.Time;
            Put(happened.Position, into, at + 3);
            Put(happened.VelocityBefore, into, at + 6);
            Put(happened.Velocity, into, at + 9);
            Put(happened.SpinBefore, into, at + 12);
            Put(happened.Spin, into, at + 15);
            Put(happened.Normal, into, at + 18);
            into[at + 21] = happened.AddedEnergy;
            at += EventNumbers;
        }
    }
}
