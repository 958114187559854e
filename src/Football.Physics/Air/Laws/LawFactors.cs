namespace Football.Physics;

/// <summary>The values of up to four functions of one number; the law says what each of them is.</summary>
internal struct LawFactors
{
    public double First;
    public double Second;
    public double Third;
    public double Fourth;
}
