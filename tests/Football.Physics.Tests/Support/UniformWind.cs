namespace FootballPhysics.Tests.Support;

/// <summary>A field that is the same everywhere and always.</summary>
internal sealed class UniformWind(Vector3d wind) : IWind
{
    public double MaximumSpeed => wind.Length;

    public Vector3d At(double time, in Vector3d position) => wind;
}
