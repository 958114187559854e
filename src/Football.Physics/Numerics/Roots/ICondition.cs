namespace Football.Physics;

/// <summary>A condition that holds from some place on, which is sought. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface ICondition
{
    /// <summary>Evaluates it.</summary>
    /// <param name="x">Where.</param>
    /// <param name="holds">Whether it holds there.</param>
    /// <returns>True where <paramref name="x"/> is close enough to the place: the search ends there.</returns>
    bool Evaluate(double x, out bool holds);
}
