namespace FootballPhysics.Engines;

/// <summary>The hits that a sphere cast has found.</summary>
public sealed class EngineHits
{
    private EngineCollider[] _found = new EngineCollider[16];

    private readonly uint _ignores;

    /// <param name="ignores">The layers that the ball ignores.</param>
    internal EngineHits(uint ignores) => _ignores = ignores;

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>Adds a collider, placed where it is now. Allocates nothing but where there are more than ever before.</summary>
    /// <param name="collider">The collider; the same object for the same thing each time.</param>
    /// <exception cref="ArgumentNullException"><paramref name="collider"/> is null.</exception>
    public void Add(EngineCollider collider)
    {
        Check.Given(nameof(collider), collider);

        // An engine may report a collider more than once, and one that the ball ignores.
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
