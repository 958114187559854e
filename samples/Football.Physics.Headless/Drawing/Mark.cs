namespace Football.Physics.Headless.Drawing;

/// <summary>The shape of a marked point.</summary>
internal enum Mark
{
    Dot,
    Ring,
    Square,
    Triangle,
    Diamond,
    Cross,
}
