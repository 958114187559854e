using FootballPhysics.Labs.People;

namespace FootballPhysics.Labs.Stress;

/// <summary>An engine's spheres, or none, that throw after very many sphere casts, to end a step that never ends.</summary>
internal sealed class WatchedColliders(StadiumSpheres? spheres) : IEngineColliders
{
    /// <summary>The limit of sphere casts; five balls at their 8 192 pieces need a fraction of it per step or look-ahead.</summary>
    private const long MostCasts = 400_000;

    private double _time;
    private long _casts;

    /// <inheritdoc/>
    public double Time
    {
        get => _time;
        set
        {
            _time = value;
            if (spheres is not null)
            {
                spheres.Time = value;
            }
        }
    }

    /// <inheritdoc/>
    public double MaximumSpeed => spheres?.MaximumSpeed ?? 0;

    /// <summary>Starts to count the casts of the next step or look-ahead.</summary>
    public void Begin() => _casts = 0;

    /// <inheritdoc/>
    public void Cast(in SphereCast cast, EngineHits hits)
    {
        if (++_casts > MostCasts)
        {
            throw new TimeoutException($"more than {MostCasts} sphere casts in one call");
        }

        spheres?.Cast(in cast, hits);
    }
}
