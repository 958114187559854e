namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>The type of the values of a column.</summary>
internal enum ColumnKind
{
    /// <summary>64-bit floating-point numbers; NaN for a missing value.</summary>
    Real,

    /// <summary>64-bit whole numbers.</summary>
    Whole,

    /// <summary>Words, stored as their index in one byte.</summary>
    Word,
}
