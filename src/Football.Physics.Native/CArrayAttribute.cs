namespace FootballPhysics.Native;

/// <summary>Marks a pointer parameter of an export as an array of a fixed length. The header declares it so.</summary>
/// <param name="length">The number of elements.</param>
[AttributeUsage(AttributeTargets.Parameter)]
internal sealed class CArrayAttribute(int length) : Attribute
{
    /// <summary>The number of elements.</summary>
    public int Length { get; } = length;
}
