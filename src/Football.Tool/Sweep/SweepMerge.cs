using System.CommandLine;
using System.Security.Cryptography;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Formats;
using FootballPhysics.Tool.Sweep.Output;

namespace FootballPhysics.Tool.Sweep;

/// <summary>football sweep merge: merges the shards in a folder. The result is byte for byte that of a single process.</summary>
internal sealed class SweepMerge
{
    private const int Chunk = 1 << 20;

    /// <summary>The suffix of the names of unverified files.</summary>
    private const string New = ".new";

    private readonly string _folder;
    private readonly MergeFaults _faults = new();
    private readonly List<string> _made = [];
    private readonly byte[] _chunk = new byte[Chunk];

    private SweepMerge(string folder) => _folder = folder;

    public static Command Create(Terminal terminal)
    {
        var folder = new Argument<string>("DIR") { Description = "Folder that --out named for all shards." };
        var command = new ExampleCommand(
            "merge",
            "Check the shards in a folder and write the files of the complete sweep next to them. It lists missing, duplicate, unfinished and damaged shards.",
            "football sweep --count 100 --shard 1/2 --out rows; football sweep --count 100 --shard 2/2 --out rows; football sweep merge rows && cat rows/manifest.json")
        {
            folder,
        };
        command.SetAction(parsed => new SweepMerge(parsed.GetRequiredValue(folder)).Run(terminal));
        return command;
    }

    private int Run(Terminal terminal)
    {
        if (!Directory.Exists(_folder))
        {
            throw new RefusedException($"DIR {Quote.File(_folder)} is not a folder. Pass the folder that contains the shards.");
        }

        List<ShardFolder> shards = ShardFolder.All(_folder);
        _faults.Check(shards);
        if (!_faults.Any)
        {
            Manifest merged = Progress.Show(terminal, "bytes", progress => Merge([.. shards.OrderBy(shard => shard.Manifest.Shard.Index)], progress));
            if (!_faults.Any)
            {
                merged.Write(_folder, Manifest.Done, toDisk: true);
                terminal.Person.WriteLine(FormattableString.Invariant($"{_folder}: {merged.Rows} rows of {shards.Count} shards"));
                return ExitCode.Done;
            }
        }

        _faults.Print(terminal.Error);
        return ExitCode.Refused;
    }

    private Manifest Merge(List<ShardFolder> shards, Progress progress)
    {
        Manifest first = shards[0].Manifest;
        Manifest? before = Manifest.Read(_folder, Manifest.Done);
        if (before is not null && (first.Identity.Difference(before.Identity) is not null || before.Shard.Of != 1))
        {
            throw new RefusedException($"DIR {Quote.File(_folder)} contains another sweep next to its shards. Pass a folder that contains only shards.");
        }

        if (before is null && File.Exists(Path.Combine(_folder, Manifest.Unfinished)))
        {
            throw new RefusedException($"DIR {Quote.File(_folder)} contains an unfinished sweep next to its shards. Pass a folder that contains only shards.");
        }

        try
        {
            Manifest merged = WriteNew(shards, progress);
            if (!_faults.Any)
            {
                // Delete the manifest first: without it, a mix of old and new files does not count as a complete sweep.
                File.Delete(Path.Combine(_folder, Manifest.Done));
                foreach (FileRecord file in merged.Files)
                {
                    File.Move(Path.Combine(_folder, file.Name + New), Path.Combine(_folder, file.Name), overwrite: true);
                }
            }

            return merged;
        }
        finally
        {
            // Delete only files of this merge: another merge may be running.
            _made.ForEach(File.Delete);
        }
    }

    /// <summary>Writes the merged files under temporary names.</summary>
    private Manifest WriteNew(List<ShardFolder> shards, Progress progress)
    {
        Manifest first = shards[0].Manifest;
        long total = shards.Sum(shard => shard.Manifest.Files.Sum(file => file.Bytes));
        long done = 0;
        RowFormat format = RowFormat.Create(first.Identity.Format, Schema.Read(Path.Combine(shards[0].Path, Schema.Name)));
        List<FileRecord> files = [];
        for (int f = 0; f < first.Files.Count; f++)
        {
            using var to = DataFile.Create(_folder, first.Files[f].Name + New, Header(shards[0], f, first.Identity));
            _made.Add(Path.Combine(_folder, first.Files[f].Name + New));
            foreach (ShardFolder shard in shards)
            {
                // All shards have the same schema.
                bool copies = first.Files[f].Name != Schema.Name;
                Copy(shard, shard.Manifest.Files[f], copies ? format.Footer(f, [shard.Manifest.Rows]).Length : 0, copies ? to : null);
                done += shard.Manifest.Files[f].Bytes;
                progress.Report(done, total);
            }

            if (first.Files[f].Name != Schema.Name)
            {
                to.Write(format.Footer(f, [.. shards.Select(shard => shard.Manifest.Rows)]));
            }

            to.FlushToDisk();
            files.Add(to.Record with { Name = first.Files[f].Name });
        }

        return new Manifest(
            first.Identity,
            new Shard(1, 1, first.Identity.Count),
            first.Identity.Count,
            shards.Select(shard => shard.Manifest.Counts).Aggregate((sum, counts) => sum + counts),
            files);
    }

    /// <summary>Returns the header of the merged file: that of the first shard with the total number of rows.</summary>
    private static byte[] Header(ShardFolder shard, int file, Identity identity)
    {
        FileRecord record = shard.Manifest.Files[file];
        using FileStream from = File.OpenRead(Path.Combine(shard.Path, record.Name));
        byte[] header = new byte[record.Header];
        from.ReadExactly(header);
        return record.Name.EndsWith(".npy", StringComparison.Ordinal) ? NumpyHeader.WithRows(header, identity.Count) : header;
    }

    /// <summary>Copies the rows between the header and the footer, and checks the hash.</summary>
    private void Copy(ShardFolder shard, FileRecord record, int footer, DataFile? to)
    {
        using FileStream from = File.OpenRead(Path.Combine(shard.Path, record.Name));
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        long at = 0;
        while (from.Read(_chunk) is > 0 and int read)
        {
            hash.AppendData(_chunk, 0, read);
            int skipped = (int)Math.Clamp(record.Header - at, 0, read);
            int end = (int)Math.Clamp(record.Bytes - footer - at, skipped, read);
            to?.Write(_chunk.AsSpan(skipped, end - skipped));
            at += read;
        }

        if (Convert.ToHexStringLower(hash.GetHashAndReset()) != record.Sha256)
        {
            _faults.Damaged(shard, record);
        }
    }
}
