namespace FootballPhysics.Contacts;

/// <summary>Rolling and drilling resistance at the contact of a ball with the greatest load: the spin that they remove in a solution by impulses.</summary>
internal struct TurningResistance
{
    /// <summary>Index of that contact; −1 if none has a load.</summary>
    public int Bearer;

    /// <summary>Spin removed about the normal, rad/s.</summary>
    public double Drilling;

    /// <summary>Spin removed from the rolling, rad/s.</summary>
    public Vector3d Rolling;

    /// <summary>n of that contact.</summary>
    public Vector3d Normal;

    /// <summary>No resistance.</summary>
    public static TurningResistance None => new() { Bearer = -1 };

    /// <summary>All spin removed, rad/s.</summary>
    public readonly Vector3d Removed => Rolling + (Drilling * Normal);

    /// <summary>Moves to the contact that now has the greatest load, and undoes the resistance at the old one.</summary>
    public void MoveTo(int bearer, in Vector3d normal, ref Vector3d w)
    {
        if (bearer != Bearer)
        {
            w -= Removed;
            this = new TurningResistance { Bearer = bearer, Normal = normal };
        }
    }

    /// <summary>Applies drilling friction b μ_s J_n/I and damping c_ω h/I about the normal, and rolling resistance across it.</summary>
    /// <remarks>Rolling resistance is (1 + α)(c₀ + c₁ |v|) r J_n/I, which slows the rolling by (c₀ + c₁ |v|) J_n/m.</remarks>
    /// <param name="damping">c_ω h/I.</param>
    /// <param name="mostDrilling">The largest change of the spin by drilling friction, rad/s.</param>
    /// <param name="mostRolling">The largest change of the spin by rolling resistance, rad/s.</param>
    /// <param name="w">The spin, rad/s.</param>
    /// <returns>Change of the spin, rad/s.</returns>
    public double Act(double damping, double mostDrilling, double mostRolling, ref Vector3d w)
    {
        // About the normal: the damping c_ω reduces the spin ω_n to ω_n/(1 + k), k = c_ω h/I, over the part h; then drilling friction reduces it.
        double about = Vector3d.Dot(in w, in Normal);
        double damped = (about - Drilling) / (1.0 + damping);
        double kept = damped > 0 ? Math.Max(0, damped - mostDrilling) : Math.Min(0, damped + mostDrilling);
        double drilled = kept - about;
        Drilling += drilled;

        // Across the normal: the rolling resistance, which is limited by the load and never reverses the roll.
        Vector3d turning = w - (about * Normal) - Rolling;
        double size = turning.Length;
        Vector3d resisted = size > mostRolling ? -(mostRolling / size) * turning : -turning;
        Vector3d more = resisted - Rolling;
        Rolling = resisted;
        w += (drilled * Normal) + more;
        return Math.Max(Math.Abs(drilled), more.Length);
    }
}
