namespace FootballPhysics.Benchmarks;

/// <summary>A benchmark class that computes the error of the timed method.</summary>
public interface IHasError
{
    /// <summary>Returns the mean error of a benchmark with the current parameters, m; NaN if there is none.</summary>
    double Error(string benchmark);
}
