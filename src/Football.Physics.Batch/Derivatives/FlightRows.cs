using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>The derivatives of one number of a flight by the velocity, the magnitude of the spin, and its axis in two directions, at the start.</summary>
internal struct FlightRow(in Vector3d byVelocity, in Vector3d bySpin)
{
    public Vector3d ByVelocity = byVelocity;
    public Vector3d BySpin = bySpin;

    /// <summary>a + h b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FlightRow Sum(in FlightRow a, double h, in FlightRow b) => new(a.ByVelocity + (h * b.ByVelocity), a.BySpin + (h * b.BySpin));
}

/// <summary>The derivatives of velocity and spin magnitude by those at the start of a flight.</summary>
internal struct FlightColumns
{
    public FlightRow X;
    public FlightRow Y;
    public FlightRow Z;
    public FlightRow Spin;

    /// <summary>The derivatives at the start.</summary>
    public static FlightColumns Identity => new()
    {
        X = new FlightRow(new Vector3d(1, 0, 0), Vector3d.Zero),
        Y = new FlightRow(new Vector3d(0, 1, 0), Vector3d.Zero),
        Z = new FlightRow(new Vector3d(0, 0, 1), Vector3d.Zero),
        Spin = new FlightRow(Vector3d.Zero, new Vector3d(1, 0, 0)),
    };

    /// <summary>a + h b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Sum(in FlightColumns a, double h, in FlightColumns b, out FlightColumns sum)
    {
        sum.X = FlightRow.Sum(in a.X, h, in b.X);
        sum.Y = FlightRow.Sum(in a.Y, h, in b.Y);
        sum.Z = FlightRow.Sum(in a.Z, h, in b.Z);
        sum.Spin = FlightRow.Sum(in a.Spin, h, in b.Spin);
    }
}
