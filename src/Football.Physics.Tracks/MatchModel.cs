using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The model shared by all flights of a match: the wind, and the ball's drag and lift. Other parameters are those of the scene.</summary>
internal sealed class MatchModel
{
    /// <summary>The differences for derivatives: in m/s, a factor, a Reynolds number.</summary>
    private const double WindStep = 0.05;
    private const double FactorStep = 0.01;
    private const double CrisisStep = 2e3;

    /// <summary>The critical Reynolds numbers of a rough and of a smooth ball.</summary>
    private static readonly double[] OtherCrises = [1.1e5, 2.2e5];
    private static readonly double[] WideCrises = [1.4e5, 2e5];

    /// <summary>The differences, and prior standard deviations, of the drag above the crisis as a factor, of the logarithm of the width, and of the weight.</summary>
    private const double FloorStep = 0.02;
    private const double FloorDeviation = 0.25;
    private const double LeastFloor = 0.05;
    private const double WidthStep = 0.05;
    private const double WidthDeviation = 0.7;
    private const double WeightStep = 0.01;
    private const double WeightDeviation = 0.3;

    /// <summary>The prior standard deviation of a factor of the lift that stays 1.</summary>
    private const double KnownLiftDeviation = 1e-6;

    private const double MostCrisis = 3.5e5;
    private const double LeastFactor = 0.05;
    private const double MostFactor = 5;

    private readonly Scene _scene;
    private readonly bool _drag;
    private readonly bool _lift;
    private readonly double[] _likely;
    private readonly double[] _deviations;
    private readonly int _windAt;
    private readonly int _dragAt;
    private readonly int _crisisAt;
    private readonly int _liftAt;
    private readonly int _lawAt;
    private readonly int _weightAt;

    /// <summary>Creates a model.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="request">The parameters to estimate.</param>
    /// <param name="law">True to estimate also the shape of the drag curve, which the request does not name. Default false.</param>
    /// <param name="weight">True to estimate also a factor of gravity: it is 1 if times and heights are right. Default false.</param>
    /// <param name="knownLift">True for derivatives also by a factor of the lift, which stays 1. Default false.</param>
    public MatchModel(Scene scene, MatchFitRequest request, bool law = false, bool weight = false, bool knownLift = false)
    {
        // Without ground: the track determines where a flight ends.
        _scene = AimContext.WithoutThings(scene) with { Ground = Ground.None };
        _drag = request.Drag;
        _lift = request.Lift || knownLift;
        List<string> names = [];
        List<double> likely = [];
        List<double> deviations = [];
        int Add(string name, double value, double deviation)
        {
            names.Add(name);
            likely.Add(value);
            deviations.Add(deviation);
            return names.Count - 1;
        }

        _windAt = request.Wind ? Add("wind.x", scene.Air.Wind.X, request.WindDeviation) : -1;
        _ = request.Wind ? Add("wind.z", scene.Air.Wind.Z, request.WindDeviation) : -1;
        _dragAt = request.Drag ? Add("drag", 1, request.FactorDeviation) : -1;
        bool crisis = (request.Drag || request.Crisis) && scene.Forces.Coefficients == AerodynamicModel.Measured;
        _crisisAt = crisis ? Add("crisis", scene.Ball.DragCurve.CriticalReynolds, request.CrisisDeviation) : -1;
        _liftAt = request.Lift ? Add("lift", 1, request.FactorDeviation) : -1;
        _lawAt = law && crisis ? Add("floor", 1, FloorDeviation) : -1;
        _ = _lawAt >= 0 ? Add("width", 0, WidthDeviation) : -1;
        _liftAt = knownLift && !request.Lift ? Add("lift", 1, KnownLiftDeviation) : _liftAt;
        _weightAt = weight ? Add("weight", 1, WeightDeviation) : -1;
        Names = [.. names];
        _likely = [.. likely];
        _deviations = [.. deviations];
    }

    /// <summary>The names of the parameters.</summary>
    public string[] Names { get; }

    /// <summary>The index of the factor of the drag; −1 if it is not estimated.</summary>
    public int DragAt => _dragAt;

    /// <summary>The index of the critical Reynolds number; −1 if it is not estimated.</summary>
    public int CrisisAt => _crisisAt;

    /// <summary>The index of the factor of the lift; −1 if there is none.</summary>
    public int LiftAt => _liftAt;

    /// <summary>The number of parameters.</summary>
    public int Count => Names.Length;

    /// <summary>The initial values of a search: the prior means and, if the crisis is estimated, other values of it.</summary>
    public IEnumerable<double[]> Starts
    {
        get
        {
            yield return (double[])_likely.Clone();
            for (int i = 0; i < OtherCrises.Length && _crisisAt >= 0; i++)
            {
                double[] other = (double[])_likely.Clone();
                other[_crisisAt] = OtherCrises[i];
                yield return other;
            }
        }
    }

    /// <summary>Returns initial values with the shape of the drag curve: that of the scene, and a wide and high one.</summary>
    /// <param name="values">The values of the model without it.</param>
    public IEnumerable<double[]> LawStarts(double[] values)
    {
        yield return [.. values, 1, 0];
        foreach (double crisis in WideCrises)
        {
            double[] wide = [.. values, 1.2, 0.8];
            wide[_crisisAt] = crisis;
            yield return wide;
        }
    }

    /// <summary>Returns the square of the distance of the ball from that of the scene, in prior standard deviations.</summary>
    public double Strangeness(double[] values, double[] covariance)
    {
        double sum = 0;
        for (int i = 0; i < Count; i++)
        {
            if (i == _dragAt || i == _crisisAt || (_lawAt >= 0 && i >= _lawAt && i < _lawAt + 2))
            {
                double off = values[i] - _likely[i];
                sum += off * off / Math.Max(covariance[(i * Count) + i], 1e-12);
            }
        }

        return sum;
    }

    /// <summary>Returns the prior mean of a parameter.</summary>
    public double Likely(int number) => _likely[number];

    /// <summary>Returns the prior standard deviation of a parameter.</summary>
    public double KnownDeviation(int number) => _deviations[number];

    /// <summary>Returns the difference for the derivative with respect to a parameter.</summary>
    public double Difference(int number) => number == _crisisAt ? CrisisStep : number == _weightAt ? WeightStep : _lawAt >= 0 && number == _lawAt ? FloorStep : _lawAt >= 0 && number == _lawAt + 1 ? WidthStep : number == _dragAt || number == _liftAt ? FactorStep : WindStep;

    /// <summary>Clamps the parameters to the limits of a scene.</summary>
    public void Bound(double[] values)
    {
        for (int i = 0; i < Count; i++)
        {
            values[i] = i == _crisisAt ? Within(values[i], DragCurve.LeastCriticalReynolds, MostCrisis)
                : i == _dragAt || i == _liftAt || i == _weightAt || i == _lawAt ? Within(values[i], LeastFactor, MostFactor)
                : _lawAt >= 0 && i == _lawAt + 1 ? Within(values[i], -2, 2)
                : Within(values[i], -60, 60);
        }
    }

    /// <summary>Returns the scene with the given parameters, without ground.</summary>
    public Scene Scene(double[] values)
    {
        Vector3d wind = _scene.Air.Wind;
        Scene scene = _scene with
        {
            Air = _windAt < 0 ? _scene.Air : _scene.Air with { Wind = new Vector3d(values[_windAt], wind.Y, values[_windAt + 1]) },
            Ball = _crisisAt < 0 ? _scene.Ball : _scene.Ball with { DragCurve = Curve(values) },
            Gravity = _weightAt < 0 ? _scene.Gravity : values[_weightAt] * _scene.Gravity,
        };
        return _drag || _lift
            ? scene with { Forces = scene.Forces with { CustomForces = [.. scene.Forces.CustomForces, new ScaledAir(scene, Drag(values), _lift ? values[_liftAt] : 1)] } }
            : scene;
    }

    private DragCurve Curve(double[] values)
    {
        DragCurve curve = _scene.Ball.DragCurve.WithCrisisAt(values[_crisisAt]);
        if (_lawAt < 0)
        {
            return curve;
        }

        double width = Within(curve.Width * Elementary.Exp(values[_lawAt + 1]), DragCurve.LeastWidth, DragCurve.MostWidth);
        double floor = Within(values[_lawAt] * curve.Supercritical, LeastFloor, 1);
        return curve with { Width = width, Supercritical = floor, Risen = floor + (curve.Risen - curve.Supercritical), RiseTo = Math.Max(curve.RiseTo, curve.RiseFrom + width) };
    }

    private double Drag(double[] values) => _drag ? values[_dragAt] : 1;

    private static double Within(double value, double low, double high) => Math.Min(high, Math.Max(low, value));
}
