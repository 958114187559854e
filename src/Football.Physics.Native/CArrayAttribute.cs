namespace FootballPhysics.Native;

/// <summary>The array of a fixed length that a pointer of an export points to: how the header declares it.</summary>
/// <param name="length">How many elements it has.</param>
[AttributeUsage(AttributeTargets.Parameter)]
internal sealed class CArrayAttribute(int length) : Attribute
{
    /// <summary>How many elements it has.</summary>
    public int Length { get; } = length;
}
