using FootballPhysics.Netcode;
using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>A match over the network: runners, late and wrong kicks, states from a server, snapshots in both forms, and recordings.</summary>
internal static class Netcodes
{
    private const double Step = 1.0 / 60;

    public static void Play()
    {
        var draw = new Draw(14);
        for (int i = 0; i < 12; i++)
        {
            One(draw, i);
        }

        for (int i = 0; i < 5; i++)
        {
            Group(draw);
        }
    }

    private static void One(Draw draw, int number)
    {
        var bodies = new KinematicBodies();
        KinematicBody board = bodies.Add("board", new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(0.1, 0.5, 3)), SurfaceMaterial.Board);
        Obstacle dummy = new() { Name = "dummy", Shape = new BoxShape(new Vector3d(0, 0.9, -3), new Vector3d(1.5, 0.9, 0.2)), Mass = 20 };
        Scene scene = Pitch.Cage.On() with { Bodies = bodies, Ball = BallProperties.Modern with { Ignores = number % 3 == 0 ? Layers.Of(4) : 0 } };
        scene = scene with { Obstacles = [.. scene.Obstacles, dummy] };
        var simulator = new Simulator(scene);
        var runner = new FixedStepRunner(simulator, Step) { QuantizationInterval = draw.Any(0, 0, 5), KickTicks = draw.Any(1, 3) };
        bool asks = number % 2 == 0;
        void Move(double time) => board.MoveTo(new Vector3d(0.7 + (0.2 * Math.Sin(9 * time)), 0, 0), new Vector3d(1.8 * Math.Cos(9 * time), 0, 0), time);
        runner.MoveBodies = asks ? Move : null;
        var rollback = new Rollback(runner, 16);
        Recording recording = runner.Record();
        var wire = new byte[Snapshot.QuantizedSize];
        var bytes = new byte[Snapshot.Size];
        for (int frame = 0; frame < 400; frame++)
        {
            if (!asks)
            {
                Move(runner.Time);
            }

            if (draw.Chance(0.03))
            {
                (Vector3d velocity, Vector3d spin) = draw.Kick();
                runner.QueueKick(velocity, spin);
            }

            if (draw.Chance(0.02))
            {
                runner.QueueKick(draw.Between(2, 20), draw.Heading(), 10, 5);
            }

            if (draw.Chance(0.01))
            {
                runner.QueuePlace(new Vector3d(draw.Between(-2, 2), 1, draw.Between(-2, 2)), draw.Vector(4));
            }

            runner.Advance(draw.Between(0.2, 2) * Step);
            _ = runner.Pose.Position + runner.Position + runner.PoseAt(0.3).Position;
            _ = runner.Orientation.W + runner.Spin.X + runner.DroppedTime + runner.TotalDroppedTime;
            _ = runner.PoseOf(0).ToString() + runner.Velocity + runner.Motion + runner.SessionHash + runner.KickTicks;
            if (runner.Tick > 20 && draw.Chance(0.1))
            {
                long tick = runner.Tick - draw.Below(15);
                (Vector3d velocity, Vector3d spin) = draw.Kick();
                var kick = new KickInput(tick, velocity, spin, draw.Below(3));
                _ = kick.ToString();
                rollback.ApplyKick(in kick);
                if (draw.Chance(0.4))
                {
                    rollback.Remove(tick, draw.Below(3));
                }

                var place = new PlaceInput(tick, draw.Below(3), 0, new Vector3d(0, 0.5, draw.Between(-2, 2)), draw.Vector(3), draw.Vector(9), Quaterniond.FromAxisAngle(Vector3d.Up, 1));
                _ = place.ToString();
                rollback.ApplyPlace(in place);
                if (draw.Chance(0.6))
                {
                    rollback.RemovePlace(tick, place.Player);
                }

                rollback.ResimulateFrom(tick);
                rollback.SyncTest(8);
                _ = rollback.HashAt(tick) + (ulong)rollback.Events.Count;
                BallState told = rollback.StateAt(tick);
                Snapshot.Write(in told, bytes);
                BallState read = Snapshot.Read(bytes);
                _ = Snapshot.Same(in told, in read) || Snapshot.Hash(in read) == 0;
                _ = Snapshot.Difference(in told, runner.State)?.ToString();
                if (runner.TryWriteQuantized(in told, wire))
                {
                    rollback.ApplyServerState(tick, runner.ReadQuantized(wire));
                }
            }
        }

        runner.StopRecording();
        rollback.SyncTest(10);
        Replayed(draw, recording, simulator, asks ? Move : null);
    }

    private static void Replayed(Draw draw, Recording recording, Simulator simulator, Action<double>? bodiesAt)
    {
        Recording read = Recording.FromBytes(recording.ToBytes());
        try
        {
            _ = read.FirstDivergence(simulator, bodiesAt);
            FixedStepRunner replay = read.Replay(simulator, bodiesAt);
            foreach (long tick in new[] { read.EndTick, read.StartTick + 10, read.EndTick - 3 })
            {
                read.Seek(replay, tick);
                replay.Step();
            }

            _ = read.HashAt(read.StartTick + draw.Below(50));
            _ = recording.ToBundle(simulator).Length;
        }
        catch (InvalidOperationException)
        {
            // The scene of a bundle cannot contain bodies.
        }
        catch (ArgumentException)
        {
        }

        _ = recording.Start.Time;
        var open = new Simulator(Pitch.Standard.On() with { Zones = [new Zone { Name = "area", Shape = new BoxShape(new Vector3d(0, 1, 45), new Vector3d(20, 1, 8)), Layer = 1 }] });
        var runner = new FixedStepRunner(open, 0.01);
        Recording plain = runner.Record();
        runner.QueueKick(new Vector3d(12, 5, 20), new Vector3d(0, 20, 0));
        for (int i = 0; i < 300; i++)
        {
            runner.Step();
        }

        runner.Place(new Vector3d(3, 0.5, 1));
        runner.Step();
        runner.StopRecording();
        _ = plain.ToBundle(open).Length + plain.FirstDivergence(open);
        byte[] kicks = plain.Kicks.ToBytes();
        KickLog log = KickLog.FromBytes(kicks);
        for (int i = 0; i < 200; i++)
        {
            log.Add(new KickInput(draw.Below(100), draw.Vector(9), default, draw.Below(4), draw.Below(2)));
            log.Remove(draw.Below(100), draw.Below(4), draw.Below(2));
            _ = log.FirstAt(draw.Below(100));
            log.Add(new PlaceInput(draw.Below(100), draw.Below(4), draw.Below(2), draw.Vector(9)));
            log.RemovePlace(draw.Below(100), draw.Below(4), draw.Below(2));
        }

        _ = KickLog.FromBytes(log.ToBytes()).PlaceAt(log.FirstPlaceAt(5)).Position;
        log.RemoveFrom(50);
        log.Clear();
        runner.Simulator = new Simulator(Pitch.Futsal.On());
        runner.Restore(runner.Tick, runner.State);
        runner.Step();

        // A long pause of the game drops time.
        var idle = new FixedStepRunner(0.02);
        idle.QueueKick(new Aiming.Aimer().Find(new Aiming.AimRequest { Target = new Vector3d(0, 1, 15), Speed = 20 }));
        idle.Advance(1e4);
        idle.Advance(0.1);
    }

    private static void Group(Draw draw)
    {
        var group = new BallGroup(new Simulator(Pitch.Cage.On()), 3);
        var runner = new FixedStepRunner(group, Step);
        for (int ball = 0; ball < 3; ball++)
        {
            runner.Place(new Vector3d(0.5 * ball, 0.3, 0), ball);
        }

        var rollback = new Rollback(runner, 20);

        Recording recording = runner.Record();

        for (int tick = 0; tick < 300; tick++)
        {
            if (draw.Chance(0.05))
            {
                (Vector3d velocity, Vector3d spin) = draw.Kick();
                runner.QueueKick(velocity, spin, draw.Below(3));
            }

            runner.Step();
            if (tick > 20 && draw.Chance(0.05))
            {
                (Vector3d velocity, Vector3d spin) = draw.Kick();
                rollback.ApplyKick(new KickInput(runner.Tick - draw.Below(12), velocity, spin, 1, draw.Below(3)));
                rollback.SyncTest(10);
                BallState[] states = [.. Enumerable.Range(0, 3).Select(runner.StateOf)];
                _ = Snapshot.Hash(states);
            }
        }

        runner.StopRecording();
        Recording read = Recording.FromBytes(recording.ToBytes());
        _ = read.FirstDivergence(group);
        FixedStepRunner replay = read.Replay(group);
        read.Seek(replay, read.EndTick - 5);
        runner.RestoreAll(runner.Tick, [.. Enumerable.Range(0, 3).Select(runner.StateOf)]);
        runner.Step();
    }
}
