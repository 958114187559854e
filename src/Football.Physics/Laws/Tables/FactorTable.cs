using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>A table of up to four functions of one variable: piecewise cubics through Chebyshev points.</summary>
/// <remarks>
/// The exponent and top mantissa bits of the argument select a segment. Segments are coarse on the entire range, and finer on the part that needs it. The
/// cubics use the argument itself, and pair their terms to shorten the dependency chain of the step. Functions whose values are unused generate no code.
/// </remarks>
internal sealed class FactorTable
{
    private readonly Segment[] _segments;
    private readonly long _fineLowest;
    private readonly ulong _fineSpan;
    private readonly int _fineShift;
    private readonly nint _fineOffset;
    private readonly int _coarseShift;
    private readonly nint _coarseOffset;

    /// <summary>Tabulates functions.</summary>
    /// <param name="functions">The functions.</param>
    /// <param name="whole">The entire range.</param>
    /// <param name="fine">The part with finer segments.</param>
    public FactorTable(Functions functions, Octaves whole, Octaves fine)
    {
        _segments = new Segment[fine.Segments + whole.Segments];
        _fineLowest = fine.LowestBits;
        _fineSpan = (ulong)fine.Span;
        _fineShift = fine.Shift;
        _fineOffset = (int)(fine.LowestBits >> fine.Shift);
        _coarseShift = whole.Shift;
        _coarseOffset = (int)(whole.LowestBits >> whole.Shift) - fine.Segments;

        // Store the fine segments first, then the coarse ones.
        for (int i = 0; i < fine.Segments; i++)
        {
            Fill(ref _segments[i], functions, fine.Start(i), fine.Start(i + 1));
        }

        // Coarse segments below and above the fine range.
        int below = (fine.From - whole.From) << whole.SegmentBits;
        int above = (fine.To - whole.From) << whole.SegmentBits;
        for (int i = 0; i < whole.Segments; i = i + 1 == below ? above : i + 1)
        {
            Fill(ref _segments[fine.Segments + i], functions, whole.Start(i), whole.Start(i + 1));
        }
    }

    /// <summary>Evaluates up to four functions of one variable.</summary>
    public delegate void Functions(double x, out LawFactors values);

    /// <summary>Returns the values of the functions.</summary>
    /// <param name="x">The argument, within the range.</param>
    /// <param name="values">The values.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Evaluate(double x, out LawFactors values)
    {
        // The shifted bits of a double yield its exponent and segment: an index without a logarithm.
        long bits = BitConverter.DoubleToInt64Bits(x);
        nint index = (ulong)(bits - _fineLowest) < _fineSpan
            ? (nint)(bits >> _fineShift) - _fineOffset
            : (nint)(bits >> _coarseShift) - _coarseOffset;
        ref readonly Segment segment = ref _segments[index];
        double squared = x * x;
        double cubed = x * squared;
        values.First = (segment.First.A + (segment.First.B * x)) + ((segment.First.C * squared) + (segment.First.D * cubed));
        values.Second = (segment.Second.A + (segment.Second.B * x)) + ((segment.Second.C * squared) + (segment.Second.D * cubed));
        values.Third = (segment.Third.A + (segment.Third.B * x)) + ((segment.Third.C * squared) + (segment.Third.D * cubed));
        values.Fourth = (segment.Fourth.A + (segment.Fourth.B * x)) + ((segment.Fourth.C * squared) + (segment.Fourth.D * cubed));
    }

    private static void Fill(ref Segment segment, Functions functions, double low, double high)
    {
        // A cubic through the four Chebyshev points nearly minimizes the maximum error.
        var at = new ChebyshevPoints(low, high);
        functions(at.X0, out LawFactors f0);
        functions(at.X1, out LawFactors f1);
        functions(at.X2, out LawFactors f2);
        functions(at.X3, out LawFactors f3);
        segment.First = Cubic.Through(in at, f0.First, f1.First, f2.First, f3.First);
        segment.Second = Cubic.Through(in at, f0.Second, f1.Second, f2.Second, f3.Second);
        segment.Third = Cubic.Through(in at, f0.Third, f1.Third, f2.Third, f3.Third);
        segment.Fourth = Cubic.Through(in at, f0.Fourth, f1.Fourth, f2.Fourth, f3.Fourth);
    }

    private struct Segment
    {
        public Cubic First;
        public Cubic Second;
        public Cubic Third;
        public Cubic Fourth;
    }
}
