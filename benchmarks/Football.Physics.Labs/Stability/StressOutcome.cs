namespace FootballPhysics.Labs.Stability;

/// <summary>What a scene came to.</summary>
/// <param name="Failure">Null where every check held.</param>
/// <param name="Steps">Pieces of motion.</param>
/// <param name="Frames">Frames asked for.</param>
/// <param name="Stalled">Steps that came to their last piece.</param>
/// <param name="Impacts">Impacts.</param>
/// <param name="EnergyShare">The highest share of the energy that the method may make in a frame that it has made.</param>
internal readonly record struct StressOutcome(StressFailure? Failure, long Steps, long Frames, long Stalled, long Impacts, double EnergyShare);
