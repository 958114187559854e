namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>Uniformly distributed numbers between two bounds.</summary>
internal sealed class UniformRange(double low, double high) : FieldRange
{
    public override IEnumerable<FieldValue> Ends => [new(low), new(high)];

    public override FieldValue Draw(double random, long index) => new(Math.Min(low + ((high - low) * random), high));
}
