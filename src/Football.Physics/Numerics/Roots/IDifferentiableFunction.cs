namespace Football.Physics;

/// <summary>A function with its slope, of which a root is sought. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface IDifferentiableFunction
{
    /// <summary>Evaluates it.</summary>
    /// <param name="x">Where.</param>
    /// <param name="value">Its value there.</param>
    /// <param name="slope">Its slope there; a slope that is no number makes the search bisect.</param>
    /// <returns>True where <paramref name="x"/> is close enough to the root: the search ends there.</returns>
    bool Evaluate(double x, out double value, out double slope);
}
