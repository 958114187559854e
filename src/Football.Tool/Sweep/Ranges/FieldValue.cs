namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>The value of a field in a row.</summary>
/// <param name="Number">The number; NaN if the value is not a number.</param>
/// <param name="Choice">The index in a list or a grid; −1 if the value is from neither.</param>
internal readonly record struct FieldValue(double Number, int Choice = -1);
