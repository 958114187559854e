namespace Football.Physics;

/// <summary>What a log held at one instant.</summary>
/// <param name="Events">Events that were kept.</param>
/// <param name="Missed">Events that were not.</param>
/// <param name="Impacts">Impacts among both.</param>
/// <param name="Steps">Pieces.</param>
/// <param name="Evaluations">Right-hand sides.</param>
/// <param name="Stalled">Steps that came to their last piece.</param>
internal readonly record struct StepLogMark(int Events, long Missed, long Impacts, long Steps, long Evaluations, long Stalled);
