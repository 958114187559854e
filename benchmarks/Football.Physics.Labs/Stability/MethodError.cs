namespace FootballPhysics.Labs.Stability;

/// <summary>Bounds the energy that a method creates in one piece of motion through still air: its own error only.</summary>
/// <remarks>
/// <para>
/// The energy of a ball in the air, E/m = ½ v² + g y, is quadratic, so a Runge–Kutta method with weights b and coefficients a changes it by exactly
/// </para>
/// <para>
/// ΔE/m = h Σ bᵢ Vᵢ·Aᵢ − ½ h² Σ mᵢⱼ aᵢ·aⱼ,   mᵢⱼ = bᵢ aᵢⱼ + bⱼ aⱼᵢ − bᵢ bⱼ,   aᵢ = −g ŷ + Aᵢ,
/// </para>
/// <para>
/// with the velocities Vᵢ of the stages and the air's accelerations Aᵢ there. Drag takes energy and the Magnus force does no work: the first sum is
/// never positive. The second sum bounds the energy that the method may create. With d = A₂ − A₁ it is for each method:
/// </para>
/// <para>Euler: ½ h² a₁².</para>
/// <para>Semi-implicit Euler, whose height moves with the new velocity: ½ h² (A₁² − g²).</para>
/// <para>Midpoint: ½ h² a₂·d = ½ h² (a₁·d + d²).</para>
/// <para>Classical Runge–Kutta, with q = A₃ − A₂ and e = A₄ − 2 A₃ + A₁: ½ h² (−d·q/3 − (2q² + q·e − e²/4)/9) ≤ ½ h² (−d·q/3 + e²/24).</para>
/// <para>
/// The differences d, q and e are J = ∂A/∂u times the differences of the stages' velocities, which are h times accelerations. In a product x·(J x) only
/// the part of J that stretches counts. On the ground g does not act, and friction takes more energy than it can create: a piece is too short to stop the slip.
/// </para>
/// </remarks>
internal sealed class MethodError(Integrator method, Scene scene)
{
    private readonly AirBounds _air = new(scene);

    /// <summary>Returns the maximum of ΔE/m, J/kg.</summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="g">Acceleration other than the air's, m/s².</param>
    /// <param name="speed">Air speed at its start, m/s.</param>
    /// <param name="slowSurface">Lowest s = r|ω| at its start, m/s.</param>
    /// <param name="fastSurface">Highest s at its start, m/s.</param>
    /// <param name="damping">Other damping of the spin, 1/s.</param>
    public double Of(double h, double g, double speed, double slowSurface, double fastSurface, double damping)
    {
        // |a₁| ≤ g + |A₁|, and so on from stage to stage.
        double atStart = _air.Size(speed, fastSurface);
        double a = g + atStart;
        if (!(h > 0 && a > 0))
        {
            return 0;
        }

        double second = speed + (0.5 * h * a);
        switch (method)
        {
            case Integrator.Euler:
                return 0.5 * h * h * a * a;
            case Integrator.SemiImplicitEuler:
                return 0.5 * h * h * Math.Max(0, (atStart * atStart) - (g * g));
            case Integrator.Rk2:
                Changes(h, speed, second, slowSurface, fastSurface, damping, out AirBound air, out double loss, out _);

                // d = ½ h J a₁, plus the change of the lift by half the loss of spin
                double byLoss = 0.5 * loss * air.BySpin;
                double d = (0.5 * h * air.Slope * a) + byLoss;
                return 0.5 * h * h * ((0.5 * h * air.Stretch * a * a) + (a * byLoss) + (d * d));
            case Integrator.Rk4:
                return Classical(h, g, a, speed, second, slowSurface, fastSurface, damping);
            default:
                throw new ArgumentOutOfRangeException(nameof(h));
        }
    }

    /// <summary>Returns the maximum of ΔE/m, J/kg, for the correction at the end of a piece that an event ends: up to t with the acceleration extrapolated from its start.</summary>
    /// <param name="t">Longest correction, s.</param>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="g">Acceleration other than the air's, m/s².</param>
    /// <param name="speed">Air speed at its start, m/s.</param>
    /// <param name="slowSurface">Lowest s = r|ω| at its start, m/s.</param>
    /// <param name="fastSurface">Highest s at its start, m/s.</param>
    public double OfCorrection(double t, double h, double g, double speed, double slowSurface, double fastSurface)
    {
        if (method is Integrator.Euler or Integrator.SemiImplicitEuler || !(h > 0))
        {
            // These methods have a constant acceleration within the piece.
            return 0;
        }

        // 2 (v₁ − v₀)/h − a₀ is off by h² a″/6 plus the error of the method. With a″ = J² a and more, that is less than half of h² ‖J‖² |a|.
        double a = g + _air.Size(speed, fastSurface);
        double fastest = speed + (h * a);
        Changes(h, speed, fastest, slowSurface, fastSurface, 0, out AirBound air, out double loss, out _);
        double change = Math.Min(1, h * air.Slope) * ((h * air.Slope * a) + (loss * air.BySpin));
        return 0.5 * change * fastest * t;
    }

    /// <summary>Returns the most that the air takes from s = r|ω| in a piece, m/s.</summary>
    /// <param name="h">Length of the piece, s.</param>
    /// <param name="fast">Highest air speed, m/s.</param>
    /// <param name="surface">Highest s, m/s.</param>
    public double SpinLoss(double h, double fast, double surface) => h > 0 && surface > 0 ? h * surface * _air.SpinDecay(fast, surface, surface) : 0;

    private double Classical(double h, double g, double a, double speed, double second, double slowSurface, double fastSurface, double damping)
    {
        double third = speed + (0.5 * h * (g + _air.Size(second, fastSurface)));
        double most = Math.Max(a, g + _air.Size(Math.Max(second, third), fastSurface));
        double fastest = Math.Max(Math.Max(second, third), speed + (h * (g + _air.Size(third, fastSurface))));
        Changes(h, speed, fastest, slowSurface, fastSurface, damping, out AirBound air, out double loss, out double unevenness);
        double z = h * air.Slope;

        // d = ½ h J a₁, q = ½ h J d, both plus the contribution of the loss of spin
        double d = 0.5 * ((z * a) + (loss * air.BySpin));
        double byLoss = 0.5 * loss * unevenness * air.BySpin;
        double q = (0.5 * z * d) + byLoss;

        // e = h J (a₃ − a₂) + half the curvature times (h a₃)² + 2 (½ h a₂)², or the sum of both differences at most
        double uneven = air.BySpin * loss * (unevenness + loss + z);
        double e = Math.Min((z * q) + (0.75 * air.Curvature * h * h * most * most), 2 * z * most) + uneven;
        return 0.5 * h * h * ((((0.5 * h * air.Stretch * d * d) + (d * byLoss)) / 3) + (e * e / 24));
    }

    /// <summary>Computes the bounds of the air between the start speed and the fastest stage, the lost share of the spin, and the relative change of that loss.</summary>
    private void Changes(
        double h, double speed, double fastest, double slowSurface, double fastSurface, double damping, out AirBound air, out double loss, out double unevenness)
    {
        double fall = fastest - speed;
        double slowest = Math.Max(0, speed - fall);
        air = _air.Over(slowest, fastest, slowSurface, fastSurface);
        loss = Math.Min(1, h * (_air.SpinDecay(fastest, slowSurface, fastSurface) + damping));

        // U^1.8 changes by 1.8 times the relative change of U
        unevenness = _air.SpinDecaysEvenly ? loss : Math.Min(1, loss + (fall / Math.Max(slowest, 0.5 * slowSurface)));
    }
}
