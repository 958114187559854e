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

    public MatchModel(Scene scene, MatchFitRequest request)
    {
        // Without ground: the track determines where a flight ends.
        _scene = AimContext.WithoutThings(scene) with { Ground = Ground.None };
        _drag = request.Drag;
        _lift = request.Lift;
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
        Names = [.. names];
        _likely = [.. likely];
        _deviations = [.. deviations];
    }

    /// <summary>The names of the parameters.</summary>
    public string[] Names { get; }

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

    /// <summary>Returns the prior mean of a parameter.</summary>
    public double Likely(int number) => _likely[number];

    /// <summary>Returns the prior standard deviation of a parameter.</summary>
    public double KnownDeviation(int number) => _deviations[number];

    /// <summary>Returns the difference for the derivative with respect to a parameter.</summary>
    public double Difference(int number) => number == _crisisAt ? CrisisStep : number == _dragAt || number == _liftAt ? FactorStep : WindStep;

    /// <summary>Clamps the parameters to the limits of a scene.</summary>
    public void Bound(double[] values)
    {
        for (int i = 0; i < Count; i++)
        {
            values[i] = i == _crisisAt ? Within(values[i], DragCurve.LeastCriticalReynolds, MostCrisis)
                : i == _dragAt || i == _liftAt ? Within(values[i], LeastFactor, MostFactor)
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
            Ball = _crisisAt < 0 ? _scene.Ball : _scene.Ball with { DragCurve = _scene.Ball.DragCurve.WithCrisisAt(values[_crisisAt]) },
        };
        return _drag || _lift
            ? scene with { Forces = scene.Forces with { CustomForces = [.. scene.Forces.CustomForces, new ScaledAir(scene, Drag(values), _lift ? values[_liftAt] : 1)] } }
            : scene;
    }

    private double Drag(double[] values) => _drag ? values[_dragAt] : 1;

    private static double Within(double value, double low, double high) => Math.Min(high, Math.Max(low, value));
}
