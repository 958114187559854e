namespace Football.Physics;

/// <summary>Flies kicks among all there is in a scene, and finds by their misses what comes closer.</summary>
internal sealed class BankShotFlight
{
    /// <summary>Step of a look, s.</summary>
    public const double CoarseStep = 0.04;

    /// <summary>A kick is given up after this, s.</summary>
    private const double LongestFlight = 8;

    private const int MostCorrections = 20;
    private const int MostHalvings = 8;

    /// <summary>A miss that is not worth a correction, of the tolerance.</summary>
    public const double Enough = 0.1;

    /// <summary>Derivatives are difference quotients over so much of a turn, rad.</summary>
    private const double Width = 1e-6;

    /// <summary>The most that a direction is turned at once, rad.</summary>
    private const double LargestTurn = 0.1;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private readonly MeasuredFlight _shot;
    private readonly double _upward;

    public BankShotFlight(Simulator simulator)
    {
        _simulator = simulator;
        _upward = Weight.UpwardAcceleration(simulator.Scene);
        _shot = new MeasuredFlight(simulator);
    }

    /// <summary>Forward simulations since the search began.</summary>
    public int Simulations { get; set; }

    /// <summary>Corrections since the search began.</summary>
    public int Iterations { get; set; }

    /// <summary>Step of the search itself, s: of a measurement.</summary>
    public double FineStep { get; private set; }

    /// <summary>Begins a search.</summary>
    public void Begin(AimRequest request)
    {
        double spinRate = Math.Sqrt((request.TopSpin * request.TopSpin) + (request.SideSpin * request.SideSpin));
        FineStep = MeasuringStep.Of(_simulator, _upward, request.Speed, spinRate);
        Simulations = 0;
        Iterations = 0;
    }

    /// <summary>Flies a kick.</summary>
    public BankShotStart Fly(AimRequest request, in TargetFrame frame, int[] things, in Kick kick, double step)
    {
        kick.Vectors(request.Speed, frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.LaunchAt(request.From, velocity, spin, request.KickTime);
        Simulations++;
        _shot.Fly(state, step, LongestFlight, frame.Target, Vector3d.Zero, null, things);
        return new BankShotStart
        {
            Kick = kick,
            Meets = _shot.HasMetAll,
            Miss = _shot.HasMetAll ? _shot.Miss : double.MaxValue,
            Time = _shot.Time,
            Position = _shot.Position,
            Velocity = _shot.Velocity,
        };
    }

    /// <summary>Newton's method on the part of the miss across the way, by elevation and azimuth.</summary>
    public BankShotStart Improve(AimRequest request, in TargetFrame frame, int[] things, in BankShotStart start)
    {
        // Through the impacts, whose kinks end a step early: halved until it meets the same things and comes closer.
        BankShotStart at = start.IsFine ? start : Fly(request, in frame, things, start.Kick, FineStep);
        var bounds = ElevationBounds.Of(request);
        for (int i = 0; at.Meets && i < Math.Min(MostCorrections, request.MaximumIterations) && at.Miss > Enough * request.Tolerance; i++)
        {
            Iterations++;
            if (!Step(request, in frame, in at, out double up, out double aside))
            {
                break;
            }

            double turn = Math.Sqrt((up * up) + (aside * aside));
            double share = turn > LargestTurn ? LargestTurn / turn : 1.0;
            BankShotStart next = at;
            bool better = false;
            for (int halving = 0; halving < MostHalvings && !better; halving++)
            {
                Kick kick = at.Kick;
                kick.Elevation = bounds.Clamp(kick.Elevation + (share * up));
                kick.Azimuth += share * aside;
                next = Fly(request, in frame, things, in kick, FineStep);
                better = next.Meets && next.Miss < at.Miss;
                share *= 0.5;
            }

            if (!better)
            {
                break;
            }

            at = next;
        }

        at.IsFine = at.Meets;
        return at;
    }

    /// <summary>The turn that takes away the miss across the way: least squares of e + (∂p/∂θ) Δθ over the directions across v.</summary>
    private bool Step(AimRequest request, in TargetFrame frame, in BankShotStart at, out double up, out double aside)
    {
        // Along the way a miss is a matter of time alone: only what is across counts.
        Kick raised = at.Kick;
        raised.Elevation += Width;
        Kick turned = at.Kick;
        turned.Azimuth += Width;
        Vector3d byElevation = 1.0 / Width * (At(request, in frame, in raised, at.Time) - at.Position);
        Vector3d byAzimuth = 1.0 / Width * (At(request, in frame, in turned, at.Time) - at.Position);
        Vector3d way = at.Velocity.LengthSquared > 0 ? at.Velocity / at.Velocity.Length : Vector3d.Zero;
        Vector3d e = Across(at.Position - frame.Target, in way);
        byElevation = Across(in byElevation, in way);
        byAzimuth = Across(in byAzimuth, in way);
        double aa = byElevation.LengthSquared;
        double ab = Vector3d.Dot(in byElevation, in byAzimuth);
        double bb = byAzimuth.LengthSquared;
        double determinant = (aa * bb) - (ab * ab);
        double ea = Vector3d.Dot(in e, in byElevation);
        double eb = Vector3d.Dot(in e, in byAzimuth);
        up = ((ab * eb) - (bb * ea)) / determinant;
        aside = ((ab * ea) - (aa * eb)) / determinant;
        return determinant > 1e-12 * aa * bb && !double.IsNaN(up + aside);
    }

    /// <summary>Where a kick is at a time.</summary>
    private Vector3d At(AimRequest request, in TargetFrame frame, in Kick kick, double time)
    {
        kick.Vectors(request.Speed, frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.LaunchAt(request.From, velocity, spin, request.KickTime);
        _log.Clear();
        Simulations++;
        _simulator.Run(ref state, FineStep, time, StopAt.Time, _log, null);
        return state.Position;
    }

    private static Vector3d Across(in Vector3d v, in Vector3d way) => v - (Vector3d.Dot(in v, in way) * way);
}

/// <summary>A kick that was flown, and how close it comes after what it is to meet.</summary>
internal struct BankShotStart
{
    public Kick Kick;

    /// <summary>Whether it meets what it is to meet.</summary>
    public bool Meets;

    /// <summary>Whether it was flown in short steps.</summary>
    public bool IsFine;

    /// <summary>Closest approach, m.</summary>
    public double Miss;

    /// <summary>When, s.</summary>
    public double Time;

    /// <summary>Where, m.</summary>
    public Vector3d Position;

    /// <summary>How fast, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Whether it does what is asked.</summary>
    public readonly bool IsHit(AimRequest request) => IsFine && Miss <= request.Tolerance;
}
