namespace FootballPhysics.Scenarios.Input;

/// <summary>The output line for an input line, and the error message; null if the input was accepted.</summary>
public readonly record struct Answer(ReadOnlyMemory<byte> Line, string? Refusal);
