namespace Football.Physics;

/// <summary>Binomial coefficients of the powers in the published laws: of the spin, which hardly changes within a step, and of |u|².</summary>
internal static class PublishedBinomials
{
    public const double DragSecond = FittedDrag.D * (FittedDrag.D - 1) / 2;
    public const double DragThird = DragSecond * (FittedDrag.D - 2) / 3;
    public const double LiftSecond = EmpiricalMagnus.Beta * (EmpiricalMagnus.Beta - 1) / 2;
    public const double LiftThird = LiftSecond * (EmpiricalMagnus.Beta - 2) / 3;

    // Binomial coefficients of the powers of |u|².
    public const double OfDrag1 = 0.5 * (1 - FittedDrag.D);
    public const double OfDrag2 = OfDrag1 * (OfDrag1 - 1) / 2;
    public const double OfDrag3 = OfDrag2 * (OfDrag1 - 2) / 3;
    public const double OfDrag4 = OfDrag3 * (OfDrag1 - 3) / 4;
    public const double OfLift1 = 0.5 * (1 - EmpiricalMagnus.Beta);
    public const double OfLift2 = OfLift1 * (OfLift1 - 1) / 2;
    public const double OfLift3 = OfLift2 * (OfLift1 - 2) / 3;
    public const double OfLift4 = OfLift3 * (OfLift1 - 3) / 4;
    public const double OfLiftByDrag1 = 0.5 * (1 - EmpiricalMagnus.Beta - FittedDrag.D);
    public const double OfLiftByDrag2 = OfLiftByDrag1 * (OfLiftByDrag1 - 1) / 2;
    public const double OfLiftByDrag3 = OfLiftByDrag2 * (OfLiftByDrag1 - 2) / 3;
    public const double OfLiftByDrag4 = OfLiftByDrag3 * (OfLiftByDrag1 - 3) / 4;
    public const double OfDecay1 = 0.5 * (double)EmpiricalSpinDecay.SpeedExponent;
    public const double OfDecay2 = OfDecay1 * (OfDecay1 - 1) / 2;
    public const double OfDecay3 = OfDecay2 * (OfDecay1 - 2) / 3;
}
