namespace FootballPhysics.Drawing;

/// <summary>The shape of a marked point.</summary>
public enum Mark
{
    Dot,
    Ring,
    Square,
    Triangle,
    Diamond,
    Cross,
}
