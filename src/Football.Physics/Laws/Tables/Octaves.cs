namespace FootballPhysics.Laws;

/// <summary>The numbers from 2^From to 2^To, with 2^SegmentBits equal segments per octave.</summary>
internal readonly record struct Octaves(int From, int To, int SegmentBits)
{
    /// <summary>The number of segments.</summary>
    public int Segments => (To - From) << SegmentBits;

    /// <summary>The smallest number.</summary>
    public double Lowest => BitConverter.Int64BitsToDouble(LowestBits);

    /// <summary>The bits of the smallest number.</summary>
    public long LowestBits => (From + 1023L) << 52;

    /// <summary>The number of bit patterns in the range.</summary>
    public long Span => (To - (long)From) << 52;

    /// <summary>The right shift that reduces a number's bits to exponent and segment.</summary>
    public int Shift => 52 - SegmentBits;

    /// <summary>Returns the start of a segment.</summary>
    public double Start(int segment) => BitConverter.Int64BitsToDouble(LowestBits + ((long)segment << Shift));
}
