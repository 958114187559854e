namespace FootballPhysics;

/// <summary>A soft sheet: a rectangle that takes energy from the ball and gives it back slowly.</summary>
/// <remarks>
/// It is met when the centre comes within a radius of its plane inside the rectangle, from the side σ = ±1 on which it is, and left when the depth
/// δ = r − σ (p − c)·n falls back to 0, or where the centre is beyond its edge by r and the depth in the net that the ball is deepest in: it rolls off the roof of a
/// goal, and is not let through where two nets are joined. In between F = σ k δ max(0, 1 + b δ̇) n − k_t δ v_t, T = −k_ω δ ω. A ball that hangs in it comes to rest
/// when its energy is below <see cref="Ground.RestEnergy"/> and all that acts on it is in balance, to 0.01 m/s².
/// </remarks>
public sealed record Net
{
    /// <summary>Its name, for events and messages. Default "net".</summary>
    public string Name { get; init; } = "net";

    /// <summary>Centre of the rectangle, m; components within ±1e6.</summary>
    public required Vector3d Center { get; init; }

    /// <summary>Normal of its plane; any length but 0.</summary>
    public required Vector3d Normal { get; init; }

    /// <summary>Direction of the first half size, across the normal; any length but 0.</summary>
    public required Vector3d Along { get; init; }

    /// <summary>Half its size along <see cref="Along"/>, m; above 0.</summary>
    public required double HalfLength { get; init; }

    /// <summary>Half its size along normal × along, m; above 0.</summary>
    public required double HalfWidth { get; init; }

    /// <summary>Stiffness k, N/m. 0 … 1e5; default 400.</summary>
    public double Stiffness { get; init; } = 400;

    /// <summary>Damping b: the ball leaves the net at 1/b at most, s/m. 0 … 100; default 1.5.</summary>
    public double Damping { get; init; } = 1.5;

    /// <summary>Damping along the sheet k_t, N s/m². 0 … 1e4; default 60.</summary>
    public double TangentialDamping { get; init; } = 60;

    /// <summary>Damping of the spin k_ω, N s. 0 … 10; default 0.02.</summary>
    public double SpinDamping { get; init; } = 0.02;

    internal void Validate(string field)
    {
        _ = Name ?? throw Check.Refusal(field + ".name", "null", "a name");
        Check.Place(field + ".center", Center);

        // Both directions are needed, and at right angles: the third edge is their product.
        Vector3d normal = Check.Direction(field + ".normal", Normal);
        Vector3d along = Check.Direction(field + ".along", Along);
        if (Math.Abs(Vector3d.Dot(in normal, in along)) > 1e-6)
        {
            throw Check.Refusal(field + ".along", Along.ToString(), "a direction across the normal");
        }

        Check.Within(field + ".halfSize[0]", HalfLength, 0, Limits.Length, exclusiveLow: true);
        Check.Within(field + ".halfSize[1]", HalfWidth, 0, Limits.Length, exclusiveLow: true);
        SceneFields.Check(SceneFields.Net, this, field + ".");
    }
}
