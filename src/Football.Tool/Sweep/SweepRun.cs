using System.Buffers;
using System.Collections.Concurrent;
using System.Threading.Tasks.Dataflow;
using FootballPhysics.Tool.Sweep.Columns;
using FootballPhysics.Tool.Sweep.Formats;
using FootballPhysics.Tool.Sweep.Output;
using FootballPhysics.Tool.Sweep.Rows;

namespace FootballPhysics.Tool.Sweep;

/// <summary>Makes the rows of a sweep on several threads, and hands them on in order; however many there are, only a few are in memory.</summary>
internal sealed class SweepRun
{
    /// <summary>Chunks that may wait for one before them, per thread.</summary>
    private const int Ahead = 2;

    private readonly SweepPlan _plan;
    private readonly int _jobs;
    private readonly int _rows;
    private readonly ConcurrentBag<RowMaker> _makers = [];
    private readonly ConcurrentBag<RowChunk> _chunks = [];

    /// <summary>Prepares.</summary>
    /// <param name="plan">The sweep.</param>
    /// <param name="format">The format's name.</param>
    /// <param name="jobs">How many threads.</param>
    public SweepRun(SweepPlan plan, string format, int jobs)
    {
        _plan = plan;
        _jobs = jobs;
        var first = RowMaker.Create(plan, 1);
        Columns = [.. first.Columns.Select(data => data.Column)];
        CountsHandedOn = first.FlownSingly is not null;
        Format = RowFormat.Create(format, Columns);
        _rows = Format.RowsAtOnce(Columns.Sum(column => column.Size * sizeof(double)));
    }

    /// <summary>The columns.</summary>
    public IReadOnlyList<Column> Columns { get; }

    /// <summary>How rows are written.</summary>
    public RowFormat Format { get; }

    /// <summary>Whether lanes hand rows to the single ball.</summary>
    public bool CountsHandedOn { get; }

    /// <summary>Makes the rows that a sink has not.</summary>
    /// <param name="shard">The part of the sweep.</param>
    /// <param name="sink">Where they go.</param>
    /// <param name="report">Told how many the sink has.</param>
    public async Task RunAsync(Shard shard, RowSink sink, Action<long> report)
    {
        var work = new TransformBlock<long, RowChunk>(
            from => Make(from, (int)Math.Min(_rows, shard.End - from)),
            new ExecutionDataflowBlockOptions { MaxDegreeOfParallelism = _jobs, BoundedCapacity = _jobs * Ahead, SingleProducerConstrained = true });
        Task asking = AskAsync(shard.First + sink.Rows, shard.End, work);
        try
        {
            await foreach (RowChunk chunk in work.ReceiveAllAsync().ConfigureAwait(false))
            {
                sink.Add(chunk.Files, chunk.Rows, chunk.FlownSingly);
                _chunks.Add(chunk);
                report(sink.Rows);
            }
        }
        finally
        {
            // If writing failed, no more rows are needed.
            work.Complete();
        }

        await work.Completion.ConfigureAwait(false);
        await asking.ConfigureAwait(false);
        sink.Finish();
    }

    private async Task AskAsync(long from, long end, TransformBlock<long, RowChunk> work)
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
        chunk.FlownSingly = maker.FlownSingly ?? 0;
        _makers.Add(maker);
        return chunk;
    }
}
