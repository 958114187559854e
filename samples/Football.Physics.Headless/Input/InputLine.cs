namespace Football.Physics.Headless.Input;

/// <summary>A line of the input: its text, cut where it gets too long, and its true length in bytes.</summary>
internal readonly record struct InputLine(byte[] Text, long Length);
