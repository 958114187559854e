using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Scenes;

/// <summary>Samples the normals of a game's own shape for its strongest concave curvature, because a stated value can be too small.</summary>
/// <remarks>
/// The samples lie at the level of the ball's centre, so hollows that the ball cannot enter do not count. The curvature comes from differences of normals and
/// not from <see cref="ShapePoint.Curvature"/>, which may be an approximation. A normal that jumps, as at a ridge, has no curvature. The sequence of samples is
/// fixed, and uses only exact operations, so every machine finds the same value.
/// </remarks>
internal static class HollowSamples
{
    private const int Samples = 192;
    private const int MostProjections = 16;

    /// <summary>The half sizes of the boxes that are searched around the part of the shape that is nearest to its origin, m.</summary>
    private static readonly double[] s_reaches = [2, 16, 128];

    /// <summary>The step of the differences, m.</summary>
    private const double Step = 1e-4;

    /// <summary>A difference counts if twice the step gives the same, relative, and 1/m.</summary>
    private const double Agreement = 1e-2;

    /// <summary>The distance from the level at which a sample is on it, m.</summary>
    private const double OnLevel = 1e-6;

    /// <summary>The step at which the climb to the strongest curvature ends, m.</summary>
    private const double LastClimb = 1e-5;

    /// <summary>A stated value is too small if the samples exceed it by more than this share, or 1/m.</summary>
    private const double Excess = 1e-3;

    /// <summary>The largest sampled curvature that is used, relative to that of the ball: the search has no bound at the curvature of the ball itself.</summary>
    private const double MostOfBall = 0.95;

    private static readonly ConditionalWeakTable<IShape, Known> s_known = new();

    /// <summary>Returns the concave curvature that the contact search uses, 1/m: the stated one unless samples contradict it.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="level">The distance of the ball's centre from the surface, m.</param>
    public static double Corrected(IShape shape, double level)
    {
        double stated = shape.MaximumConcaveCurvature;
        Hollow sampled = Of(shape, level);
        return sampled.Strongest > stated + (Excess * Math.Max(1.0, stated)) ? Math.Min(sampled.Strongest, MostOfBall / level) : stated;
    }

    /// <summary>Throws if the ball does not fit into the hollows of a shape.</summary>
    /// <remarks>
    /// A hollow in one direction, such as a rim or a pipe, may curve up to 1/r. A hollow in both directions, such as a bowl, may curve up to 1/(2r).
    /// </remarks>
    /// <param name="field">The name of the object.</param>
    /// <param name="shape">The shape.</param>
    /// <param name="radius">The radius of the ball, m.</param>
    public static void Validate(string field, IShape shape, double radius)
    {
        field += ".shape.maximumConcaveCurvature";
        double stated = shape.MaximumConcaveCurvature;
        if (!(stated >= 0.0 && stated * radius < 1.0))
        {
            throw Check.Refusal(field, FormattableString.Invariant($"{stated}"), FormattableString.Invariant($"0 or more, below {1.0 / radius:G6}, the curvature of the ball"));
        }

        if (stated * radius > 0.5 && Of(shape, radius).Both * radius > 0.5)
        {
            throw Check.Refusal(field, FormattableString.Invariant($"{stated}"), FormattableString.Invariant($"0 … {0.5 / radius:G6} for a surface that is hollow in two directions, as a bowl is"));
        }
    }

    /// <summary>Returns a sentence for each value that is replaced in a scene.</summary>
    public static IReadOnlyList<string> Warnings(Scene scene)
    {
        double radius = scene.Ball.Radius;
        return
        [
            .. scene.Obstacles.Select((obstacle, i) => Warning(Check.Item("obstacles", i), obstacle.Shape, radius))
                .Concat((scene.Bodies ?? Enumerable.Empty<KinematicBody>()).Select((body, i) => Warning(Check.Item("bodies", i), body.Shape, radius)))
                .Concat(scene.Zones.Select((zone, i) => Warning(Check.Item("zones", i), zone.Shape, zone.LevelOf(radius))))
                .OfType<string>(),
        ];
    }

    /// <summary>Returns the sentence that reports a replaced value; null if the stated value holds.</summary>
    /// <param name="field">The name of the object.</param>
    /// <param name="shape">The shape.</param>
    /// <param name="level">The distance of the ball's centre from the surface, m.</param>
    private static string? Warning(string field, IShape shape, double level)
    {
        double stated = shape.MaximumConcaveCurvature;
        double used = Corrected(shape, level);
        return used == stated ? null
            : FormattableString.Invariant($"{field}.shape.maximumConcaveCurvature is {stated:G6}, but the normals of the shape turn by {used:G6} 1/m. The simulator uses {used:G6}. Return this value or a larger one.");
    }

    /// <summary>Returns the strongest concave curvatures of a shape; 0 for the library's own shapes, which state theirs.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="level">The distance of the ball's centre from the surface, m.</param>
    private static Hollow Of(IShape shape, double level)
    {
        if (shape is IExactHollow)
        {
            return default;
        }

        // Several simulators may use one shape, with balls of different radii.
        if (!(s_known.TryGetValue(shape, out Known? known) && known.Level == level))
        {
            known = new Known(level, Search(shape, level));
            s_known.AddOrUpdate(shape, known);
        }

        return known.Found;
    }

    private static Hollow Search(IShape shape, double level)
    {
        Bounds3d bounds = shape.Bounds.Expanded(2.0 * level);
        Vector3d nearest = Within(in bounds, Vector3d.Zero);
        Hollow most = default;
        Vector3d best = default;
        double reached = 0;
        foreach (double reach in s_reaches)
        {
            var box = new Bounds3d(
                Within(in bounds, nearest - new Vector3d(reach, reach, reach)), Within(in bounds, nearest + new Vector3d(reach, reach, reach)));
            for (int i = 1; i <= Samples; i++)
            {
                var share = new Vector3d(Halton(i, 2), Halton(i, 3), Halton(i, 5));
                Vector3d size = box.Max - box.Min;
                Vector3d place = box.Min + new Vector3d(share.X * size.X, share.Y * size.Y, share.Z * size.Z);
                if (At(shape, level, ref place, out Hollow found))
                {
                    best = found.Strongest > most.Strongest ? place : best;
                    reached = found.Strongest > most.Strongest ? reach : reached;
                    most = most.Or(in found);
                }
            }

            if (box.Min == bounds.Min && box.Max == bounds.Max)
            {
                break;
            }
        }

        return most.Strongest > 0 ? Climbed(shape, level, best, most, 0.25 * reached) : most;
    }

    /// <summary>Climbs from a sample to the strongest curvature near it.</summary>
    private static Hollow Climbed(IShape shape, double level, Vector3d best, Hollow most, double step)
    {
        while (step > LastClimb)
        {
            bool climbs = false;
            for (int axis = 0; axis < 6; axis++)
            {
                double way = axis < 3 ? step : -step;
                Vector3d place = best + new Vector3d(axis % 3 == 0 ? way : 0, axis % 3 == 1 ? way : 0, axis % 3 == 2 ? way : 0);
                if (At(shape, level, ref place, out Hollow found))
                {
                    bool higher = found.Strongest > most.Strongest;
                    best = higher ? place : best;
                    climbs |= higher;
                    most = most.Or(in found);
                }
            }

            step = climbs ? step : 0.5 * step;
        }

        return most;
    }

    /// <summary>Moves a point to the level, and returns the concave curvatures of the surface below it.</summary>
    /// <returns>False if the point does not reach the level, or the normal has no derivative there.</returns>
    private static bool At(IShape shape, double level, ref Vector3d place, out Hollow found)
    {
        found = default;
        ShapePoint at = shape.At(in place);
        for (int i = 0; i < MostProjections && Math.Abs(at.Distance - level) > OnLevel; i++)
        {
            place -= (at.Distance - level) * at.Normal;
            at = shape.At(in place);
        }

        if (!(Math.Abs(at.Distance - level) <= OnLevel) || !place.IsFinite || !(Math.Abs(at.Normal.LengthSquared - 1.0) < Agreement))
        {
            return false;
        }

        Vector3d n = at.Normal;
        Vector3d side = Math.Abs(n.X) < Math.Abs(n.Y) ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
        Vector3d first = Vector3d.Cross(in n, in side);
        first /= first.Length;
        Vector3d second = Vector3d.Cross(in n, in first);
        if (!Turns(shape, in place, in first, out Vector3d along) || !Turns(shape, in place, in second, out Vector3d across))
        {
            return false;
        }

        // The smaller and the larger eigenvalue of the symmetric part of the derivative of the normal. A negative one is hollow.
        double a = Vector3d.Dot(in along, in first);
        double b = 0.5 * (Vector3d.Dot(in along, in second) + Vector3d.Dot(in across, in first));
        double c = Vector3d.Dot(in across, in second);
        double root = Math.Sqrt((0.25 * (a - c) * (a - c)) + (b * b));
        found = new Hollow(Surface((0.5 * (a + c)) - root, level), Surface((0.5 * (a + c)) + root, level));
        return true;
    }

    /// <summary>Returns the concave curvature of the surface, κ, from that at the level: −λ = κ/(1 − κ d).</summary>
    private static double Surface(double eigenvalue, double level) => eigenvalue < 0 ? -eigenvalue / (1.0 - (eigenvalue * level)) : 0;

    /// <summary>Computes the derivative of the normal along a direction.</summary>
    /// <returns>False if the normal jumps there.</returns>
    private static bool Turns(IShape shape, in Vector3d place, in Vector3d along, out Vector3d rate)
    {
        rate = Difference(shape, in place, Step * along) / (2.0 * Step);
        Vector3d wide = Difference(shape, in place, 2.0 * Step * along) / (4.0 * Step);
        return (rate - wide).Length <= Agreement * Math.Max(1.0, rate.Length);
    }

    private static Vector3d Difference(IShape shape, in Vector3d place, in Vector3d step) => shape.At(place + step).Normal - shape.At(place - step).Normal;

    private static Vector3d Within(in Bounds3d bounds, in Vector3d point) => new(
        Math.Max(bounds.Min.X, Math.Min(bounds.Max.X, point.X)),
        Math.Max(bounds.Min.Y, Math.Min(bounds.Max.Y, point.Y)),
        Math.Max(bounds.Min.Z, Math.Min(bounds.Max.Z, point.Z)));

    /// <summary>Returns an element of the Halton sequence, 0 … 1.</summary>
    private static double Halton(int index, int radix)
    {
        double share = 1;
        double value = 0;
        for (int i = index; i > 0; i /= radix)
        {
            share /= radix;
            value += share * (i % radix);
        }

        return value;
    }

    private sealed record Known(double Level, Hollow Found);
}

/// <summary>The strongest concave curvatures of a surface, 1/m.</summary>
/// <param name="Strongest">The strongest in any direction.</param>
/// <param name="Both">The strongest that holds in both principal directions of one point: 0 for a pipe or a rim, and the first for a bowl.</param>
internal readonly record struct Hollow(double Strongest, double Both)
{
    public Hollow Or(in Hollow other) => new(Math.Max(Strongest, other.Strongest), Math.Max(Both, other.Both));
}

/// <summary>A shape of the library: its <see cref="IShape.MaximumConcaveCurvature"/> is right and needs no samples.</summary>
internal interface IExactHollow;
