using System.Globalization;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A part of a sweep: consecutive rows.</summary>
/// <param name="Index">The index of the part, from 1.</param>
/// <param name="Of">The number of parts.</param>
/// <param name="Count">The number of rows of the complete sweep.</param>
internal readonly record struct Shard(int Index, int Of, long Count)
{
    /// <summary>The index of the first row.</summary>
    public long First => (long)((Int128)Count * (Index - 1) / Of);

    /// <summary>The index after the last row.</summary>
    public long End => (long)((Int128)Count * Index / Of);

    /// <summary>The number of rows.</summary>
    public long Rows => End - First;

    /// <summary>The name of the folder. The names of all parts sort in the order of the parts.</summary>
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
