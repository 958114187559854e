using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>How a number of a flight changes with velocity and spin at its start: by the velocity; by size of the spin, and by its axis in two directions across it.</summary>
internal struct FlightRow
{
    public Vector3d ByVelocity;
    public Vector3d BySpin;

    public FlightRow(in Vector3d byVelocity, in Vector3d bySpin)
    {
        ByVelocity = byVelocity;
        BySpin = bySpin;
    }

    /// <summary>a + h b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FlightRow Sum(in FlightRow a, double h, in FlightRow b) => new(a.ByVelocity + (h * b.ByVelocity), a.BySpin + (h * b.BySpin));
}
