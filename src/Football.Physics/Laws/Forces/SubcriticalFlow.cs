using System.Runtime.CompilerServices;

namespace FootballPhysics.Laws;

/// <summary>The share of subcritical flow, q, by the drag curve of the scene's ball, also if another drag law is chosen.</summary>
internal readonly struct SubcriticalFlow
{
    private readonly ReynoldsDrag _drag;
    private readonly FactorTable _table;
    private readonly double _perSpeedSquared; // (2r/ν)², s²/m²
    private readonly double _lowest;
    private readonly double _highest;

    public SubcriticalFlow(Scene scene)
    {
        MeasuredLaw law = default;
        law.Prepare(scene);
        LawTables tables = law.Tables;
        _drag = new ReynoldsDrag(scene.Ball.DragCurve);
        _table = tables.Speeds;
        _perSpeedSquared = law.SpeedScale * law.SpeedScale;
        _lowest = tables.Slowest * tables.Slowest;
        _highest = tables.Fastest * tables.Fastest;
    }

    /// <summary>Returns q: from the table in its range, otherwise from the function.</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Share(double speedSquared)
    {
        double squared = _perSpeedSquared * speedSquared;
        if (!(squared >= _lowest && squared < _highest))
        {
            return ByFunction(squared);
        }

        _table.Evaluate(squared, out LawFactors factors);
        return factors.Fourth;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private double ByFunction(double squared) => _drag.SubcriticalShare(Math.Sqrt(squared));
}
