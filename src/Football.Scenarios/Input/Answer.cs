namespace FootballPhysics.Scenarios.Input;

/// <summary>The line that answers a line of the input, and why it was refused where it was.</summary>
public readonly record struct Answer(ReadOnlyMemory<byte> Line, string? Refusal);
