using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs;

/// <summary>The random numbers of the stress scenes.</summary>
internal sealed class LabRandom(ulong seed) : SeededRandom(seed);
