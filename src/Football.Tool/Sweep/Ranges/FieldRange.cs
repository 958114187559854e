namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>The range of a field's random values.</summary>
internal abstract class FieldRange
{
    /// <summary>Values that bound all others: if these are allowed, all are.</summary>
    public abstract IEnumerable<FieldValue> Ends { get; }

    /// <summary>Returns the value of a row.</summary>
    /// <param name="random">A uniform random number in 0 … 1, both excluded.</param>
    /// <param name="index">The index of the row.</param>
    public abstract FieldValue Draw(double random, long index);
}
