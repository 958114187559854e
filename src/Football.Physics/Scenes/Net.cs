using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>A net: a soft rectangle that absorbs most of the ball's energy.</summary>
/// <remarks>
/// Contact begins when the ball's centre comes within one radius of the plane, inside the rectangle, on side σ = ±1. Contact ends when the depth
/// δ = r − σ (p − c)·n returns to 0. It also ends when the centre is farther beyond the edge than r plus the greatest depth in any net. The ball can therefore
/// roll off the roof of a goal, but cannot pass between two joined nets.
/// <para>In contact, F = σ k δ max(0, 1 + b δ̇) n − k_t δ v_t and T = −k_ω δ ω. A ball in the net comes to rest if its energy is below
/// <see cref="Ground.RestEnergy"/> and all forces balance to within 0.01 m/s².</para>
/// <para>A net ends at the depth <see cref="Give"/>. There it stops the ball like a stationary plane with normal σ n, without bounce and without friction, and
/// reports an impact. A ball that a player presses into the end of a net is pinned, as against a board.</para>
/// </remarks>
public sealed record Net
{
    /// <summary>The name used in events and messages. Default "net".</summary>
    public string Name { get; init; } = "net";

    /// <summary>The centre of the rectangle, in m; components within ±1e6.</summary>
    public required Vector3d Center { get; init; }

    /// <summary>The normal of the plane; any length except 0.</summary>
    public required Vector3d Normal { get; init; }

    /// <summary>The direction of the first edge, perpendicular to the normal; any length except 0.</summary>
    public required Vector3d Along { get; init; }

    /// <summary>Half the size along <see cref="Along"/>, in m; above 0.</summary>
    public required double HalfLength { get; init; }

    /// <summary>Half the size along normal × along, in m; above 0.</summary>
    public required double HalfWidth { get; init; }

    /// <summary>The greatest depth δ of a ball, in m: how far the net gives way. 0.05 … 1e6; default 0.6, a guess (a goal net hangs 0.3 … 1 m loose).</summary>
    /// <remarks>With the default stiffness and damping, a ball of 0.43 kg reaches this depth above 250 m/s, and a ball of 3 kg above 39 m/s.</remarks>
    public double Give { get; init; } = 0.6;

    /// <summary>The stiffness k, in N/m. 0 … 1e5; default 400.</summary>
    public double Stiffness { get; init; } = 400;

    /// <summary>The damping b, in s/m: the ball leaves the net at no more than 1/b. 0 … 100; default 1.5.</summary>
    public double Damping { get; init; } = 1.5;

    /// <summary>The damping along the net, k_t, in N s/m². 0 … 1e4; default 60.</summary>
    public double TangentialDamping { get; init; } = 60;

    /// <summary>The damping of the spin, k_ω, in N s. 0 … 10; default 0.02.</summary>
    public double SpinDamping { get; init; } = 0.02;

    internal void Validate(string field)
    {
        _ = Name ?? throw Check.Refusal(field + ".name", "null", "a name");
        Check.Place(field + ".center", Center);

        // The normal and the along direction must be perpendicular, because their cross product gives the second edge.
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
