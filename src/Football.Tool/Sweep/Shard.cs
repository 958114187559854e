using System.Globalization;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A part of a sweep: parts follow one another.</summary>
/// <param name="Index">Which, from 1.</param>
/// <param name="Of">How many there are.</param>
/// <param name="Count">Rows of the whole sweep.</param>
internal readonly record struct Shard(int Index, int Of, long Count)
{
    /// <summary>Its first row.</summary>
    public long First => (long)((Int128)Count * (Index - 1) / Of);

    /// <summary>The row after its last.</summary>
    public long End => (long)((Int128)Count * Index / Of);

    /// <summary>Rows that it has.</summary>
    public long Rows => End - First;

    /// <summary>Its folder among those of the other parts: their order is that of their names.</summary>
    public string Folder
    {
        get
        {
            int digits = Of.ToString(CultureInfo.InvariantCulture).Length;
            return string.Create(CultureInfo.InvariantCulture, $"shard-{Index.ToString(CultureInfo.InvariantCulture).PadLeft(digits, '0')}-of-{Of}");
        }
    }

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"shard {Index} of {Of}");
}
