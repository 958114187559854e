namespace Football.Physics;

/// <summary>Which form of the fitted drag coefficient the empirical laws use.</summary>
public enum CoefficientForm
{
    /// <summary>As published: it jumps at the critical speed and at spin parameter 0.05; the jump is located inside the step.</summary>
    Published = 0,

    /// <summary>The same with the two jumps smoothed; landing points move by about 1 cm.</summary>
    Regularised = 1,
}
