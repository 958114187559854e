using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The colliders that a sphere cast has hit.</summary>
public sealed class EngineHits
{
    private EngineCollider[] _found = new EngineCollider[16];

    private readonly uint _ignores;

    /// <param name="ignores">The layers that the ball ignores.</param>
    internal EngineHits(uint ignores) => _ignores = ignores;

    /// <summary>The number of hits.</summary>
    public int Count { get; private set; }

    /// <summary>Adds a collider at its current position. Allocates only if the list must grow.</summary>
    /// <param name="collider">The collider. Pass the same instance for the same engine object each time.</param>
    /// <exception cref="ArgumentNullException"><paramref name="collider"/> is null.</exception>
    public void Add(EngineCollider collider)
    {
        Check.Given(nameof(collider), collider);

        // An engine may report a collider twice, or report one that the ball ignores.
        if (Layers.Contains(_ignores, collider.Layer) || Array.IndexOf(_found, collider, 0, Count) >= 0)
        {
            return;
        }

        if (Count == _found.Length)
        {
            Array.Resize(ref _found, 2 * Count);
        }

        _found[Count++] = collider;
    }

    internal EngineCollider At(int index) => _found[index];

    internal void Clear() => Count = 0;
}
