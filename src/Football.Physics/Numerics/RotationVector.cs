namespace Football.Physics;

/// <summary>The rotation that a turning spin makes over a step.</summary>
internal static class RotationVector
{
    /// <summary>Solves q̇ = ½ ω ⊗ q over a step by the Magnus expansion of order 6 (Blanes et al.), with [a, b] = a × b.</summary>
    /// <param name="start">Spin at the start, rad/s.</param>
    /// <param name="middle">Spin half-way.</param>
    /// <param name="end">Spin at the end.</param>
    /// <param name="h">Length of the step, s.</param>
    public static Vector3d Of(in Vector3d start, in Vector3d middle, in Vector3d end, double h)
    {
        // α₁ = h ω, α₂ = h² ω̇, α₃ = h³ ω̈/2 at the middle
        Vector3d a1 = h * middle;
        Vector3d a2 = h * (end - start);
        Vector3d a3 = (2.0 * h) * ((start - middle) + (end - middle));

        // Ω = α₁ + α₃/12 + [−20 α₁ − α₃ + C₁, α₂ + C₂]/240,  C₁ = [α₁, α₂],  C₂ = −[α₁, 2 α₃ + C₁]/60
        Vector3d c1 = Vector3d.Cross(in a1, in a2);
        Vector3d c2 = (-1.0 / 60.0) * Vector3d.Cross(in a1, (2.0 * a3) + c1);
        return a1 + ((1.0 / 12.0) * a3) + ((1.0 / 240.0) * Vector3d.Cross((-20.0 * a1) - a3 + c1, a2 + c2));
    }

    /// <summary>One rotation after the other, both small: Baker, Campbell and Hausdorff's series to the third order.</summary>
    /// <param name="first">The first, rad.</param>
    /// <param name="second">The one after it, rad.</param>
    public static Vector3d Then(in Vector3d first, in Vector3d second)
    {
        // a + b + [b, a]/2 + [b − a, [b, a]]/12
        Vector3d c = Vector3d.Cross(in second, in first);
        return first + second + (0.5 * c) + ((1.0 / 12.0) * Vector3d.Cross(second - first, c));
    }
}
