using System.Buffers;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Formats;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>
/// Writes rows to the files of a folder. A checkpoint records the confirmed length of each file; a run after an interruption continues there. The
/// manifest replaces the checkpoint when all rows are written.
/// </summary>
internal sealed class FolderSink : RowSink
{
    private static readonly TimeSpan s_untilFirst = TimeSpan.FromSeconds(0.05);
    private static readonly TimeSpan s_untilLater = TimeSpan.FromSeconds(5);

    private readonly string _folder;
    private readonly Identity _identity;
    private readonly Shard _shard;
    private readonly FileRecord _schema;
    private readonly RowFormat _format;
    private readonly List<DataFile> _files = [];
    private readonly TimeProvider _time;
    private long _lastCheckpoint;
    private TimeSpan _untilCheckpoint = s_untilFirst;

    private FolderSink(string folder, Identity identity, Shard shard, RowCounts noRows, FileRecord schema, RowFormat format, TimeProvider time)
        : base(noRows)
    {
        _folder = folder;
        _identity = identity;
        _shard = shard;
        _schema = schema;
        _format = format;
        _time = time;
        _lastCheckpoint = time.GetTimestamp();
    }

    /// <summary>True if all rows existed before this run.</summary>
    public bool WasDone { get; private set; }

    /// <summary>Opens a folder: a new one, or one of an interrupted run of the same sweep.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="identity">The sweep.</param>
    /// <param name="shard">The part of the sweep.</param>
    /// <param name="format">The file format.</param>
    /// <param name="schema">The schema of the columns.</param>
    /// <param name="noRows">The counts of no rows.</param>
    /// <param name="time">The clock by which checkpoints are due.</param>
    /// <param name="verifies">True to read a finished folder and check its hashes. Default false.</param>
    /// <exception cref="RefusedException">The folder contains other files, or the disk is too full.</exception>
    public static FolderSink Open(string folder, Identity identity, Shard shard, RowFormat format, byte[] schema, RowCounts noRows, TimeProvider time, bool verifies = false)
    {
        try
        {
            Directory.CreateDirectory(folder);
        }
        catch (Exception e) when (OutputFile.IsFileFault(e))
        {
            throw new RefusedException($"--out {Quote.File(folder)} cannot be created. Pass a folder that can be written.");
        }

        Manifest? done = Manifest.Read(folder, Manifest.Done);
        Manifest? begun = done ?? Manifest.Read(folder, Manifest.Unfinished);
        if (begun is not null && (identity.Difference(begun.Identity) ?? (begun.Shard != shard ? $"it is {begun.Shard}" : null)) is { } difference)
        {
            throw new RefusedException($"--out {Quote.File(folder)} contains another sweep ({difference}). Pass a new folder, or the folder of an interrupted run of the same sweep.");
        }

        var sink = new FolderSink(folder, identity, shard, noRows, Schema.Record(schema), format, time);
        try
        {
            sink.Begin(done, begun, format, schema, verifies);
            return sink;
        }
        catch
        {
            sink.Dispose();
            throw;
        }
    }

    public override void Finish()
    {
        if (WasDone)
        {
            return;
        }

        for (int f = 0; f < _files.Count; f++)
        {
            _files[f].Write(_format.Footer(f, [_shard.Rows]));
            _files[f].FlushToDisk();
        }

        Now.Write(_folder, Manifest.Done, toDisk: true);
        File.Delete(Path.Combine(_folder, Manifest.Unfinished));
    }

    /// <summary>
    /// Writes a checkpoint, from which an interrupted run continues. It does not wait for the disk: after a power cut, the hash reveals lost bytes.
    /// </summary>
    public void Checkpoint()
    {
        Now.Write(_folder, Manifest.Unfinished, toDisk: false);
        _lastCheckpoint = _time.GetTimestamp();
    }

    public override void Dispose() => _files.ForEach(file => file.Dispose());

    protected override void Write(IReadOnlyList<ArrayBufferWriter<byte>> files)
    {
        for (int f = 0; f < files.Count; f++)
        {
            _files[f].Write(files[f].WrittenSpan);
        }
    }

    protected override void Added()
    {
        if (_time.GetElapsedTime(_lastCheckpoint) >= _untilCheckpoint)
        {
            Checkpoint();
            _untilCheckpoint = 2 * _untilCheckpoint < s_untilLater ? 2 * _untilCheckpoint : s_untilLater;
        }
    }

    private Manifest Now => new(_identity, _shard, Rows, Counts, [.. _files.Select(file => file.Record), _schema]);

    private void Begin(Manifest? done, Manifest? begun, RowFormat format, byte[] schema, bool verifies)
    {
        Rows = begun?.Rows ?? 0;
        Counts = begun?.Counts ?? Counts;
        WasDone = done is not null;
        if (done is not null)
        {
            foreach (FileRecord record in done.Files)
            {
                CheckThere(record, verifies);
            }

            return;
        }

        if (begun is not null)
        {
            // The order is fixed, so the process that locks the first file locks all of them.
            foreach (FileRecord record in begun.Files.Take(format.Files.Count))
            {
                _files.Add(DataFile.Continue(_folder, record));
            }

            return;
        }

        RefuseForeign(format);
        RefuseFull(format);
        for (int f = 0; f < format.Files.Count; f++)
        {
            _files.Add(DataFile.Create(_folder, format.Files[f], format.Header(f, _shard.Rows)));
        }

        File.Delete(Path.Combine(_folder, Schema.Name));
        File.WriteAllBytes(Path.Combine(_folder, Schema.Name), schema);
        Checkpoint();
    }

    /// <summary>Checks that a file of a finished folder exists and has its recorded length and, if requested, its recorded hash.</summary>
    private void CheckThere(FileRecord record, bool verifies)
    {
        string path = Path.Combine(_folder, record.Name);
        var file = new FileInfo(path);
        string? fault = !file.Exists ? "is missing"
            : file.Length != record.Bytes ? FormattableString.Invariant($"is incomplete: it has {file.Length} of {record.Bytes} bytes")
            : verifies && DataFile.HashOf(path) != record.Sha256 ? "was changed after it was written"
            : null;
        if (fault is not null)
        {
            throw new RefusedException($"{Quote.File(path)} {fault}. Remove the folder to start again.");
        }
    }

    /// <summary>
    /// Rejects files with the name of an output but without a checkpoint. It accepts files that contain only headers, from a run that ended at once.
    /// </summary>
    private void RefuseForeign(RowFormat format)
    {
        for (int f = 0; f < format.Files.Count; f++)
        {
            var file = new FileInfo(Path.Combine(_folder, format.Files[f]));
            if (file.Exists && (file.ResolveLinkTarget(returnFinalTarget: true) as FileInfo ?? file).Length > format.Header(f, _shard.Rows).Length)
            {
                throw new RefusedException($"--out {Quote.File(_folder)} contains a file of another origin, {Quote.File(file.Name)}. Pass a new folder, or the folder of an interrupted run of the same sweep.");
            }
        }
    }

    private void RefuseFull(RowFormat format)
    {
        long free = new DriveInfo(Path.GetFullPath(_folder)).AvailableFreeSpace;
        if (format.Bytes(_shard.Rows) is { } bytes && bytes > free)
        {
            throw new RefusedException("--out", FormattableString.Invariant($"{Quote.File(_folder)} with {free} bytes free"), FormattableString.Invariant($"at least the {bytes} bytes of these rows"));
        }
    }
}
