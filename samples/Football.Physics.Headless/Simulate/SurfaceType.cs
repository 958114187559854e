namespace Football.Physics.Headless.Simulate;

/// <summary>The surfaces of the measured profile.</summary>
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
}
