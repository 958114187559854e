using System.Numerics;

namespace FootballPhysics.Yardsticks;

/// <summary>The derivatives of one Runge–Kutta stage: an object on the heap, as in the thesis.</summary>
public sealed class ThesisK
{
    public Vector3 V { get; set; }

    public Vector3 W { get; set; }

    public Vector3 P { get; set; }

    public Quaternion Q { get; set; }
}
