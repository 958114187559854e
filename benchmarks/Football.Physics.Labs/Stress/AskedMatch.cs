using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Stress;

/// <summary>
/// Simulates one match, and before each step a random set of paths, aims, restores, resimulations and recordings. Each step is also taken in a fresh
/// simulator, made from the scene, the motions of the bodies and the bytes of the states.
/// </summary>
/// <param name="seed">The seed of all matches.</param>
/// <param name="index">The number of the match.</param>
/// <param name="counts">The counts of all matches.</param>
internal sealed class AskedMatch(long seed, long index, LabCounts counts)
{
    public static readonly string[] Columns =
        ["steps", "near a body that turns", "paths", "aims", "restores", "resimulations", "recordings", "bits that differ", "hashes that differ", "exceptions"];

    /// <summary>A body is near a ball within this distance, m.</summary>
    private const double Near = 2;

    /// <summary>The number of ticks that a rollback can go back.</summary>
    private const int MostBack = 12;

    private readonly SeededRandom _random = new(SeededRandom.Mix(seed, index));
    private readonly SeededRandom _asks = new(SeededRandom.Mix(seed, index + 1_000_003));
    private readonly StepLog _log = new();
    private readonly StepLog _freshLog = new();
    private readonly TrajectoryOfAll _paths = new();

    private AskedHall _hall = null!;
    private AskedPitch _main = null!;
    private FixedStepRunner? _runner;
    private Rollback? _rollback;
    private Recording? _recording;
    private LookAheadRun? _run;
    private TrajectoryCache? _cache;
    private Aimer? _aimer;
    private BallState[] _balls = [];
    private readonly List<AskedMove[]> _moves = [];
    private readonly List<AskedPose[]> _things = [];
    private double _dt;
    private bool _varies;
    private bool _calls;
    private double _perKick;
    private int _wireTicks;
    private long _ticks;
    private string _firstAt = "";

    private double Time => _balls[0].Time;

    /// <summary>True if the positions of all objects at each tick are known to a rollback and a recording: those of an engine only from a callback.</summary>
    private bool IsKnown => _calls || _hall.EngineColliders == 0;

    /// <summary>Simulates the match.</summary>
    /// <returns>The first tick with other bits, or the exception that a step or an ask threw; empty if there is neither.</returns>
    public string Play(double seconds)
    {
        try
        {
            Begin();
            while (Time < seconds)
            {
                Tick();
                _ticks++;
            }

            EndRecording();
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            counts.Add("exceptions");
            Found($"{e.GetType().Name}: {e.Message} {e.StackTrace?.Split('\n')[0].Trim()}");
        }

        counts.Add("steps", _ticks);
        return _firstAt;
    }

    private void Begin()
    {
        _hall = new AskedHall(_random);
        _main = _hall.Build(withGhosts: true);
        _dt = _random.Any(1 / 30.0, 1 / 60.0, 1 / 60.0, 1 / 100.0, 1 / 144.0);
        _varies = _random.Chance(0.25);
        _calls = !_varies && _random.Chance(_hall.EngineColliders > 0 ? 0.7 : 0.3);
        _perKick = _random.Any(1.2, 1.2, 5);
        _wireTicks = _random.Chance(0.3) ? _random.Any(1, 6) : 0;
        _balls = new BallState[_hall.Balls];
        bool isHeap = _random.Chance(0.3);
        for (int i = 0; i < _balls.Length; i++)
        {
            // In a heap, the balls touch. They form a pile, and often rest.
            double radius = _main.SimulatorOf(i).Scene.Ball.Radius;
            _balls[i] = isHeap
                ? _main.SimulatorOf(i).Launch(new Vector3d((_hall.LargestRadius + radius) * (i - (i / 3 * 2.5)), radius + (i / 3 * 1.8 * radius), 0), Vector3d.Zero, Vector3d.Zero)
                : _main.SimulatorOf(i).Launch(new Vector3d(0.8 * i, _random.Chance(0.5) ? radius : _random.Uniform(radius, 1.5), 0.1 * i), 4 * _random.Direction(), Vector3d.Zero);
        }

        if (!_varies)
        {
            _runner = Runner(_main);
            _runner.RestoreAll(0, _balls);
            _rollback = IsKnown && _random.Chance(0.6) ? new Rollback(_runner, MostBack) : null;
            _recording = IsKnown ? _runner.Record() : null;
        }

        _run = _hall.EngineColliders == 0 ? new LookAheadRun(_main.Simulator) : null;
        _cache = new TrajectoryCache(_main.Simulator, new LookAheadRequest { Duration = 1, TimeStep = 1 / 60.0 });
        _aimer = _balls.Length == 1 && _random.Chance(0.5) ? new Aimer(_main.Simulator) : null;
    }

    private FixedStepRunner Runner(AskedPitch pitch)
    {
        FixedStepRunner runner = pitch.Runner(_dt);
        runner.QuantizationInterval = _wireTicks;
        runner.MoveBodies = Mover(pitch);
        return runner;
    }

    /// <summary>Returns the callback that moves everything in a scene for the step at a time; null if the match moves it itself.</summary>
    private Action<double>? Mover(AskedPitch pitch) => _calls ? time => Put(pitch, (int)Math.Round(time / _dt), time) : null;

    private void Tick()
    {
        double dt = _varies ? _dt * _random.Any(1, 1, _random.Uniform(0.2, 2.5)) : _dt;
        Ask();
        Move(dt);
        Ask();
        KickInput? kick = null;
        if (_random.Chance(dt / _perKick))
        {
            kick = new KickInput(_ticks, _random.Chance(0.5) ? _random.Velocity(0.5, 12, 0, 50) : _random.Uniform(0, 3) * _random.Direction(), _random.Uniform(0, 40) * _random.Direction(), 0, _random.Below(_balls.Length));
        }

        RigidMotion[] motions = Motions(_main);
        AskedPitch fresh = _hall.Build(withGhosts: false);
        BallState[] before = FromBytes(_balls);
        StepMain(kick, dt);
        CountNear(before);
        BallState[] after = StepFresh(fresh, motions, before, kick, dt);
        Compare(after, fresh, dt);
    }

    /// <summary>Decides where the bodies and the engine's colliders are for the next step, and tells them if no callback does.</summary>
    private void Move(double dt)
    {
        var moves = new AskedMove[_main.Bodies.Count];
        for (int i = 0; i < _hall.Bodies.Length; i++)
        {
            _hall.Bodies[i].Decide(_random, _balls[i % _balls.Length].Position, dt);
            moves[i] = _hall.Bodies[i].Move(_random, _main.Bodies[i].IsWithdrawn, _ticks, dt);
        }

        for (int i = _hall.Bodies.Length; i < moves.Length; i++)
        {
            Vector3d at = _balls[0].Position.Horizontal + (_random.Uniform(0, 0.5) * _random.Heading());
            moves[i] = AskedMove.To(new AskedPose(at, Quaterniond.FromAxisAngle(Vector3d.Up, _random.Uniform(-3, 3)), _random.Uniform(0, 30) * _random.Heading(), _random.Any(0.0, 9) * Vector3d.Up));
        }

        var things = new AskedPose[_hall.EngineColliders];
        for (int i = 0; i < things.Length; i++)
        {
            AskedPose before = _ticks > 0 ? _things[^1][i] : default;
            Vector3d at = _ticks == 0 || _random.Chance(0.02) ? _balls[0].Position.Horizontal + (_random.Uniform(0.5, 2) * _random.Heading()) : before.Position + (dt * before.Velocity);
            Vector3d velocity = _random.Chance(0.1) ? _random.Uniform(0, 3) * _random.Heading() : before.Velocity;
            Quaterniond turned = i % 2 == 0 ? Quaterniond.FromAxisAngle(Vector3d.Up, _random.Uniform(-3, 3)) : Quaterniond.Identity;
            things[i] = new AskedPose(at, turned, velocity, i % 2 == 0 && _random.Chance(0.5) ? _random.Uniform(-8, 8) * Vector3d.Up : Vector3d.Zero);
        }

        _moves.Add(moves);
        _things.Add(things);
        if (!_calls)
        {
            Put(_main, (int)_ticks, Time);
        }
    }

    /// <summary>Moves everything in a scene for a tick.</summary>
    private void Put(AskedPitch pitch, int tick, double time)
    {
        for (int i = 0; i < pitch.Bodies.Count; i++)
        {
            _moves[tick][i].Tell(pitch.Bodies[i], time);
        }

        pitch.Engine?.Put(_things[tick], time);
    }

    private void StepMain(KickInput? kick, double dt)
    {
        _log.Clear();
        if (_runner is null)
        {
            Kick(_main, _balls, kick);
            _main.Step(_balls, dt, _log);
            return;
        }

        if (kick is { } input)
        {
            _runner.Kicks.Add(in input);
        }

        _runner.Step();
        _balls = [.. Enumerable.Range(0, _balls.Length).Select(_runner.StateOf)];
    }

    private BallState[] StepFresh(AskedPitch fresh, RigidMotion[] motions, BallState[] balls, KickInput? kick, double dt)
    {
        Place(fresh, motions);
        fresh.Engine?.Put(_things[^1], balls[0].Time);
        _freshLog.Clear();
        if (_runner is null)
        {
            Kick(fresh, balls, kick);
            fresh.Step(balls, dt, _freshLog);
            return balls;
        }

        FixedStepRunner runner = Runner(fresh);
        runner.RestoreAll(_ticks, balls);
        if (kick is { } input)
        {
            runner.Kicks.Add(in input);
        }

        runner.Step();
        _freshLog.Events.Add(runner.Events);
        _log.Events.Add(_runner.Events);
        return [.. Enumerable.Range(0, balls.Length).Select(runner.StateOf)];
    }

    private static void Kick(AskedPitch pitch, BallState[] balls, KickInput? kick)
    {
        if (kick is { } input)
        {
            pitch.SimulatorOf(input.Ball).Kick(ref balls[input.Ball], input.Velocity, input.Spin);
        }
    }

    /// <summary>Returns the motions of all bodies except those that the ball ignores, and of the obstacles.</summary>
    private RigidMotion[] Motions(AskedPitch pitch)
    {
        var all = new RigidMotion[pitch.Simulator.World.Movers];
        pitch.Simulator.World.ReadMotions(all);
        return [.. all[.._hall.Bodies.Length], .. all[pitch.Bodies.Count..]];
    }

    /// <summary>Sets the motions of a fresh scene: as a game tells them, or as a rollback restores them.</summary>
    private void Place(AskedPitch fresh, RigidMotion[] motions)
    {
        fresh.Simulator.World.WriteMotions(motions);
        for (int i = 0; i < fresh.Bodies.Count && _asks.Chance(0.5); i++)
        {
            if (!motions[i].IsWithdrawn)
            {
                fresh.Bodies[i].MoveTo(motions[i].Origin, motions[i].Orientation, motions[i].Velocity, motions[i].Spin, motions[i].Time);
            }
        }

        // A body that was not told for a while has an old time.
        fresh.Bodies.ForgetTimes();
    }

    private static BallState[] FromBytes(BallState[] balls)
    {
        var bytes = new byte[Snapshot.Size];
        var read = new BallState[balls.Length];
        for (int i = 0; i < balls.Length; i++)
        {
            Snapshot.Write(in balls[i], bytes);
            read[i] = Snapshot.Read(bytes);
        }

        return read;
    }

    private void CountNear(BallState[] before)
    {
        bool isNear = false;
        for (int i = 0; i < _hall.Bodies.Length && !isNear; i++)
        {
            Vector3d at = _main.Bodies[i].Position;
            isNear = _hall.Bodies[i].Turns && !_main.Bodies[i].IsWithdrawn && Array.Exists(before, ball => (ball.Position - at).Length <= Near);
        }

        counts.AddIf(isNear, "near a body that turns");
    }

    private void Compare(BallState[] after, AskedPitch fresh, double dt)
    {
        counts.AddIf(Snapshot.Hash(_balls) != Snapshot.Hash(after), "hashes that differ");
        string? what = null;
        for (int i = 0; i < _balls.Length && what is null; i++)
        {
            what = Snapshot.Difference(in _balls[i], in after[i]) is { } difference ? FormattableString.Invariant($"ball {i} of {_balls.Length}, {difference}") : null;
        }

        RigidMotion[] mine = Motions(_main);
        RigidMotion[] its = Motions(fresh);
        for (int i = 0; i < mine.Length && what is null; i++)
        {
            what = mine[i].IsSame(in its[i]) && mine[i].Time.Equals(its[i].Time) && mine[i].Swing.Equals(its[i].Swing) && mine[i].IsTurned == its[i].IsTurned
                ? null : FormattableString.Invariant($"the motion of mover {i}, {mine[i].Origin:R} {mine[i].Velocity:R} {mine[i].Pivot:R} {mine[i].Orientation:R} {mine[i].Spin:R} {mine[i].Time:R} {mine[i].Swing:R} {mine[i].IsTurned} and {its[i].Origin:R} {its[i].Velocity:R} {its[i].Pivot:R} {its[i].Orientation:R} {its[i].Spin:R} {its[i].Time:R} {its[i].Swing:R} {its[i].IsTurned}");
        }

        what ??= _log.Events.Count == _freshLog.Events.Count ? null : FormattableString.Invariant($"{_log.Events.Count} and {_freshLog.Events.Count} events");
        for (int i = 0; what is null && i < _log.Events.Count; i++)
        {
            what = _log.Events[i].Equals(_freshLog.Events[i]) ? null : FormattableString.Invariant($"event {i}: {_log.Events[i]} and {_freshLog.Events[i]}");
        }

        counts.AddIf(what is not null, "bits that differ");
        if (what is not null)
        {
            Found($"{what}, dt {dt:R}, {_balls[0].Motion}, {(_main.Group is null ? "one" : "group")}{(_runner is null ? "" : ", runner")}{(_main.Engine is null ? "" : ", engine")}{(_hall.Ghosts > 0 ? ", ghosts" : "")}");
        }
    }

    private void Found(FormattableString what) =>
        _firstAt = _firstAt.Length > 0 ? _firstAt : FormattableString.Invariant($"match {index}, tick {_ticks}, ") + FormattableString.Invariant(what);

    /// <summary>Draws paths, asks an aim, restores states or resimulates ticks: none of it may change the next step.</summary>
    private void Ask()
    {
        for (int n = _asks.Below(3); n > 0; n--)
        {
            switch (_asks.Below(12))
            {
                case 0 or 1 or 2:
                    DrawPath();
                    break;
                case 3:
                    StepAside();
                    break;
                case 4 or 5:
                    Restore();
                    break;
                case 6 or 7:
                    Resimulate();
                    break;
                case 8:
                    GoOnWithRun();
                    break;
                case 9:
                    counts.Add("paths");
                    _cache!.Update(in _balls[0]);
                    break;
                case 10 when _asks.Chance(0.2):
                    EndRecording();
                    _recording = IsKnown ? _runner?.Record() : null;
                    break;
                case 11 when _aimer is not null && _asks.Chance(0.05):
                    Aim();
                    break;
                default:
                    break;
            }
        }
    }

    private void DrawPath()
    {
        counts.Add("paths");
        var request = new LookAheadRequest
        {
            Duration = _asks.Uniform(0.02, 1.5),
            TimeStep = _asks.Any(_dt, 1 / 60.0, 0.08),
            StopAt = _asks.Any(StopAt.Time, StopAt.Rest, StopAt.Impact),
            MoveBodies = _asks.Chance(0.3) ? MoveAhead : null,
        };
        if (_main.Group is not null && _asks.Chance(0.3))
        {
            _main.SimulatorOf(_asks.Below(_balls.Length)).LookAhead(in _balls[_asks.Below(_balls.Length)], request, _paths[0]);
        }
        else
        {
            _main.LookAhead(_balls, request, _paths.First(_balls.Length));
        }
    }

    /// <summary>Moves the bodies of a look-ahead.</summary>
    private void MoveAhead(double time)
    {
        for (int i = 0; i < _main.Bodies.Count; i++)
        {
            Vector3d at = _balls[0].Position.Horizontal + new Vector3d(Math.Cos(time + i), 0, Math.Sin((2 * time) + i));
            if (i % 3 == 0)
            {
                _main.Bodies[i].MoveTo(at, Vector3d.Zero, time);
            }
            else
            {
                _main.Bodies[i].MoveTo(at, Quaterniond.FromAxisAngle(Vector3d.Up, (3 * time) + i), new Vector3d(1, 0, 0), i % 3 == 1 ? Vector3d.Up : Vector3d.Zero, time);
            }
        }
    }

    /// <summary>Takes a step of the balls, or of balls elsewhere, and puts all motions back.</summary>
    private void StepAside()
    {
        counts.Add("restores");
        BallState[] copies = [.. _balls];
        if (_asks.Chance(0.5))
        {
            for (int i = 0; i < copies.Length; i++)
            {
                copies[i].Position += new Vector3d(0, 0.2, 0) + (0.3 * _asks.Heading());
            }
        }

        _main.Simulator.World.KeepMotions();
        _main.Step(copies, _dt * _asks.Uniform(0.1, 3), new StepLog());
        _main.Simulator.World.PutMotionsBack();
    }

    /// <summary>Restores the states from their bytes: those of a snapshot, or those on the wire.</summary>
    private void Restore()
    {
        counts.Add("restores");
        BallState[] read = FromBytes(_balls);
        var bytes = new byte[Snapshot.QuantizedSize];
        for (int i = 0; _runner is not null && i < read.Length; i++)
        {
            if (_runner.TryWriteQuantized(in _balls[i], bytes, i))
            {
                read[i] = _runner.ReadQuantized(bytes, i);
            }
        }

        counts.AddIf(Snapshot.Hash(read) != Snapshot.Hash(_balls), "hashes that differ");
        _balls = read;
        _runner?.RestoreAll(_ticks, read);
    }

    /// <summary>Resimulates the last ticks.</summary>
    private void Resimulate()
    {
        if (_rollback is not { } rollback || rollback.OldestTick >= _ticks)
        {
            return;
        }

        counts.Add("resimulations");
        if (rollback.SyncTest(1 + _asks.Below(MostBack)) is { } difference)
        {
            counts.Add("bits that differ");
            Found($"resimulated: {difference}");
        }
    }

    private void GoOnWithRun()
    {
        if (_run is null)
        {
            return;
        }

        counts.Add("paths");
        if (!_run.IsRunning)
        {
            _run.Start(in _balls[0], new LookAheadRequest { Duration = _asks.Uniform(0.5, 3), TimeStep = 1 / 60.0, MoveBodies = _asks.Chance(0.5) ? MoveAhead : null });
        }

        _run.Continue(1 + _asks.Below(20));
    }

    private void Aim()
    {
        counts.Add("aims");
        _aimer!.Find(new AimRequest { From = _balls[0].Position, Target = _balls[0].Position + (_asks.Uniform(4, 15) * _asks.Heading()) + new Vector3d(0, _asks.Uniform(0, 1), 0), Speed = _asks.Uniform(8, 25) });
    }

    /// <summary>Plays the recording so far in a fresh match, from its start and from random ticks.</summary>
    private void EndRecording()
    {
        if (_recording is not { } recording || recording.EndTick <= recording.StartTick)
        {
            return;
        }

        counts.Add("recordings");
        Recording read = Recording.FromBytes(recording.ToBytes());
        AskedPitch fresh = _hall.Build(withGhosts: true);
        FixedStepRunner replay = fresh.Group is not null ? read.Replay(fresh.Group, Mover(fresh)) : read.Replay(fresh.Simulator, Mover(fresh));
        for (int n = 0; n < 4; n++)
        {
            long tick = n == 0 ? read.EndTick : read.StartTick + _asks.Below((int)(read.EndTick - read.StartTick + 1));
            read.Seek(replay, tick);
            if (Snapshot.Hash([.. Enumerable.Range(0, _balls.Length).Select(replay.StateOf)]) != read.HashAt(tick))
            {
                counts.Add("hashes that differ");
                Found($"the recording from tick {read.StartTick} to {read.EndTick}, played to tick {tick}");
                return;
            }
        }
    }

    /// <summary>Trajectories for any number of balls.</summary>
    private sealed class TrajectoryOfAll
    {
        private readonly List<Trajectory> _all = [];

        public Trajectory this[int ball] => First(ball + 1)[ball];

        public Trajectory[] First(int count)
        {
            while (_all.Count < count)
            {
                _all.Add(new Trajectory(512));
            }

            return [.. _all[..count]];
        }
    }
}
