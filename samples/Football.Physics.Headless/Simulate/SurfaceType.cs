namespace Football.Physics.Headless.Simulate;

/// <summary>Grounds by name: the presets of <see cref="Ground"/>, by the names that they have there.</summary>
internal enum SurfaceType
{
    DryTurf,
    ArtificialTurf,
    WetTurf,
    HardGround,
    LongGrass,
    Indoor,
    Concrete,
    Snow,
    PublishedTurf,
    PublishedWetTurf,
    PublishedCourt,
    PublishedSand,
}
