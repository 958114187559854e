using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>Layers of objects and zones, 0 … 31, and the sets of layers that a ball ignores.</summary>
/// <remarks>Assign such a set to <see cref="BallProperties.Ignores"/>.</remarks>
public static class Layers
{
    /// <summary>The highest layer.</summary>
    internal const int Highest = 31;

    /// <summary>Returns a set of layers: bit k represents layer k.</summary>
    /// <param name="layers">The layers, 0 … 31.</param>
    /// <exception cref="ArgumentNullException"><paramref name="layers"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A layer is out of range.</exception>
    public static uint Of(params int[] layers)
    {
        Check.Given(nameof(layers), layers);
        uint set = 0;
        for (int i = 0; i < layers.Length; i++)
        {
            Validate(Check.Item(nameof(layers), i), layers[i]);
            set |= 1u << layers[i];
        }

        return set;
    }

    /// <summary>True if a set contains a layer.</summary>
    internal static bool Contains(uint set, int layer) => (set >> layer & 1u) != 0;

    internal static void Validate(string field, int layer) => Check.Within(field, (long)layer, 0, Highest);
}
