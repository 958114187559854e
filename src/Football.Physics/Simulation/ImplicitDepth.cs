namespace Football.Physics;

/// <summary>How far below contact with level ground a piece of implicit Euler ends, m, by its length.</summary>
internal struct ImplicitDepth<TAir> : IFunction
    where TAir : struct, IAir
{
    /// <summary>How far below contact a piece may end, m.</summary>
    private const double DeepestEnd = 1e-12;

    /// <summary>The step, with what it has evaluated.</summary>
    public ImplicitStep<TAir> Step;

    private readonly double _contact;

    public ImplicitDepth(in ImplicitStep<TAir> step, in Motion end, double length, double contact)
    {
        Step = step;
        _contact = contact;
        End = end;
        Length = length;
    }

    /// <summary>The shortest piece so far that ends below, s.</summary>
    public double Length { get; private set; }

    /// <summary>Its end.</summary>
    public Motion End { get; private set; }

    /// <summary>The depth of one end.</summary>
    public readonly double Of(in Motion end) => _contact - end.Position.Y;

    public bool Evaluate(double x, out double value)
    {
        Motion at = Step.To(x);
        value = Of(in at);
        if (value >= 0)
        {
            End = at;
            Length = x;
        }

        return value is >= 0 and <= DeepestEnd;
    }
}
