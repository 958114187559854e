using System.Buffers;
using System.Collections.Concurrent;
using System.Threading.Tasks.Dataflow;
using FootballPhysics.Tool.Sweep.Columns;
using FootballPhysics.Tool.Sweep.Formats;
using FootballPhysics.Tool.Sweep.Output;
using FootballPhysics.Tool.Sweep.Rows;

namespace FootballPhysics.Tool.Sweep;

/// <summary>
/// Computes the rows of a sweep on several threads, and writes them in order. It holds only a few rows in memory, regardless of their total number.
/// </summary>
internal sealed class SweepRun
{
    /// <summary>The maximum number of chunks in progress, per thread. Chunks wait for earlier ones.</summary>
    private const int Ahead = 2;

    private readonly SweepPlan _plan;
    private readonly int _jobs;
    private readonly int _rows;
    private readonly ConcurrentBag<RowMaker> _makers = [];
    private readonly ConcurrentBag<RowChunk> _chunks = [];

    /// <summary>Creates a run.</summary>
    /// <param name="plan">The sweep.</param>
    /// <param name="format">The name of the format.</param>
    /// <param name="jobs">The number of threads.</param>
    public SweepRun(SweepPlan plan, string format, int jobs)
    {
        _plan = plan;
        _jobs = jobs;
        var first = RowMaker.Create(plan, 1);
        Columns = [.. first.Columns.Select(data => data.Column)];
        NoRows = first.Counts;
        Format = RowFormat.Create(format, Columns);
        _rows = Format.RowsAtOnce(Columns.Sum(column => column.Size * sizeof(double)));
    }

    public IReadOnlyList<Column> Columns { get; }

    /// <summary>The file format.</summary>
    public RowFormat Format { get; }

    /// <summary>The counts of no rows: zero for each count that the output has, null for the others.</summary>
    public RowCounts NoRows { get; }

    /// <summary>Computes the rows that a sink does not contain yet.</summary>
    /// <param name="shard">The part of the sweep.</param>
    /// <param name="sink">The destination.</param>
    /// <param name="report">Receives the number of rows in the sink.</param>
    public async Task RunAsync(Shard shard, RowSink sink, Action<long> report)
    {
        var work = new TransformBlock<long, RowChunk>(
            from => Make(from, (int)Math.Min(_rows, shard.End - from)),
            new ExecutionDataflowBlockOptions { MaxDegreeOfParallelism = _jobs, BoundedCapacity = _jobs * Ahead, SingleProducerConstrained = true });
        Task scheduling = ScheduleAsync(shard.First + sink.Rows, shard.End, work);
        try
        {
            await foreach (RowChunk chunk in work.ReceiveAllAsync().ConfigureAwait(false))
            {
                sink.Add(chunk.Files, chunk.Rows, chunk.Counts);
                _chunks.Add(chunk);
                report(sink.Rows);
            }
        }
        finally
        {
            // If writing failed, schedule no further rows.
            work.Complete();
        }

        await work.Completion.ConfigureAwait(false);
        await scheduling.ConfigureAwait(false);
        sink.Finish();
    }

    private async Task ScheduleAsync(long from, long end, TransformBlock<long, RowChunk> work)
    {
        while (from < end && await work.SendAsync(from).ConfigureAwait(false))
        {
            from += _rows;
        }

        work.Complete();
    }

    private RowChunk Make(long from, int count)
    {
        RowMaker maker = _makers.TryTake(out RowMaker? free) ? free : RowMaker.Create(_plan, _rows);
        RowChunk chunk = _chunks.TryTake(out RowChunk? used) ? used : new RowChunk(Format.Files.Count);
        maker.Make(from, count);
        foreach (ArrayBufferWriter<byte> file in chunk.Files)
        {
            file.ResetWrittenCount();
        }

        Format.Write(maker.Columns, count, chunk.Files);
        chunk.Rows = count;
        chunk.Counts = maker.Counts;
        _makers.Add(maker);
        return chunk;
    }
}
