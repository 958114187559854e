namespace FootballPhysics.Benchmarks;

/// <summary>A benchmark class that knows the error of what it times.</summary>
public interface IHasError
{
    /// <summary>Mean error of a benchmark with the parameters that are set, m; NaN where there is none.</summary>
    double Error(string benchmark);
}
