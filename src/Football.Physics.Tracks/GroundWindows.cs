using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tracks;

/// <summary>Finds the intervals in which a ball on the ground slides or rolls untouched, and the resistance in each.</summary>
/// <remarks>
/// In a slide, friction is −μ_s N ŝ in a constant direction; a ball that rolls straight loses (c₀ + c₁ v) N/m. Both are constant accelerations once
/// the share of the air is subtracted. So the time on the ground is divided into parabolas, with touches, track errors and the ends of slides between
/// them.
/// </remarks>
internal sealed class GroundWindows
{
    /// <summary>The deviation of a point from a parabola beyond its noise, in m.</summary>
    private const double ParabolaError = 0.006;

    /// <summary>The cost of a segment, in squared standard deviations: for the six coefficients of two parabolas, and its start.</summary>
    private const double Price = 20;

    private const double LongestPiece = 2;

    /// <summary>The minimum number of points dropped at each end of a segment, because trackers smooth over touches.</summary>
    private const int LeastTrim = 2;

    /// <summary>The minimum change of acceleration at the end of a slide, in m/s²; the time of that end is uncertain by √(2 σ/Δa).</summary>
    private const double EndOfSlide = 4;

    private const int LeastPoints = 6;
    private const double LeastDuration = 0.2;

    /// <summary>The speed below which grass and slope determine the motion, in m/s.</summary>
    private const double LeastSpeed = 1.2;

    /// <summary>The change of height of a hopping ball, in m, plus a multiple of the noise.</summary>
    private const double Hop = 0.1;
    private const double NoiseShare = 6;

    /// <summary>The largest standard error of a resistance.</summary>
    private const double MostDeviation = 0.03;

    /// <summary>The largest ratio of transverse to longitudinal acceleration in a slide; more indicates sidespin, a track error, or a slide in
    /// another direction.</summary>
    private const double SlideAcross = 0.35;

    /// <summary>The largest transverse resistance of a rolling ball.</summary>
    private const double RollAcross = 0.15;

    /// <summary>The largest resistance of a slide on any surface; a larger one means that someone stops the ball.</summary>
    private const double MostSliding = 1.5;

    /// <summary>The relative uncertainty of the air's force, and the minimum error of the resistance: slopes of the pitch, uneven grass.</summary>
    private const double AirShare = 0.1;
    private const double LeastDeviation = 0.002;

    private const int Rounds = 4;

    /// <summary>The step for the air's acceleration, in s.</summary>
    private const double AirStep = 1e-3;

    /// <summary>The minimum ratio of sliding to rolling friction, and the minimum threshold between them.</summary>
    private const double LeastContrast = 1.5;
    private const double LeastThreshold = 0.1;

    private readonly Simulator _air;
    private readonly BallProperties _ball;
    private readonly GroundAerodynamics _aerodynamics;
    private readonly double _weight;
    private readonly double _threshold;
    private readonly double _noise;
    private readonly double _wait;
    private readonly int _trim;
    private readonly StepLog _log = new();

    /// <summary>Prepares for the pieces of a match.</summary>
    /// <param name="runs">The track.</param>
    /// <param name="air">The scene without ground, with the air and the ball estimated from the flights.</param>
    /// <param name="ground">The prior surface. A resistance above the geometric mean of its sliding and rolling friction is a slide.</param>
    public GroundWindows(TrackRuns runs, Simulator air, Ground ground)
    {
        _air = air;
        _ball = air.Scene.Ball;
        _aerodynamics = ground.Aerodynamics;
        _weight = -Weight.UpwardAcceleration(air.Scene);
        _noise = runs.Noise;
        _wait = runs.Wait;
        _trim = (int)Math.Max(LeastTrim, Math.Min(runs.Points.Length, Math.Ceiling(Math.Sqrt(2 * _noise / EndOfSlide) / _wait)));

        // The geometric mean of both resistances, with rolling at 4 m/s.
        double rolling = ground.Material.RollingResistance + (4 * ground.Material.RollingResistancePerSpeed);
        _threshold = Math.Max(LeastThreshold, Math.Sqrt(ground.Material.SlidingFriction * Math.Max(1e-3, Math.Min(rolling, ground.Material.SlidingFriction / LeastContrast))));
    }

    /// <summary>Finds the intervals, in order of time.</summary>
    public List<GroundWindow> Find(List<MatchPiece> pieces)
    {
        List<GroundWindow> windows = [];
        if (!(_weight > 0))
        {
            return windows;
        }

        foreach (MatchPiece piece in pieces)
        {
            if (piece.Kind == MatchPieceKind.Ground && piece.Points >= LeastPoints + (2 * _trim))
            {
                Divide((TrackPoint[])piece.Observed, windows);
            }
        }

        return windows;
    }

    /// <summary>Divides a piece on the ground into parabolas, and adds those that are clean rolls or slides.</summary>
    private void Divide(TrackPoint[] track, List<GroundWindow> windows)
    {
        // 1. Fit parabolas seen from above, because heights near the ground are inaccurate. 2. Measure each as a roll. 3. Measure the others as
        // slides, which end in a roll or start without spin.
        int longest = (int)Math.Max(8, Math.Min(LongestPiece / _wait, track.Length));
        List<int> ends = [];
        TrackPoint[] plan = Array.ConvertAll(track, point => new TrackPoint(point.Time, point.Position.Horizontal, point.Noise));
        new TrackSegments(plan, Math.Sqrt((_noise * _noise) + (ParabolaError * ParabolaError)), longest, Price, 2).Divide(0, track.Length, ends);
        var pieces = new TrackPoint[ends.Count][];
        var rolls = new Measured[ends.Count];
        for (int i = 0, first = 0; i < ends.Count; first = ends[i], i++)
        {
            int count = ends[i] - first - (2 * _trim);
            pieces[i] = count > 0 ? track.AsSpan(first + _trim, count).ToArray() : [];
            rolls[i] = IsLongEnough(pieces[i]) ? Measure(pieces[i], MotionState.Rolling, null) : default;
        }

        for (int i = 0; i < ends.Count; i++)
        {
            if (rolls[i].Speed < LeastSpeed || Rise(pieces[i]) > Hop + (NoiseShare * _noise))
            {
                continue;
            }

            bool slides = rolls[i].Along > _threshold;
            double? end = i + 1 < ends.Count && IsRoll(in rolls[i + 1]) ? EndOf(pieces[i], pieces[i + 1]) : null;
            Measured measured = slides ? Measure(pieces[i], MotionState.Sliding, end) : rolls[i];
            bool counts = measured.Deviation < MostDeviation && (slides ? IsSlide(in measured) : IsRoll(in measured));
            if (counts)
            {
                windows.Add(new GroundWindow
                {
                    Motion = slides ? MotionState.Sliding : MotionState.Rolling,
                    StartTime = pieces[i][0].Time,
                    EndTime = pieces[i][^1].Time,
                    Points = pieces[i].Length,
                    Speed = measured.Speed,
                    Resistance = slides ? Math.Sqrt((measured.Along * measured.Along) + (measured.Across * measured.Across)) : measured.Along,
                    StandardError = measured.Deviation,
                });
            }
        }
    }

    private static bool IsLongEnough(TrackPoint[] points) => points.Length >= LeastPoints && points[^1].Time - points[0].Time >= LeastDuration;

    /// <summary>True if a segment is a roll: friction only slows a ball, so a smaller loss than by air means a push or interpolated points.</summary>
    private bool IsRoll(in Measured measured) =>
        measured.Speed > LeastSpeed && measured.Along <= _threshold && measured.Along > 0 && Math.Abs(measured.Across) < RollAcross;

    private static bool IsSlide(in Measured measured) => measured.Along < MostSliding && Math.Abs(measured.Across) < SlideAcross * measured.Along;

    /// <summary>Returns the time at which a slide becomes a roll: the parabolas have equal velocities there.</summary>
    private static double EndOf(TrackPoint[] slide, TrackPoint[] roll)
    {
        var before = TrackPolynomial.Of(slide, 0, slide.Length, 2);
        var after = TrackPolynomial.Of(roll, 0, roll.Length, 2);
        double from = slide[^1].Time;
        double to = roll[0].Time;
        double middle = 0.5 * (from + to);
        Vector3d bend = (before.Acceleration - after.Acceleration).Horizontal;
        double off = bend.LengthSquared > 0 ? Vector3d.Dot((after.VelocityAt(middle) - before.VelocityAt(middle)).Horizontal, in bend) / bend.LengthSquared : 0;
        return Math.Min(to, Math.Max(from, middle + off));
    }

    private static double Rise(TrackPoint[] points)
    {
        double least = points[0].Position.Y;
        double most = least;
        foreach (TrackPoint point in points)
        {
            least = Math.Min(least, point.Position.Y);
            most = Math.Max(most, point.Position.Y);
        }

        return most - least;
    }

    /// <summary>Returns the resistance along and across the path for an assumed motion; a slide without a following roll starts without
    /// spin.</summary>
    private Measured Measure(TrackPoint[] points, MotionState motion, double? rollsFrom)
    {
        // Subtract the displacement by the air, ∬ a_air, and fit a parabola to the rest. The air's force depends on velocity and spin: iterate.
        int count = points.Length;
        double start = points[0].Time;
        var left = (TrackPoint[])points.Clone();
        var drift = new Vector3d[count];
        var speed = new Vector3d[count];
        TrackPolynomial parabola = default;
        Vector3d push = Vector3d.Zero;
        double load = _weight;
        double air = 0;
        for (int round = 0; round < Rounds; round++)
        {
            parabola = TrackPolynomial.Of(left, 0, count, 2);
            push = parabola.Acceleration.Horizontal;
            double end = rollsFrom ?? start;
            Vector3d last = rollsFrom is null ? Vector3d.Zero : parabola.VelocityAt(end).Horizontal + speed[count - 1];
            Vector3d path = Vector3d.Zero;
            Vector3d gained = Vector3d.Zero;
            Vector3d before = Vector3d.Zero;
            double loads = 0;
            double forces = 0;
            for (int i = 0; i < count; i++)
            {
                double time = points[i].Time;
                Vector3d v = parabola.VelocityAt(time).Horizontal + speed[i];

                // The velocity q at which a ball of this spin would roll: q̇ = −a/α in a slide, where a is the acceleration by friction.
                Vector3d q = motion == MotionState.Rolling ? v
                    : last + ((end - time) / _ball.InertiaFactor * push);
                Vector3d now = AirAt(points[i].Position, in v, in q, motion, out double normal);
                if (i > 0)
                {
                    double wait = time - points[i - 1].Time;
                    path += (wait * gained) + (wait * wait / 6.0 * ((2 * before) + now));
                    gained += 0.5 * wait * (before + now);
                }

                before = now;
                drift[i] = path;
                speed[i] = gained;
                loads += normal;
                forces += now.Length;
            }

            for (int i = 0; i < count; i++)
            {
                left[i] = new TrackPoint(points[i].Time, points[i].Position - drift[i], points[i].Noise);
            }

            load = Math.Max(0.1 * _weight, loads / count);
            air = forces / count / load;
        }

        parabola = TrackPolynomial.Of(left, 0, count, 2);
        push = parabola.Acceleration.Horizontal;
        Vector3d middle = parabola.VelocityAt(0.5 * (start + points[^1].Time)).Horizontal + speed[count / 2];
        double fast = middle.Length;
        Vector3d ahead = fast > 0 ? middle / fast : Vector3d.Zero;
        double scatter = Deviation(left, in parabola) / load;
        double unsure = AirShare * air;
        return new Measured
        {
            Speed = fast,
            Along = -Vector3d.Dot(in push, in ahead) / load,
            Across = Vector3d.Cross(in ahead, in push).Y / load,
            Deviation = Math.Sqrt((scatter * scatter) + (unsure * unsure) + (LeastDeviation * LeastDeviation)),
        };
    }

    /// <summary>Returns the air's acceleration along the ground for a velocity and the spin of a ball rolling at q, and the normal force per
    /// mass.</summary>
    private Vector3d AirAt(in Vector3d position, in Vector3d v, in Vector3d q, MotionState motion, out double normal)
    {
        normal = _weight;
        if (_aerodynamics == GroundAerodynamics.None)
        {
            return Vector3d.Zero;
        }

        double r = _ball.Radius;
        Vector3d spin = Vector3d.Cross(Vector3d.Up, in q) / r;
        BallState state = _air.LaunchAt(in position, in v, in spin, 0);
        _log.Clear();
        _air.Advance(ref state, AirStep, _log);
        Vector3d acceleration = (state.Velocity - v) / AirStep;
        Vector3d along = acceleration.Horizontal;
        if (_aerodynamics != GroundAerodynamics.Full)
        {
            return along;
        }

        // For a rolling ball, v̇ = (F_air + (T_D × ŷ)/r)/(m (1 + α)) with T_D = α m r² ω̇.
        normal = -acceleration.Y;
        double alpha = _ball.InertiaFactor;
        Vector3d turning = Vector3d.Cross((state.Spin - spin) / AirStep, Vector3d.Up);
        return motion == MotionState.Rolling ? (along + (alpha * r * turning)) / (1.0 + alpha) : along;
    }

    /// <summary>Returns the standard deviation of a parabola's acceleration, from the scatter of the points and their autocorrelation.</summary>
    private static double Deviation(TrackPoint[] points, in TrackPolynomial parabola)
    {
        int count = points.Length;
        double middle = 0.5 * (points[0].Time + points[^1].Time);
        double half = 0.5 * (points[^1].Time - points[0].Time);
        var misses = new Vector3d[count];
        double squares = 0;
        double[] moments = new double[5];
        for (int i = 0; i < count; i++)
        {
            double t = (points[i].Time - middle) / half;
            misses[i] = (points[i].Position - parabola.At(points[i].Time)).Horizontal;
            squares += misses[i].LengthSquared;
            double power = 1;
            for (int k = 0; k < moments.Length; k++, power *= t)
            {
                moments[k] += power;
            }
        }

        // The variance of the coefficient of t²: the last element of the inverse moment matrix.
        double[] system = new double[12];
        double[] inverse = new double[3];
        for (int i = 0; i < 3; i++)
        {
            for (int k = 0; k < 3; k++)
            {
                system[(i * 4) + k] = moments[i + k];
            }
        }

        system[11] = 1;
        if (!Linear.Solve(system, inverse, 3))
        {
            return double.PositiveInfinity;
        }

        double together = 1;
        for (int lag = 1; lag < count / 2; lag++)
        {
            double sum = 0;
            for (int i = lag; i < count; i++)
            {
                sum += Vector3d.Dot(in misses[i], in misses[i - lag]);
            }

            if (!(sum > 0))
            {
                break;
            }

            together += 2 * sum / squares;
        }

        double variance = squares / ((2 * count) - 6);
        return 2 / (half * half) * Math.Sqrt(Math.Max(0, inverse[2]) * variance * together);
    }

    /// <summary>The speed, the resistance along and across the path, and the standard error; all zero for a segment that is too short.</summary>
    private struct Measured
    {
        public double Speed;
        public double Along;
        public double Across;
        public double Deviation;
    }
}
