using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Estimates a surface from impacts: restitution, its increase at grazing impacts, and friction.</summary>
/// <remarks>
/// Gauss–Newton least squares on the ratios of normal and tangential speeds after and before an impact. Outliers are down-weighted (Huber), so that a
/// touch mistaken for an impact does no harm.
/// </remarks>
internal sealed class SurfaceFit
{
    private const int Numbers = 3;
    private const int MostSteps = 30;

    /// <summary>The minimum normal speed of an impact, in m/s; slower ones are hops in the grass.</summary>
    private const double LeastApproach = 1.2;

    /// <summary>The minimum tangential speed at which friction can be estimated, in m/s.</summary>
    private const double LeastAlong = 2;

    /// <summary>The scatter of the ratios between impacts on a real pitch, in addition to the uncertainty of the flights.</summary>
    private const double Scatter = 0.06;

    /// <summary>The Huber threshold, in standard deviations.</summary>
    private const double Outlier = 1.5;

    /// <summary>The prior standard deviations of the parameters, about the ground's own values.</summary>
    private static readonly double[] KnownDeviations = [0.15, 0.6, 0.5];

    private static readonly double[] Steps = [1e-4, 1e-4, 1e-4];

    private readonly BallProperties _ball;
    private readonly Ground _ground;
    private readonly List<MatchPiece> _impacts;

    /// <summary>Estimates the parameters.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="ground">The prior surface; its other values are kept.</param>
    /// <param name="pieces">The pieces of the match.</param>
    public SurfaceFit(BallProperties ball, Ground ground, List<MatchPiece> pieces)
    {
        _ball = ball;
        _ground = ground;
        _impacts = pieces.FindAll(p => p.Kind == MatchPieceKind.Impact && p.Restitution is not null && -p.VelocityBefore.Y > LeastApproach);
        Ground = ground;
        if (_impacts.Count > 0)
        {
            Find();
        }
    }

    /// <summary>The ground with the estimated parameters.</summary>
    public Ground Ground { get; private set; }

    /// <summary>The number of impacts used.</summary>
    public int Impacts => _impacts.Count;

    /// <summary>The estimated parameters.</summary>
    public Estimate[] Estimates { get; private set; } = [];

    /// <summary>Estimates the parameters and their standard deviations.</summary>
    private void Find()
    {
        // 1. Reweighted least squares. 2. The remaining scatter, and the uncertainty from it.
        double[] likely = [_ground.Material.NormalRestitution, _ground.Material.GrazingRestitutionGain, Math.Min(_ground.Material.ImpactFriction, 2)];
        double[] values = (double[])likely.Clone();
        double[] normal = new double[Numbers * Numbers];
        double[] right = new double[Numbers];
        double[] step = new double[Numbers];
        for (int i = 0; i < MostSteps; i++)
        {
            Equations(values, likely, normal, right, out _);
            if (!Linear.Solve(normal, right, step, Numbers))
            {
                break;
            }

            double change = 0;
            for (int k = 0; k < Numbers; k++)
            {
                double moved = Math.Min(k < 2 ? 1.0 : 2.0, Math.Max(0, values[k] + (0.7 * step[k])));
                change = Math.Max(change, Math.Abs(moved - values[k]));
                values[k] = moved;
            }

            if (change < 1e-6)
            {
                break;
            }
        }

        Equations(values, likely, normal, right, out double scatter);
        double[] inverse = new double[Numbers * Numbers];
        Linear.Invert(normal, inverse, Numbers);
        string[] names = ["restitution", "restitutionRise", "friction"];
        Estimates = new Estimate[Numbers];
        for (int k = 0; k < Numbers; k++)
        {
            double variance = inverse[(k * Numbers) + k] * Math.Max(1, scatter);
            Estimates[k] = new Estimate(names[k], values[k], variance > 0 ? Math.Min(KnownDeviations[k], Math.Sqrt(variance)) : KnownDeviations[k]);
        }

        Ground = With(values);
    }

    private Ground With(double[] values) => _ground with
    {
        Material = _ground.Material with { NormalRestitution = values[0], GrazingRestitutionGain = values[1], ImpactFriction = values[2] },
    };

    /// <summary>Assembles the normal equations, including the prior.</summary>
    private void Equations(double[] values, double[] likely, double[] normal, double[] right, out double scatter)
    {
        Array.Clear(normal, 0, normal.Length);
        double squares = 0;
        double weights = 0;
        for (int k = 0; k < Numbers; k++)
        {
            double weight = 1 / (KnownDeviations[k] * KnownDeviations[k]);
            normal[(k * Numbers) + k] = weight;
            right[k] = weight * (likely[k] - values[k]);
        }

        double[] changed = new double[Numbers];
        var materials = new ContactMaterial[Numbers];
        var at = new ContactMaterial(With(values), _ball.Bounce);
        for (int k = 0; k < Numbers; k++)
        {
            Array.Copy(values, changed, Numbers);
            changed[k] += Steps[k];
            materials[k] = new ContactMaterial(With(changed), _ball.Bounce);
        }

        foreach (MatchPiece impact in _impacts)
        {
            Vector3d before = impact.VelocityBefore;
            double approach = -before.Y;
            double speed = before.Horizontal.Length;
            Shares(in at, impact, out double bounce, out double kept);
            double[] misses = [impact.Restitution!.Value - bounce, speed > LeastAlong ? impact.SpeedRetained - kept : 0];
            double[] sizes = [approach, speed];
            for (int row = 0; row < (speed > LeastAlong ? 2 : 1); row++)
            {
                double unsure = impact.VelocityDeviation.Length / sizes[row];
                double deviation = Math.Sqrt((Scatter * Scatter) + (unsure * unsure));
                double off = Math.Abs(misses[row]) / deviation;
                double weight = Huber.Weight(off, Outlier) / (deviation * deviation);
                squares += weight * misses[row] * misses[row];
                weights++;
                double[] slope = new double[Numbers];
                for (int k = 0; k < Numbers; k++)
                {
                    Shares(in materials[k], impact, out double otherBounce, out double otherKept);
                    slope[k] = ((row == 0 ? otherBounce : otherKept) - (row == 0 ? bounce : kept)) / Steps[k];
                }

                for (int k = 0; k < Numbers; k++)
                {
                    right[k] += weight * slope[k] * misses[row];
                    for (int j = 0; j < Numbers; j++)
                    {
                        normal[(k * Numbers) + j] += weight * slope[k] * slope[j];
                    }
                }
            }
        }

        scatter = squares / Math.Max(1, weights - Numbers);
    }

    /// <summary>Computes the ratios of the normal and tangential speeds after and before an impact.</summary>
    private void Shares(in ContactMaterial material, MatchPiece impact, out double bounce, out double kept)
    {
        Vector3d before = impact.VelocityBefore;
        ImpactLaw.Apply(_ball, in material, Vector3d.Up, Vector3d.Zero, in before, impact.SpinBefore, out Vector3d after, out _);
        Vector3d along = before.Horizontal;
        bounce = after.Y / -before.Y;
        kept = along.LengthSquared > 0 ? Vector3d.Dot(along, after.Horizontal) / along.LengthSquared : 1;
    }
}
