using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>The random values of some rows.</summary>
internal sealed class RowDraws
{
    private readonly SweepPlan _plan;
    private readonly FieldValue[][] _values;

    public RowDraws(SweepPlan plan, int capacity)
    {
        _plan = plan;
        _values = [.. plan.Fields.Select(_ => new FieldValue[capacity])];
    }

    /// <summary>The first of the rows.</summary>
    public long First { get; private set; }

    /// <summary>Draws rows.</summary>
    public void Draw(long first, int count)
    {
        First = first;
        for (int f = 0; f < _values.Length; f++)
        {
            FieldRange range = _plan.Fields[f].Range;
            ulong stream = _plan.Streams[f];
            FieldValue[] values = _values[f];
            for (int i = 0; i < count; i++)
            {
                values[i] = range.Draw(CounterRandom.At(stream, first + i), first + i);
            }
        }
    }

    /// <summary>A value.</summary>
    public FieldValue Value(int field, int row) => _values[field][row];

    /// <summary>A number of a launch or an aim: drawn, or the scene's.</summary>
    public double Number(SweepScene scene, int number, int row) => _plan.FieldOf[number] is >= 0 and int field ? _values[field][row].Number : scene.Numbers[number];

    /// <summary>Three of them as a vector.</summary>
    public Vector3d Vector(SweepScene scene, int first, int row) => new(Number(scene, first, row), Number(scene, first + 1, row), Number(scene, first + 2, row));

    /// <summary>A number for the choices of all fields of the scene.</summary>
    public long SceneKey(int row)
    {
        long key = 0;
        foreach (int field in _plan.SceneFields)
        {
            key = (key * ((ChoiceRange)_plan.Fields[field].Range).Values.Count) + _values[field][row].Choice;
        }

        return key;
    }
}
