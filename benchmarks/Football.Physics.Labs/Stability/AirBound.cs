namespace FootballPhysics.Labs.Stability;

/// <summary>Upper bounds of the air's acceleration A(u, ω) of a ball, and of its derivatives, over a range of speeds and spins. J is ∂A/∂u.</summary>
/// <param name="Size">|A|, m/s².</param>
/// <param name="Slope">‖J‖, 1/s.</param>
/// <param name="Stretch">The symmetric part of J, 1/s: it makes a velocity longer or shorter. It is 0 for a force that only turns the velocity.</param>
/// <param name="Curvature">‖∂²A/∂u²‖, 1/m.</param>
/// <param name="BySpin">|∂A/∂ ln ω|, m/s².</param>
internal readonly record struct AirBound(double Size, double Slope, double Stretch, double Curvature, double BySpin)
{
    public static AirBound operator +(in AirBound a, in AirBound b) =>
        new(a.Size + b.Size, a.Slope + b.Slope, a.Stretch + b.Stretch, a.Curvature + b.Curvature, a.BySpin + b.BySpin);

    public static AirBound operator *(double k, in AirBound a) => new(k * a.Size, k * a.Slope, k * a.Stretch, k * a.Curvature, k * a.BySpin);
}
