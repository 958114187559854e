using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Computes rows, on one thread.</summary>
internal abstract class RowMaker(SweepPlan plan, int capacity)
{
    private readonly int _capacity = capacity;
    private IReadOnlyList<ColumnSource>? _sources;
    private IReadOnlyList<ColumnSource>? _chosen;
    private IReadOnlyList<ColumnData>? _columns;

    /// <summary>All possible columns.</summary>
    public IReadOnlyList<ColumnSource> Sources => _sources ??= [.. DrawnSources(), .. AnswerSources()];

    public IReadOnlyList<ColumnData> Columns => _columns ??= [.. Chosen.Select(source => new ColumnData(source.Column, _capacity))];

    /// <summary>The counts of the last rows; zeros before the first.</summary>
    public abstract RowCounts Counts { get; }

    protected SweepPlan Plan { get; } = plan;

    protected RowDraws Draws { get; } = new(plan, capacity);

    private IReadOnlyList<ColumnSource> Chosen => _chosen ??= Plan.Row.Columns.Count == 0
        ? [.. Sources.Where(source => source.IsDefault)]
        : [.. Plan.Row.Columns.Select(Find)];

    /// <summary>Creates an instance for a sweep.</summary>
    /// <param name="plan">The sweep.</param>
    /// <param name="capacity">The maximum number of rows at a time.</param>
    /// <exception cref="RefusedException">There is no such column.</exception>
    public static RowMaker Create(SweepPlan plan, int capacity)
    {
        RowMaker maker = plan.AimsInLanes ? new BatchAimRows(plan, capacity)
            : plan.Scene.Aim is not null ? new AimRows(plan, capacity)
            : plan.FliesInLanes ? new FlightRows(plan, capacity)
            : new PlayRows(plan, capacity);
        _ = maker.Columns;
        return maker;
    }

    /// <summary>Computes rows; <see cref="Columns"/> then contains their values.</summary>
    /// <param name="first">The index of the first row.</param>
    /// <param name="count">The number of rows.</param>
    /// <exception cref="RefusedException">A random scene or launch is invalid.</exception>
    public void Make(long first, int count)
    {
        Draws.Draw(first, count);
        try
        {
            Answer(count);
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, new InputFields(default)) is { } translated)
        {
            throw new RefusedException(FormattableString.Invariant($"rows {first} to {first + count - 1}: {translated.Message}"));
        }
    }

    /// <summary>Returns the scene of the row whose columns are being filled. Only columns of launches and aims use it.</summary>
    protected virtual SweepScene SceneOf(int row) => Plan.Scene;

    /// <summary>Computes the results of the random values, and fills the columns.</summary>
    protected abstract void Answer(int count);

    /// <summary>Returns the columns of the results.</summary>
    protected abstract IEnumerable<ColumnSource> AnswerSources();

    /// <summary>True if the rows have a column of this name.</summary>
    protected bool Writes(string name) => Chosen.Any(source => source.Column.Name == name);

    /// <summary>Fills all columns of some rows.</summary>
    protected void Fill(int from, int count)
    {
        for (int i = 0; i < Columns.Count; i++)
        {
            Chosen[i].Fill(Columns[i], from, count);
        }
    }

    /// <summary>Returns a function that sets a column row by row.</summary>
    protected static Action<ColumnData, int, int> Each(Action<ColumnData, int> set) => (to, from, count) =>
    {
        for (int i = from; i < from + count; i++)
        {
            set(to, i);
        }
    };

    /// <summary>Returns a function that copies vectors to a column.</summary>
    protected static Action<ColumnData, int, int> Vectors(Vector3dColumns vectors) => (to, from, count) =>
    {
        for (int i = from; i < from + count; i++)
        {
            to.Reals[3 * i] = vectors.X[i];
            to.Reals[(3 * i) + 1] = vectors.Y[i];
            to.Reals[(3 * i) + 2] = vectors.Z[i];
        }
    };

    /// <summary>Returns a function that copies numbers to a column.</summary>
    protected static Action<ColumnData, int, int> Numbers(double[] numbers) => (to, from, count) => Array.Copy(numbers, from, to.Reals, from, count);

    private ColumnSource Find(string name)
    {
        IEnumerable<string> names = Sources.Select(source => source.Column.Name);
        return Sources.FirstOrDefault(source => source.Column.Name == name) ?? throw new RefusedException(
            "row.columns", Quote.Short(name), string.Join(" | ", names));
    }

    /// <summary>Returns the columns of the row's index and random values. For a kick, all five numbers are included even if they are fixed.</summary>
    private IEnumerable<ColumnSource> DrawnSources()
    {
        yield return new ColumnSource(Column.Whole("index", "", "number of the row in the whole sweep, from 0"), Each((to, i) => to.Wholes[i] = Draws.First + i));
        IReadOnlyList<DirectField> direct = Plan.Scene.Aim is null ? DirectField.OfLaunch : DirectField.OfAim;
        bool isKick = Plan.Scene.Aim is null && !Plan.Scene.HasVectors;
        for (int n = 0; n < direct.Count; n++)
        {
            int number = n;
            if (Plan.FieldOf[n] >= 0 || (isKick && n < DirectField.KickNumbers))
            {
                yield return new ColumnSource(Column.Real(direct[n].Column, direct[n].Unit, $"{direct[n].Path}, as drawn"), Each((to, i) => to.Reals[i] = Draws.Number(SceneOf(i), number, i)));
            }
        }

        foreach (int f in Plan.SceneFields)
        {
            yield return new ColumnSource(Plan.Fields[f].Column, Each((to, i) =>
            {
                if (to.Column.Kind == ColumnKind.Word)
                {
                    to.Words[i] = (byte)Draws.Value(f, i).Choice;
                }
                else
                {
                    to.Reals[i] = Draws.Value(f, i).Number;
                }
            }));
        }
    }
}
