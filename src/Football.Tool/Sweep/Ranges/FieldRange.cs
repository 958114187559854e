namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>The range of a field's random values.</summary>
internal abstract class FieldRange
{
    /// <summary>Values that bound all others: what is allowed for them is allowed for all.</summary>
    public abstract IEnumerable<FieldValue> Ends { get; }

    /// <summary>The value of a row.</summary>
    /// <param name="random">A uniform number within 0 … 1, both excluded.</param>
    /// <param name="index">The row.</param>
    public abstract FieldValue Draw(double random, long index);
}
