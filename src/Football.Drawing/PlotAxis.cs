namespace FootballPhysics.Drawing;

/// <summary>An axis with both ends: maps values to fractions of its length.</summary>
public sealed class PlotAxis
{
    private readonly bool _logarithmic;
    private readonly double _from;
    private readonly double _to;

    private PlotAxis(Axis axis, double min, double max)
    {
        Axis = axis;
        Min = min;
        Max = max;
        _logarithmic = axis.Scale == AxisScale.Logarithmic;
        _from = Place(min);
        _to = Place(max);
    }

    public Axis Axis { get; }

    public double Min { get; }

    public double Max { get; }

    /// <summary>Creates an axis; the data determines the ends that are not fixed.</summary>
    public static PlotAxis Fit(Axis axis, double dataMin, double dataMax)
    {
        double min = axis.Min ?? dataMin;
        double max = axis.Max ?? dataMax;
        if (axis.Scale == AxisScale.Logarithmic)
        {
            min = min > 0 && double.IsFinite(min) ? min : max > 0 && double.IsFinite(max) ? max / 10 : 0.1;
            max = max > min ? max : min * 10;
            double margin = Math.Pow(max / min, axis.Margin);
            return new PlotAxis(axis, axis.Min ?? (min / margin), axis.Max ?? (max * margin));
        }

        min = double.IsFinite(min) ? min : 0;
        max = double.IsFinite(max) && max > min ? max : min + 1;
        double room = (max - min) * axis.Margin;
        return new PlotAxis(axis, axis.Min ?? (min - room), axis.Max ?? (max + room));
    }

    /// <summary>Returns the same axis with other ends.</summary>
    public PlotAxis Between(double min, double max) => new(Axis, min, max);

    /// <summary>True if the axis can show the value: it is finite and, on a logarithmic axis, above 0.</summary>
    public bool Shows(double value) => double.IsFinite(value) && (!_logarithmic || value > 0);

    /// <summary>Returns the position of a value: 0 at the lower end, 1 at the upper end.</summary>
    public double Fraction(double value) => (Place(value) - _from) / (_to - _from);

    /// <summary>Returns round values to mark, about as many as requested.</summary>
    public List<double> Ticks(double about) => _logarithmic ? Drawing.Ticks.Logarithmic(Min, Max, about) : Drawing.Ticks.Linear(Min, Max, about);

    private double Place(double value) => _logarithmic ? Math.Log10(value) : value;
}
