using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Coulomb's limit of friction, for impulses and forces.</summary>
internal static class FrictionLaw
{
    /// <summary>Returns the greatest friction of a contact, μ N. Without a load it is zero, also if μ is infinite.</summary>
    /// <remarks>An infinite μ means that the surfaces stick: no load limits the friction, but a contact without a load has none.</remarks>
    /// <param name="friction">μ; 0 … ∞.</param>
    /// <param name="load">N or J_n; not negative.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Limit(double friction, double load) => load > 0 ? friction * load : 0;
}
