using System.Reflection;

namespace FootballPhysics.Tests.Motion;

/// <summary>A buffer of events has a size: beyond it they are counted.</summary>
public sealed class EventBufferTests
{
    [Theory]
    [InlineData(32)]
    [InlineData(33)]
    [InlineData(100)]
    public void The_first_and_the_last_are_kept_and_those_between_are_counted(int most)
    {
        var buffer = new EventBuffer(1, most);
        for (int n = 1; n < 400; n++)
        {
            buffer.Add(Impact(n));
            Assert.Equal(Math.Min(n, most), buffer.Count);
            Assert.Equal(n - buffer.Count, buffer.Dropped);
            Assert.Equal(n, buffer.Impacts);
            int first = buffer.Dropped > 0 ? most - EventBuffer.TailCount : buffer.Count;
            Assert.Equal(Enumerable.Range(1, first).Concat(Enumerable.Range(n - (buffer.Count - first) + 1, buffer.Count - first)).Select(i => (double)i), Times(buffer));
        }

        buffer.Clear();
        Assert.Equal((0, 0L, 0L), (buffer.Count, buffer.Dropped, buffer.Impacts));
    }

    /// <summary>A log that takes in another one has the events and counts of both.</summary>
    [Fact]
    public void A_log_takes_in_the_events_and_counts_of_another()
    {
        StepLog first = Flown(3);
        StepLog second = Flown(7);
        (int events, long steps, long evaluations) = (first.Events.Count, first.Steps, first.Evaluations);
        Assert.True(events > 0 && second.Events.Count > 0 && second.Evaluations > 0);
        first.Add(second);
        Assert.Equal(events + second.Events.Count, first.Events.Count);
        Assert.Equal(second.Events[0].Time, first.Events[events].Time);
        Assert.Equal(steps + second.Steps, first.Steps);
        Assert.Equal(evaluations + second.Evaluations, first.Evaluations);

        static StepLog Flown(double speed)
        {
            var simulator = new Simulator(Scene.Default);
            BallState s = simulator.Launch(new Vector3d(0, 0.3, 0), new Vector3d(speed, 0, 0), Vector3d.Zero);
            var log = new StepLog();
            for (int i = 0; i < 50; i++)
            {
                simulator.Step(ref s, 0.01, log);
            }

            return log;
        }
    }

    [Fact]
    public void It_grows_no_further_than_that()
    {
        var buffer = new EventBuffer();
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int n = 0; n < 1_000_000; n++)
        {
            buffer.Add(Impact(n));
        }

        Assert.Equal((EventBuffer.DefaultMost, 1_000_000L - EventBuffer.DefaultMost), (buffer.Count, buffer.Dropped));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 3L * EventBuffer.DefaultMost * System.Runtime.CompilerServices.Unsafe.SizeOf<BallEvent>());
    }

    [Fact]
    public void What_is_taken_back_was_never_there()
    {
        var buffer = new EventBuffer(1, 40);
        for (int n = 1; n <= 30; n++)
        {
            buffer.Add(Impact(n));
        }

        for (int more = 1; more < 30; more++)
        {
            for (int n = 31; n <= 30 + more; n++)
            {
                buffer.Add(Impact(n));
            }

            buffer.TakeBack(30, 0, 30);
            Assert.Equal(30, buffer.Impacts);
            Assert.Equal(30, buffer.Count + buffer.Dropped);
            Assert.Equal(Enumerable.Range(1, buffer.Count).Select(i => (double)i), Times(buffer));
            for (int n = buffer.Count + 1; n <= 30; n++)
            {
                buffer.Add(Impact(n));
            }

            buffer.TakeBack(buffer.Count, 0, 30);
        }
    }

    [Fact]
    public void A_buffer_too_small_to_keep_both_is_refused()
    {
        Assert.Equal("most", Assert.Throws<ArgumentOutOfRangeException>(() => new EventBuffer(1, 31)).ParamName);
        Assert.Equal("capacity", Assert.Throws<ArgumentOutOfRangeException>(() => new EventBuffer(33, 32)).ParamName);
        Assert.Equal("capacity", Assert.Throws<ArgumentOutOfRangeException>(() => new EventBuffer(0)).ParamName);
        Assert.Equal("most", Assert.Throws<ArgumentOutOfRangeException>(() => new StepLog(mostEvents: 2)).ParamName);
    }

    /// <summary>A ball that hops without loss for a minute, in steps of a minute: the last event is still the last.</summary>
    [Fact]
    public void A_run_with_more_events_than_there_is_room_for_keeps_count()
    {
        Scene scene = Scene.Vacuum with { Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { NormalRestitution = 1 }, MinimumBounceSpeed = 0.001 } };
        var simulator = new Simulator(scene);
        BallState all = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0.02, 0), Vector3d.Zero);
        BallState few = all;
        var every = new StepLog(mostEvents: 1 << 20);
        var some = new StepLog(1, 32);
        simulator.Run(ref all, 0.01, 20, StopAt.Time, every);
        simulator.Run(ref few, 0.01, 20, StopAt.Time, some);
        Assert.True(Snapshot.Same(all, few));
        Assert.Equal(0, every.Events.Dropped);
        Assert.True(every.Events.Count > 1000);
        Assert.Equal(every.Events.Count, some.Events.Count + some.Events.Dropped);
        Assert.Equal(every.Events[^1].Time, some.Events[^1].Time);
        Assert.Equal(every.Events[0].Time, some.Events[0].Time);
    }

    [Fact]
    public void A_runner_hands_on_what_its_steps_missed()
    {
        var to = new EventBuffer(1, 32);
        var from = new EventBuffer(1, 32);
        for (int n = 1; n <= 50; n++)
        {
            from.Add(Impact(n));
        }

        to.Add(from);
        to.Add(from);
        Assert.Equal((32, 68L), (to.Count, to.Dropped));
        Assert.Equal((1.0, 50.0), (to[0].Time, to[31].Time));
    }

    private static double[] Times(EventBuffer buffer) => [.. buffer.Span.ToArray().Select(item => item.Time)];

    private static BallEvent Impact(int time) => new(BallEventKind.Impact, 0, default, time, default, default, default, default, default);

    /// <summary>Every count of a log is added, taken back and cleared; none is lost.</summary>
    [Fact]
    public void A_log_adds_takes_back_and_clears_every_count()
    {
        PropertyInfo[] counts = [.. typeof(StepLog).GetProperties().Where(count => count.PropertyType == typeof(long))];
        Assert.InRange(counts.Length, 5, 20);
        StepLog log = With(7);
        StepLogMark mark = log.Mark();
        log.Add(With(20));
        Assert.All(counts, count => Assert.Equal(27 + (2L * Array.IndexOf(counts, count)), count.GetValue(log)));
        log.TakeBack(in mark);
        Assert.All(counts, count => Assert.Equal(7L + Array.IndexOf(counts, count), count.GetValue(log)));
        log.Clear();
        Assert.All(counts, count => Assert.Equal(0L, count.GetValue(log)));

        StepLog With(long first)
        {
            var one = new StepLog();
            for (int i = 0; i < counts.Length; i++)
            {
                counts[i].SetValue(one, first + i);
            }

            return one;
        }
    }
}
