using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The parameters of a fit: the launch, and factors of a scene.</summary>
internal sealed class TrackModel
{
    /// <summary>The number of launch parameters: position, velocity, spin.</summary>
    public const int Launch = 9;

    /// <summary>The maximum speed, in m/s, and spin, in rad/s, that a search tries.</summary>
    private const double MostSpeed = 300;
    private const double MostSpin = 1000;

    /// <summary>The largest sliding friction that a scene allows; a search may try to exceed it.</summary>
    private const double MostSlidingFriction = 10;

    /// <summary>The index of the first component of the spin. It, and all after it, have a prior.</summary>
    public const int FirstSpin = 6;

    /// <summary>The index of the height, which has a prior if the launch is on the ground, and its deviation, in m.</summary>
    private const int Height = 1;
    private const double GroundDeviation = 0.01;

    private static readonly string[] LaunchNames =
        ["position.x", "position.y", "position.z", "velocity.x", "velocity.y", "velocity.z", "spin.x", "spin.y", "spin.z"];

    private readonly Scene _scene;
    private readonly TrackFitRequest _request;
    private readonly double _contactHeight;

    /// <summary>The last simulator and its factors, cached because most paths differ in the launch only.</summary>
    private Simulator? _simulator;
    private (double Drag, double Lift, double Restitution, double Friction) _factors;

    public TrackModel(Scene scene, TrackFitRequest request)
    {
        _scene = scene;
        _request = request;
        List<string> names = [.. LaunchNames];
        Add(names, "drag", request.Drag);
        Add(names, "lift", request.Lift);
        Add(names, "restitution", request.Restitution);
        Add(names, "friction", request.Friction);
        Names = [.. names];
        _contactHeight = new Simulator(scene).ContactHeight;
    }

    /// <summary>The names of the parameters.</summary>
    public string[] Names { get; }

    /// <summary>The number of parameters.</summary>
    public int Count => Names.Length;

    /// <summary>Returns the prior standard deviation of a parameter; infinite without a prior.</summary>
    public double KnownDeviation(int number) =>
        number == Height ? _request.FromGround ? GroundDeviation : _request.HeightDeviation
        : number < FirstSpin ? double.PositiveInfinity : number < Launch ? _request.SpinDeviation : _request.FactorDeviation;

    /// <summary>Adds the prior: N += 1/σ², g += (likely − value)/σ².</summary>
    /// <returns>Σ (likely − value)²/σ².</returns>
    public double AddKnown(double[] values, double[]? normal, double[] gradient)
    {
        double cost = 0;
        for (int i = 0; i < Count; i++)
        {
            double weight = 1.0 / (KnownDeviation(i) * KnownDeviation(i));
            double off = Likely(i) - values[i];
            cost += weight * off * off;
            if (i == Height && HasCauchy)
            {
                weight = HeightWeight(off);
                cost += HeightCost(off);
            }

            gradient[i] += weight * off;
            if (normal is not null)
            {
                normal[(i * Count) + i] += weight;
            }
        }

        return cost;
    }

    /// <summary>Returns the cost of the prior, Σ (likely − value)²/σ² and that of the height.</summary>
    public double KnownCost(double[] values)
    {
        double cost = HasCauchy ? HeightCost(Likely(Height) - values[Height]) : 0;
        for (int i = 0; i < Count; i++)
        {
            double off = (Likely(i) - values[i]) / KnownDeviation(i);
            cost += off * off;
        }

        return cost;
    }

    /// <summary>True if the prior of the height is a Cauchy distribution, not a normal one.</summary>
    private bool HasCauchy => double.IsInfinity(KnownDeviation(Height)) && !double.IsInfinity(_request.HeightScale);

    /// <summary>
    /// Returns −2 log of a Cauchy distribution, 2 log(1 + h²/s²). A high launch is unlikely, but a slightly higher one is hardly less likely.
    /// </summary>
    private double HeightCost(double off) =>
        2 * Elementary.Log(1 + (off * off / (_request.HeightScale * _request.HeightScale)));

    /// <summary>Returns the weight w of the height's prior, with the gradient w h.</summary>
    private double HeightWeight(double off) => 2 / ((_request.HeightScale * _request.HeightScale) + (off * off));

    /// <summary>True if the parameters describe a valid launch.</summary>
    public static bool IsLaunch(double[] v) =>
        new Vector3d(v[0], v[1], v[2]).Length < Limits.Length && new Vector3d(v[3], v[4], v[5]).Length < Limits.Speed && new Vector3d(v[6], v[7], v[8]).Length < Limits.Spin;

    /// <summary>Returns the scene with the factors of the parameters.</summary>
    public Simulator Simulator(double[] values)
    {
        int at = Launch;
        double drag = _request.Drag ? values[at++] : 1;
        double lift = _request.Lift ? values[at++] : 1;
        double restitution = _request.Restitution ? values[at++] : 1;
        double friction = _request.Friction ? values[at] : 1;
        if (_simulator is not null && _factors == (drag, lift, restitution, friction))
        {
            return _simulator;
        }

        SurfaceMaterial turf = _scene.Ground.Material;
        Scene scene = _scene with
        {
            Ground = _scene.Ground with
            {
                Material = turf with
                {
                    NormalRestitution = Math.Min(1, Math.Max(0, restitution) * turf.NormalRestitution),
                    ImpactFriction = FrictionLaw.Limit(turf.ImpactFriction, friction),
                    SlidingFriction = Math.Min(MostSlidingFriction, Math.Max(0, friction) * turf.SlidingFriction),
                },
            },
        };
        if (_request.Drag || _request.Lift)
        {
            scene = scene with { Forces = scene.Forces with { CustomForces = [.. scene.Forces.CustomForces, new ScaledAir(_scene, Math.Max(0, drag), lift)] } };
        }

        _factors = (drag, lift, restitution, friction);
        _simulator = new Simulator(scene);
        return _simulator;
    }

    /// <summary>Returns the ball at its launch.</summary>
    public static BallState Ball(Simulator simulator, double[] v)
    {
        // A search step may exceed the limits of a ball if the track determines a parameter poorly.
        var velocity = new Vector3d(v[3], v[4], v[5]);
        var spin = new Vector3d(v[6], v[7], v[8]);
        velocity *= Math.Min(1, MostSpeed / velocity.Length);
        spin *= Math.Min(1, MostSpin / spin.Length);
        return simulator.Launch(new Vector3d(v[0], v[1], v[2]), velocity, spin);
    }

    private double Likely(int number) =>
        number == Height ? _contactHeight : number < FirstSpin ? 0
        : number == FirstSpin ? _request.Spin.X : number == FirstSpin + 1 ? _request.Spin.Y : number == FirstSpin + 2 ? _request.Spin.Z : 1;

    private static void Add(List<string> names, string name, bool isEstimated)
    {
        if (isEstimated)
        {
            names.Add(name);
        }
    }
}

/// <summary>Simulates the ball to the times of its observations, and computes the residuals.</summary>
internal sealed class TrackPaths(Sightings seen, TrackFitRequest request, TrackModel model, FitWatch? watch = null)
{
    private readonly Sightings _seen = seen;
    private readonly TrackFitRequest _request = request;
    private readonly TrackModel _model = model;
    private readonly FitWatch? _watch = watch;
    private readonly StepLog _log = new();

    /// <summary>The number of residuals.</summary>
    public int Rows => _seen.Rows;

    /// <summary>Simulates a ball.</summary>
    /// <returns>The cost: the squared residuals plus the prior.</returns>
    public double Follow(double[] values, double[] misses)
    {
        _watch?.Check();
        Simulator simulator = _model.Simulator(values);
        BallState ball = TrackModel.Ball(simulator, values);
        (values[0], values[1], values[2]) = (ball.Position.X, ball.Position.Y, ball.Position.Z);
        double cost = _model.KnownCost(values);
        for (int i = 0; i < _seen.Count; i++)
        {
            double wait = i > 0 ? _seen.Time(i) - _seen.Time(i - 1) : 0;
            if (wait > 0)
            {
                _log.Clear();
                simulator.RunChecked(ref ball, _request.TimeStep, wait, StopAt.Time, _log, null);
            }

            cost += _seen.Miss(i, ball.Position, misses);
        }

        return cost;
    }
}
