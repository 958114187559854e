using FootballPhysics.Game;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Game;

/// <summary>The log of bodies against a plain list, and its bytes field by field.</summary>
public sealed class PlacementLogTests
{
    [Fact]
    public void The_log_has_what_a_plain_list_has()
    {
        var random = new Random(81);
        for (int run = 0; run < 20; run++)
        {
            KinematicBodies bodies = Bodies(6);
            var log = new PlacementLog();
            var list = new List<(long Tick, int Body, RigidMotion Motion)>();
            long tick = random.Next(100);
            for (int step = 0; step < 300; step++)
            {
                bodies.ForgetTimes();
                for (int i = 0; i < bodies.Count; i++)
                {
                    if (random.Next(3) == 0)
                    {
                        RigidMotion motion = Any(random);
                        bodies.Repeat(i, in motion);
                        list.Add((tick, i, motion));
                    }
                }

                log.Record(tick, bodies);
                tick += random.Next(1, 3);
                if (random.Next(5) == 0)
                {
                    long before = tick - random.Next(60);
                    log.RemoveBefore(before);
                    list.RemoveAll(at => at.Tick < before);
                }

                if (random.Next(20) == 0)
                {
                    tick -= random.Next(6);
                    log.RemoveFrom(tick);
                    list.RemoveAll(at => at.Tick >= tick);
                }

                Assert.Equal(list.Count, log.Count);
                Assert.Equal(list.Count == 0 ? -1 : list.Max(at => at.Body), log.HighestBody());
                long any = tick - random.Next(30);
                KinematicBodies others = Bodies(6);
                others.ForgetTimes();
                log.Apply(any, others);
                for (int i = 0; i < others.Count; i++)
                {
                    (long Tick, int Body, RigidMotion Motion)[] told = [.. list.Where(at => at.Tick == any && at.Body == i)];
                    Assert.Equal(told.Length > 0, others.WasMoved(i));
                    Assert.True(told.Length == 0 || Same(told[^1].Motion, others[i].Motion));
                }
            }

            // The bytes of a range of ticks.
            var writer = new ByteWriter();
            long from = tick - 40;
            long to = tick - 10;
            log.Write(from, to, ref writer);
            byte[] bytes = writer.ToArray();
            var reader = new ByteReader(bytes);
            var read = PlacementLog.Read(ref reader);
            reader.End();
            Assert.Equal(list.Count(at => at.Tick >= from && at.Tick < to), read.Count);
            for (long at = from - 5; at < to + 5; at++)
            {
                KinematicBodies others = Bodies(6);
                others.ForgetTimes();
                read.Apply(at, others);
                for (int i = 0; i < others.Count; i++)
                {
                    (long Tick, int Body, RigidMotion Motion)[] told = [.. list.Where(entry => entry.Tick == at && at >= from && at < to && entry.Body == i)];
                    Assert.Equal(told.Length > 0, others.WasMoved(i));
                    Assert.True(told.Length == 0 || Same(told[^1].Motion, others[i].Motion));
                }
            }
        }
    }

    [Fact]
    public void A_motion_comes_back_field_by_field()
    {
        var random = new Random(82);
        for (int i = 0; i < 500; i++)
        {
            RigidMotion motion = Any(random);
            RigidMotion read = ReadBack(motion);
            Assert.Equal((motion.Origin, motion.Velocity, motion.Spin, motion.Time), (read.Origin, read.Velocity, read.Spin, read.Time));
            Assert.Equal((motion.Orientation, motion.IsTurned, motion.IsWithdrawn), (read.Orientation, read.IsTurned, read.IsWithdrawn));

            // The pivot is stored relative to the origin, so the last bit may differ.
            Assert.InRange(Vector3d.Distance(motion.Pivot, read.Pivot), 0, 1e-12);
        }
    }

    [Fact]
    public void A_motion_that_no_body_can_have_is_refused_by_name()
    {
        RigidMotion good = Any(new Random(83));
        ReadBack(good);
        Refused("body.position", good with { Origin = new Vector3d(double.NaN, 0, 0) });
        Refused("body.velocity", good with { Velocity = new Vector3d(0, double.PositiveInfinity, 0) });
        Refused("body.spin", good with { Spin = new Vector3d(0, 10_001, 0) });
        Refused("body.orientation", good with { Orientation = new Quaterniond(0, 0, 0, 1.001) });
        Refused("body.orientation", good with { Orientation = new Quaterniond(0, 0, 0, 0.999) });
        Refused("body.time", good with { Time = 1.1e12 });
        Refused("body.time", good with { Time = -1.1e12 });
        Refused("body.pivot", good with { Pivot = new Vector3d(double.NaN, 0, 0) });
        ReadBack(good with { Time = -1, Spin = new Vector3d(0, 9_999, 0) });

        static void Refused(string name, RigidMotion motion) =>
            Assert.StartsWith($"The bytes are broken: {name} is ", Assert.Throws<FormatException>(() => ReadBack(motion)).Message, StringComparison.Ordinal);
    }

    private static RigidMotion ReadBack(RigidMotion motion)
    {
        var writer = new ByteWriter();
        PlacementLog.Write(in motion, ref writer);
        byte[] bytes = writer.ToArray();
        var reader = new ByteReader(bytes);
        RigidMotion read = PlacementLog.ReadMotion(ref reader);
        reader.End();
        return read;
    }

    /// <summary>Numbers with few and with many digits, and zeros: each form of a number in the bytes.</summary>
    private static RigidMotion Any(Random random)
    {
        double Number() => random.Next(4) switch { 0 => 0, 1 => (float)((20 * random.NextDouble()) - 10), 2 => random.Next(-9, 9), _ => (20 * random.NextDouble()) - 10 };
        Vector3d Vector() => new(Number(), Number(), Number());
        Quaterniond orientation = random.Next(3) == 0 ? Quaterniond.Identity : new Quaterniond(Number(), Number(), Number(), 11).Normalized();
        return new RigidMotion
        {
            Origin = Vector(),
            Velocity = Vector(),
            Spin = Vector(),
            Pivot = Vector(),
            Orientation = orientation,
            IsTurned = orientation != Quaterniond.Identity,
            IsWithdrawn = random.Next(4) == 0,
            Time = Number(),
        };
    }

    private static bool Same(in RigidMotion a, in RigidMotion b) =>
        a.Origin == b.Origin && a.Velocity == b.Velocity && a.Spin == b.Spin && Vector3d.Distance(a.Pivot, b.Pivot) < 1e-12 && a.Orientation == b.Orientation
        && a.IsTurned == b.IsTurned && a.IsWithdrawn == b.IsWithdrawn && a.Time == b.Time;

    private static KinematicBodies Bodies(int count)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < count; i++)
        {
            bodies.Add("body", new SphereShape(Vector3d.Zero, 0.2), SurfaceMaterial.Board);
        }

        return bodies;
    }
}
