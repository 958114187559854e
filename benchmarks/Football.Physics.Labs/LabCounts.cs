namespace FootballPhysics.Labs;

/// <summary>Counts of cases that run in parallel, by the columns of their table, and examples of those that fail.</summary>
internal sealed class LabCounts
{
    private readonly Lock _lock = new();
    private readonly Dictionary<string, object> _numbers = [];
    private readonly List<string> _examples = [];

    /// <summary>A count; 0 if nothing was added to it.</summary>
    public long this[string column]
    {
        get
        {
            lock (_lock)
            {
                return _numbers.GetValueOrDefault(column) is long count ? count : 0;
            }
        }
    }

    /// <summary>The failures, in order of their text.</summary>
    public IEnumerable<string> Examples => _examples.Order(StringComparer.Ordinal);

    /// <summary>Runs a number of cases in parts, on all processors.</summary>
    /// <param name="count">The number of cases.</param>
    /// <param name="perPart">The number of cases of a part.</param>
    /// <param name="run">Runs a part: the counts, the index of the part, and its number of cases.</param>
    public static LabCounts Of(int count, int perPart, Action<LabCounts, int, int> run)
    {
        var counts = new LabCounts();
        Parallel.For(0, (count + perPart - 1) / perPart, part => run(counts, part, Math.Min(perPart, count - (part * perPart))));
        return counts;
    }

    /// <summary>Adds to a count.</summary>
    public void Add(string column, long number = 1)
    {
        lock (_lock)
        {
            _numbers[column] = this[column] + number;
        }
    }

    /// <summary>Adds a case to a count if a condition holds.</summary>
    public void AddIf(bool holds, string column) => Add(column, holds ? 1 : 0);

    /// <summary>Keeps the largest number of a column.</summary>
    public void Most<T>(string column, T number)
        where T : struct, IComparable<T>
    {
        lock (_lock)
        {
            _numbers[column] = _numbers.GetValueOrDefault(column) is T most && most.CompareTo(number) >= 0 ? most : number;
        }
    }

    /// <summary>Counts a case that fails, and keeps it as an example.</summary>
    public void Require(bool holds, string column, FormattableString example)
    {
        AddIf(!holds, column);
        if (!holds)
        {
            lock (_lock)
            {
                _examples.Add(FormattableString.Invariant(example));
            }
        }
    }

    /// <summary>The cells of columns.</summary>
    public IEnumerable<object?> Cells(params IEnumerable<string> columns) => columns.Select(column => _numbers.GetValueOrDefault(column, 0L));
}
