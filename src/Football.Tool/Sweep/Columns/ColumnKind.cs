namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>The type of the values of a column.</summary>
internal enum ColumnKind
{
    /// <summary>Doubles; not a number where there is no value.</summary>
    Real,

    /// <summary>Whole numbers of 64 bits.</summary>
    Whole,

    /// <summary>One of some words, as its place among them in a byte.</summary>
    Word,
}
