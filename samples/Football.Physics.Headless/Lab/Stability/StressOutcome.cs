namespace Football.Physics.Headless.Lab.Stability;

/// <summary>What a scene came to.</summary>
/// <param name="Failure">Null where every check held.</param>
/// <param name="Steps">Pieces of motion.</param>
/// <param name="Frames">Frames asked for.</param>
/// <param name="Relaxed">Pieces that relaxed to the balance of forces.</param>
/// <param name="Impacts">Impacts.</param>
/// <param name="EnergyShare">The highest share of the energy that the method may make in a frame that it has made.</param>
internal readonly record struct StressOutcome(StressFailure? Failure, long Steps, long Frames, long Relaxed, long Impacts, double EnergyShare);
