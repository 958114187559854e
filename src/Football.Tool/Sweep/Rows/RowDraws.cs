using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>The random values of some rows.</summary>
internal sealed class RowDraws(SweepPlan plan, int capacity)
{
    private readonly SweepPlan _plan = plan;
    private readonly FieldValue[][] _values = [.. plan.Fields.Select(_ => new FieldValue[capacity])];

    /// <summary>The index of the first row.</summary>
    public long First { get; private set; }

    /// <summary>Computes the values of rows.</summary>
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

    public FieldValue Value(int field, int row) => _values[field][row];

    /// <summary>Returns a number of a launch or an aim: the row's random value, or the scene's fixed one.</summary>
    public double Number(SweepScene scene, int number, int row) => _plan.FieldOf[number] is >= 0 and int field ? _values[field][row].Number : scene.Numbers[number];

    /// <summary>Returns three consecutive numbers of a launch or an aim as a vector.</summary>
    public Vector3d Vector(SweepScene scene, int first, int row) => new(Number(scene, first, row), Number(scene, first + 1, row), Number(scene, first + 2, row));

    /// <summary>Returns a key that identifies the values of all fields of the scene in a row.</summary>
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
