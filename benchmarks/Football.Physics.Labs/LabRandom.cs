using Football.Physics.Yardsticks;

namespace Football.Physics.Labs;

/// <summary>The random numbers of the stress scenes.</summary>
internal sealed class LabRandom(ulong seed) : SeededRandom(seed);
