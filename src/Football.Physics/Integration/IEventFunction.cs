namespace Football.Physics;

/// <summary>A function of a step's end that falls to zero where an event is. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface IEventFunction<TSweep>
    where TSweep : struct, ISweep
{
    /// <summary>Evaluates it at the end of a step.</summary>
    /// <param name="sweep">The step as it was last taken; its end may be nudged where a linear correction is exact.</param>
    /// <param name="tau">Its length, s.</param>
    /// <param name="value">The function there; positive before the event.</param>
    /// <param name="correction">What Newton's method, or a secant, adds to the length, s; not a number where the function does not fall: then the bracket is halved.</param>
    /// <returns>True where the search ends: at the event, or where no other length would be nearer to it.</returns>
    bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction);
}
