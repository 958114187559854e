using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>A law that is nobody's: what the tables are made of must be this law's own functions.</summary>
internal struct InventedLaw : ITableLaw
{
    private double _k;

    public readonly bool NeedsSpinAcross => false;

    public readonly bool Jumps => false;

    public readonly double SpeedScale => 0.5;

    public readonly LawTables Tables => new(this, new Octaves(-14, 14, 6), new Octaves(0, 8, 7));

    public void Prepare(Scene scene) => _k = AirScale.DynamicArea(scene);

    public readonly void OfSpeed(double speed, out LawFactors factors)
    {
        factors.First = 0.3 + (0.2 / (1 + (0.01 * speed * speed)));
        factors.Second = Math.Sqrt(speed);
        factors.Third = 1 / (1 + speed);
        factors.Fourth = speed / (10 + speed);
    }

    public readonly void OfSpin(double spinParameter, out LawFactors factors)
    {
        factors.First = spinParameter * spinParameter;
        factors.Second = spinParameter / (1 + spinParameter);
        factors.Third = 1 / (1 + (spinParameter * spinParameter));
        factors.Fourth = 1 + spinParameter;
    }

    public readonly void Combine(
        DragBranch region, in LawFactors bySpeed, in LawFactors bySpin, double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        drag = _k * speed * (bySpeed.First + (bySpeed.Fourth * bySpin.First));
        lift = _k * speed * (bySpeed.Second * bySpin.Second);
        decay = spinRate * ((bySpeed.Third * bySpin.Third) + bySpin.Fourth);
    }
}
