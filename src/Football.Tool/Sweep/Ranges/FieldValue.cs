namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>A value that was drawn.</summary>
/// <param name="Number">The number; not a number where it is none.</param>
/// <param name="Choice">Its place in a list or a grid; −1 where it is from neither.</param>
internal readonly record struct FieldValue(double Number, int Choice = -1);
