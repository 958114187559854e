namespace Football.Scenarios;

/// <summary>Grounds by name: the presets of <see cref="Ground"/>, by the names that they have there.</summary>
public enum SurfaceType
{
    DryTurf,
    ArtificialTurf,
    WetTurf,
    MatchTurf,
    HardGround,
    LongGrass,
    Indoor,
    Concrete,
    Snow,
    PublishedTurf,
    PublishedWetTurf,
    PublishedCourt,
    PublishedSand,
    None,
}
