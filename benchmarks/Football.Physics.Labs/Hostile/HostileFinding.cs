namespace FootballPhysics.Labs.Hostile;

/// <summary>A kind of finding: how often, where it is worst, and the tamest scene that shows it.</summary>
internal sealed class HostileFinding
{
    public long Count { get; private set; }

    /// <summary>The largest size, and where.</summary>
    public HostileSighting Worst { get; private set; }

    /// <summary>The scene whose numbers are least far from ordinary ones.</summary>
    public HostileSighting Tamest { get; private set; }

    public void Add(in HostileSighting sighting)
    {
        // Whatever the order in which scenes are played: of equals the one with the lower number.
        bool worse = sighting.Size > Worst.Size || (sighting.Size == Worst.Size && sighting.Scene < Worst.Scene);
        bool tamer = sighting.Absurdity < Tamest.Absurdity || (sighting.Absurdity == Tamest.Absurdity && sighting.Scene < Tamest.Scene);
        Worst = Count == 0 || worse ? sighting : Worst;
        Tamest = Count == 0 || tamer ? sighting : Tamest;
        Count++;
    }
}
