using System.CommandLine;
using System.Xml.Linq;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs;

/// <summary>One run of an experiment: its options, its progress, and its results, which are tables, and pictures on request.</summary>
internal sealed class LabRun(string name, long seed, Progress progress, ParseResult? parsed = null, Terminal? terminal = null)
{
    private bool _failed;

    public string Name { get; set; } = name;

    public long Seed => seed;

    public Progress Progress => progress;

    /// <summary>The terminal, for output before the tables.</summary>
    public Terminal Terminal => terminal!;

    public List<LabTable> Tables { get; } = [];

    /// <summary>Lines below the tables.</summary>
    public List<string> Notes { get; } = [];

    /// <summary>The table that the CSV contains instead of the tables; null if it contains the tables.</summary>
    public LabTable? Rows { get; set; }

    /// <summary>Draws the picture.</summary>
    public Func<XElement>? Picture { get; set; }

    /// <summary>True if a case failed, or a table that is judged does not hold.</summary>
    public bool Failed
    {
        get => _failed || Tables.Exists(table => !table.Holds);
        set => _failed = value;
    }

    /// <summary>Returns the value of an option.</summary>
    public T? Get<T>(Option<T> option) => parsed!.GetValue(option);

    public int Int(Option<long> option) => (int)Get(option);

    /// <summary>True if an option was given.</summary>
    public bool Has(Option option) => parsed!.GetResult(option) is { Implicit: false };

    /// <summary>Adds a table.</summary>
    public LabTable Table(string title, params string[] columns)
    {
        var table = new LabTable(title, columns);
        Tables.Add(table);
        return table;
    }

    /// <summary>Returns the random numbers of a case.</summary>
    public SeededRandom Random(long index) => new(SeededRandom.Mix(seed, index));

    /// <summary>Runs cases one by one, each with random numbers of its own.</summary>
    /// <param name="count">The number of cases.</param>
    /// <param name="what">The name of a case.</param>
    /// <param name="play">Runs a case, with its random numbers and its index.</param>
    public void Each(int count, string what, Action<SeededRandom, int> play)
    {
        for (int i = 0; i < count; i++)
        {
            int at = i;
            progress.Report(i, count, () => FormattableString.Invariant($"{what} {at}"));
            play(Random(i), i);
        }
    }

    /// <summary>Runs cases on several threads, and returns their results.</summary>
    public T[] Parallel<T>(long count, int jobs, string what, Func<long, T> play)
    {
        var all = new T[count];
        Parallel(0, count, jobs, what, i => all[i] = play(i));
        return all;
    }

    /// <summary>Runs cases on several threads.</summary>
    /// <param name="first">The number of the first case.</param>
    /// <param name="count">The number of cases.</param>
    /// <param name="jobs">The number of threads.</param>
    /// <param name="what">The name of the cases.</param>
    /// <param name="play">Runs a case.</param>
    public void Parallel(long first, long count, int jobs, string what, Action<long> play)
    {
        long every = 1 + (count / 4096);
        long done = 0;
        var gate = new Lock();
        System.Threading.Tasks.Parallel.For(first, first + count, new ParallelOptions { MaxDegreeOfParallelism = jobs }, i =>
        {
            play(i);
            lock (gate)
            {
                if (++done % every == 0)
                {
                    progress.Report(done, count, () => what);
                }
            }
        });
    }
}
