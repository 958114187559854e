using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Makes rows, on one thread.</summary>
internal abstract class RowMaker
{
    private readonly int _capacity;
    private IReadOnlyList<ColumnSource>? _sources;
    private IReadOnlyList<ColumnSource>? _chosen;
    private IReadOnlyList<ColumnData>? _columns;

    protected RowMaker(SweepPlan plan, int capacity)
    {
        Plan = plan;
        Draws = new RowDraws(plan, capacity);
        _capacity = capacity;
    }

    /// <summary>The columns that rows can have.</summary>
    public IReadOnlyList<ColumnSource> Sources => _sources ??= [.. DrawnSources(), .. AnswerSources()];

    /// <summary>The columns that rows have.</summary>
    public IReadOnlyList<ColumnData> Columns => _columns ??= [.. Chosen.Select(source => new ColumnData(source.Column, _capacity))];

    /// <summary>The number of the last rows that the SIMD batch passed to the scalar simulation; null if there is no batch.</summary>
    public abstract long? FlownSingly { get; }

    protected SweepPlan Plan { get; }

    protected RowDraws Draws { get; }

    private IReadOnlyList<ColumnSource> Chosen => _chosen ??= Plan.Row.Columns.Count == 0
        ? [.. Sources.Where(source => source.IsDefault)]
        : [.. Plan.Row.Columns.Select(Find)];

    /// <summary>Makes a maker for a sweep.</summary>
    /// <param name="plan">The sweep.</param>
    /// <param name="capacity">Most rows at a time.</param>
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

    /// <summary>Makes rows; their values are in <see cref="Columns"/> then.</summary>
    /// <param name="first">The first.</param>
    /// <param name="count">How many.</param>
    /// <exception cref="RefusedException">A scene or a launch that was drawn is refused.</exception>
    public void Make(long first, int count)
    {
        Draws.Draw(first, count);
        try
        {
            Answer(count);
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, new InputFields(default)) is { } said)
        {
            throw new RefusedException(FormattableString.Invariant($"rows {first} to {first + count - 1}: {said.Message}"));
        }
    }

    /// <summary>The scene of a row whose columns are being filled, as far as columns of launches and aims depend on it.</summary>
    protected virtual SweepScene SceneOf(int row) => Plan.Scene;

    /// <summary>Answers what was drawn, and fills the columns.</summary>
    protected abstract void Answer(int count);

    /// <summary>The columns of the answers.</summary>
    protected abstract IEnumerable<ColumnSource> AnswerSources();

    /// <summary>Fills all columns of some rows.</summary>
    protected void Fill(int from, int count)
    {
        for (int i = 0; i < Columns.Count; i++)
        {
            Chosen[i].Fill(Columns[i], from, count);
        }
    }

    /// <summary>Copies vectors.</summary>
    protected static Action<ColumnData, int, int> Vectors(Vector3dColumns vectors) => (to, from, count) =>
    {
        for (int i = from; i < from + count; i++)
        {
            to.Reals[3 * i] = vectors.X[i];
            to.Reals[(3 * i) + 1] = vectors.Y[i];
            to.Reals[(3 * i) + 2] = vectors.Z[i];
        }
    };

    /// <summary>Copies numbers.</summary>
    protected static Action<ColumnData, int, int> Numbers(double[] numbers) => (to, from, count) => Array.Copy(numbers, from, to.Reals, from, count);

    private ColumnSource Find(string name)
    {
        IEnumerable<string> names = Sources.Select(source => source.Column.Name);
        return Sources.FirstOrDefault(source => source.Column.Name == name) ?? throw new RefusedException(
            "row.columns", Quote.Short(name), string.Join(" | ", names));
    }

    /// <summary>The row's number and its random values; for a kick all five numbers, even if they are fixed.</summary>
    private IEnumerable<ColumnSource> DrawnSources()
    {
        yield return new ColumnSource(Column.Whole("index", "", "number of the row in the whole sweep, from 0"), (to, from, count) =>
        {
            for (int i = from; i < from + count; i++)
            {
                to.Wholes[i] = Draws.First + i;
            }
        });
        IReadOnlyList<DirectField> direct = Plan.Scene.Aim is null ? DirectField.OfLaunch : DirectField.OfAim;
        bool isKick = Plan.Scene.Aim is null && !Plan.Scene.HasVectors;
        for (int n = 0; n < direct.Count; n++)
        {
            int number = n;
            if (Plan.FieldOf[n] >= 0 || (isKick && n < DirectField.KickNumbers))
            {
                yield return new ColumnSource(Column.Real(direct[n].Column, direct[n].Unit, $"{direct[n].Path}, as drawn"), (to, from, count) =>
                {
                    for (int i = from; i < from + count; i++)
                    {
                        to.Reals[i] = Draws.Number(SceneOf(i), number, i);
                    }
                });
            }
        }

        foreach (int f in Plan.SceneFields)
        {
            yield return new ColumnSource(Plan.Fields[f].Column, (to, from, count) =>
            {
                for (int i = from; i < from + count; i++)
                {
                    if (to.Column.Kind == ColumnKind.Word)
                    {
                        to.Words[i] = (byte)Draws.Value(f, i).Choice;
                    }
                    else
                    {
                        to.Reals[i] = Draws.Value(f, i).Number;
                    }
                }
            });
        }
    }
}
