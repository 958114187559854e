namespace Football.Physics;

/// <summary>Which laws a flight in lanes is compiled for. Facts of the type, so that nothing remains of the others.</summary>
internal interface ILaneLaw
{
    /// <summary>Whether there is air at all.</summary>
    bool Air { get; }

    /// <summary>Whether drag and lift use the fitted C_D; else all laws are of constant coefficients.</summary>
    bool Fitted { get; }

    /// <summary>Whether the fitted C_D is the regularised one.</summary>
    bool Regularised { get; }
}

/// <summary>The fitted laws with the published C_D.</summary>
internal readonly struct PublishedLaneLaw : ILaneLaw
{
    public bool Air => true;

    public bool Fitted => true;

    public bool Regularised => false;
}

/// <summary>The fitted laws with the regularised C_D.</summary>
internal readonly struct RegularisedLaneLaw : ILaneLaw
{
    public bool Air => true;

    public bool Fitted => true;

    public bool Regularised => true;
}

/// <summary>Constant coefficients.</summary>
internal readonly struct ConstantLaneLaw : ILaneLaw
{
    public bool Air => true;

    public bool Fitted => false;

    public bool Regularised => false;
}

/// <summary>No air.</summary>
internal readonly struct VacuumLaneLaw : ILaneLaw
{
    public bool Air => false;

    public bool Fitted => false;

    public bool Regularised => false;
}
