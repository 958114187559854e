namespace Football.Physics.Headless.Input;

/// <summary>The line that answers a line of the input, and why it was refused where it was.</summary>
internal readonly record struct Answer(ReadOnlyMemory<byte> Line, string? Refusal);
