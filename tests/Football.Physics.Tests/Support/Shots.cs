using Football.Physics.Yardsticks;

namespace Football.Physics.Tests.Support;

/// <summary>Random shots, the same in every run.</summary>
internal sealed class Shots(int seed) : SeededRandom(seed);
