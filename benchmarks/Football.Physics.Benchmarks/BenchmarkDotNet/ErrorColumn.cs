using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Parameters;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;

namespace FootballPhysics.Benchmarks;

/// <summary>A column with the error of the same method at the same step, next to its time.</summary>
internal sealed class ErrorColumn : IColumn
{
    public string Id => nameof(ErrorColumn);

    public string ColumnName => "Off by";

    public bool AlwaysShow => true;

    public ColumnCategory Category => ColumnCategory.Custom;

    public int PriorityInCategory => 0;

    public bool IsNumeric => true;

    public UnitType UnitType => UnitType.Dimensionless;

    public string Legend => "Mean distance from the same shots by RK4 at 0.5 ms with every event located: of the landings, or of the ends of look-aheads, of slides and rolls, and of steps with an impact";

    public bool IsAvailable(Summary summary) => true;

    public bool IsDefault(Summary summary, BenchmarkCase benchmarkCase) => false;

    public string GetValue(Summary summary, BenchmarkCase benchmarkCase, SummaryStyle style) => GetValue(summary, benchmarkCase);

    public string GetValue(Summary summary, BenchmarkCase benchmarkCase)
    {
        Type type = benchmarkCase.Descriptor.Type;
        if (Activator.CreateInstance(type) is not IHasError benchmark)
        {
            return "–";
        }

        foreach (ParameterInstance parameter in benchmarkCase.Parameters.Items)
        {
            type.GetProperty(parameter.Name)?.SetValue(benchmark, parameter.Value);
        }

        double error = benchmark.Error(benchmarkCase.Descriptor.WorkloadMethod.Name);
        return double.IsNaN(error) ? "–" : Text.Length(error);
    }
}
