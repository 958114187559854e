using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Rates of change of a motion on the flat ground: acceleration along x and z, and angular acceleration.</summary>
internal struct PlanarRates
{
    public double AX;
    public double AZ;
    public double BX;
    public double BY;
    public double BZ;

    /// <summary>v̇, m/s².</summary>
    public readonly Vector3d Acceleration => new(AX, 0, AZ);

    /// <summary>ω̇, rad/s².</summary>
    public readonly Vector3d SpinAcceleration => new(BX, BY, BZ);

    /// <inheritdoc cref="PlanarMotion.CopyTo"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void CopyTo(out PlanarRates copy)
    {
        copy.AX = AX;
        copy.AZ = AZ;
        copy.BX = BX;
        copy.BY = BY;
        copy.BZ = BZ;
    }
}
