using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Output;

namespace FootballPhysics.Tool.Sweep;

/// <summary>The reasons why shards cannot be merged.</summary>
internal sealed class MergeFaults
{
    /// <summary>The maximum number of faults that are printed; the rest is only counted.</summary>
    private const int MostPrinted = 20;

    private readonly List<string> _faults = [];

    public bool Any => _faults.Count > 0;

    /// <summary>Finds the faults that are visible without reading the rows.</summary>
    public void Check(IReadOnlyList<ShardFolder> shards)
    {
        if (shards.Count == 0)
        {
            _faults.Add("there is no shard.");
            return;
        }

        ShardFolder first = shards[0];
        int of = first.Manifest.Shard.Of;
        foreach (ShardFolder shard in shards)
        {
            if (first.Manifest.Identity.Difference(shard.Manifest.Identity) is { } difference)
            {
                _faults.Add($"{shard.Name} is of another sweep than {first.Name}: {difference}.");
            }
            else if (shard.Manifest.Shard.Of != of)
            {
                _faults.Add($"{shard.Name} is {shard.Manifest.Shard}, but {first.Name} is {first.Manifest.Shard}.");
            }
            else if (!shard.Manifest.Files.Select(file => file.Name).SequenceEqual(first.Manifest.Files.Select(file => file.Name)))
            {
                _faults.Add($"{shard.Name} has other files than {first.Name}.");
            }
        }

        ILookup<int, ShardFolder> byIndex = shards.Where(shard => shard.Manifest.Shard.Of == of).ToLookup(shard => shard.Manifest.Shard.Index);
        for (int i = 1; i <= of; i++)
        {
            ShardFolder[] found = [.. byIndex[i]];
            if (found.Length == 0)
            {
                _faults.Add($"{new Shard(i, of, first.Manifest.Identity.Count)} is missing.");
            }
            else if (found.Length > 1)
            {
                _faults.Add($"{found[0].Manifest.Shard} exists twice: {string.Join(", ", found.Select(shard => shard.Name))}.");
            }
        }

        foreach (ShardFolder shard in shards)
        {
            CheckFiles(shard);
        }
    }

    /// <summary>Adds a file that differs from its manifest.</summary>
    public void Damaged(ShardFolder shard, FileRecord file) => Differs(shard, file, "damaged", "other bytes than its manifest says");

    private void Differs(ShardFolder shard, FileRecord file, string how, string content) =>
        _faults.Add($"{shard.Manifest.Shard} is {how}: {Quote.Short(shard.Name)}/{file.Name} has {content}.");

    public void Print(TextWriter to)
    {
        foreach (string fault in _faults.Take(MostPrinted))
        {
            to.WriteLine($"football: {fault}");
        }

        if (_faults.Count > MostPrinted)
        {
            to.WriteLine(FormattableString.Invariant($"football: and {_faults.Count - MostPrinted} more."));
        }
    }

    private void CheckFiles(ShardFolder shard)
    {
        if (!shard.IsDone)
        {
            _faults.Add(FormattableString.Invariant($"{shard.Manifest.Shard} is not finished: {shard.Name} has {shard.Manifest.Rows} of {shard.Manifest.Shard.Rows} rows."));
            return;
        }

        foreach (FileRecord record in shard.Manifest.Files)
        {
            var file = new FileInfo(Path.Combine(shard.Path, record.Name));
            long bytes = file.Exists ? file.Length : 0;
            if (bytes != record.Bytes)
            {
                Differs(shard, record, "incomplete", FormattableString.Invariant($"{bytes} of {record.Bytes} bytes"));
            }
        }
    }
}
