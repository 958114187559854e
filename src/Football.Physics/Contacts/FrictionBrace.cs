namespace FootballPhysics.Contacts;

/// <summary>Resolves undetermined forces: a ball that sticks to two surfaces may push them apart along the line between the contact
/// points.</summary>
/// <remarks>If the smallest forces are outside a friction cone, the smallest change along that line moves them into both cones.</remarks>
internal static unsafe class FrictionBrace
{
    /// <summary>Forces are moved this far inside a friction cone, as a share of the square.</summary>
    private const double Inside = 1.0 - ContactTolerances.InsideCone;

    /// <summary>Returns the share λ of the change z that moves the forces x into both cones; 0 if they are inside, or if no λ
    /// does.</summary>
    /// <param name="x">Load and friction of the first contact, along its two directions.</param>
    /// <param name="z">The change of these forces.</param>
    /// <param name="sliding">Its μ_s.</param>
    /// <param name="otherX">The forces of the second contact.</param>
    /// <param name="otherZ">Their change.</param>
    /// <param name="otherSliding">Its μ_s.</param>
    public static double Share(double* x, double* z, double sliding, double* otherX, double* otherZ, double otherSliding)
    {
        if (!IsBeyondCone(x, sliding) && !IsBeyondCone(otherX, otherSliding))
        {
            return 0;
        }

        double low = double.NegativeInfinity;
        double high = double.PositiveInfinity;
        Allow(x, z, sliding, ref low, ref high);
        Allow(otherX, otherZ, otherSliding, ref low, ref high);
        double share = low > 0 ? low : high < 0 ? high : 0;
        return low <= high && Math.Abs(share) < double.MaxValue ? share : 0;
    }

    private static bool IsBeyondCone(double* x, double sliding) =>
        (x[1] * x[1]) + (x[2] * x[2]) > sliding * sliding * x[0] * x[0] || x[0] < 0;

    /// <summary>Narrows the range of λ for which the friction stays in its cone, |F + λ z_F| ≤ μ (N + λ z_N), on the side where the load
    /// grows.</summary>
    private static void Allow(double* x, double* z, double sliding, ref double low, ref double high)
    {
        double mu = sliding * sliding * Inside;
        double a = (z[1] * z[1]) + (z[2] * z[2]) - (mu * z[0] * z[0]);
        double b = (x[1] * z[1]) + (x[2] * z[2]) - (mu * x[0] * z[0]);
        double c = (x[1] * x[1]) + (x[2] * x[2]) - (mu * x[0] * x[0]);
        double square = (b * b) - (a * c);
        double root = Math.Sqrt(Math.Max(0, square));
        if (a < 0)
        {
            // The load is positive beyond the larger root.
            double least = (-b - (z[0] > 0 ? root : -root)) / a;
            low = z[0] > 0 ? Math.Max(low, least) : low;
            high = z[0] < 0 ? Math.Min(high, least) : high;
        }
        else if (a > 0 && square >= 0)
        {
            low = Math.Max(low, (-b - root) / a);
            high = Math.Min(high, (-b + root) / a);
        }
        else
        {
            high = double.NegativeInfinity;
        }
    }
}
