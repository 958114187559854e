using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>A cache of the compiled scenes of rows.</summary>
/// <typeparam name="T">The type of a compiled scene.</typeparam>
/// <param name="plan">The sweep.</param>
/// <param name="draws">The random values of the rows.</param>
/// <param name="compile">Compiles a scene.</param>
internal sealed class CompiledScenes<T>(SweepPlan plan, RowDraws draws, Func<SweepScene, T> compile)
    where T : class
{
    /// <summary>The maximum number of cached scenes.</summary>
    private const int Most = 256;

    private readonly bool _areCountable = plan.Scenes < long.MaxValue / 2;
    private readonly Dictionary<long, T> _kept = [];
    private T? _only;

    /// <summary>Returns the compiled scene of a row.</summary>
    /// <exception cref="RefusedException">The scene is invalid.</exception>
    public T Of(int row)
    {
        if (plan.SceneFields.Length == 0)
        {
            return _only ??= compile(plan.Scene);
        }

        if (!_areCountable)
        {
            return Make(row);
        }

        long key = draws.SceneKey(row);
        if (_kept.TryGetValue(key, out T? found))
        {
            return found;
        }

        if (_kept.Count == Most)
        {
            _kept.Clear();
        }

        return _kept[key] = Make(row);
    }

    private T Make(int row)
    {
        try
        {
            return plan.With(i => draws.Value(plan.SceneFields[i], row), compile);
        }
        catch (RefusedException refusal)
        {
            throw new RefusedException(FormattableString.Invariant($"row {draws.First + row}: {refusal.Message}"));
        }
    }
}
