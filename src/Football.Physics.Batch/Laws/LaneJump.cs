using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>The jump in the published drag law (<see cref="DragJump"/>), in float.</summary>
/// <remarks>The branch with spin holds where both |u|² − v_c² and (r|ω|/0.05)² − |u|² are positive.</remarks>
internal readonly struct LaneJump
{
    /// <summary>v_c², m²/s².</summary>
    public const float SpeedSquared = (float)(FittedDrag.CriticalSpeed * FittedDrag.CriticalSpeed);

    /// <summary>(r/0.05)², m².</summary>
    public readonly float PerSpinSquared;

    /// <summary>The acceleration by gravity and buoyancy, in m/s²: it bends |u|² along a step.</summary>
    public readonly float Gravity;

    public LaneJump(Scene scene)
    {
        Gravity = (float)Math.Abs(Weight.UpwardAcceleration(scene));
        double r = scene.Ball.Radius;
        PerSpinSquared = (float)(r * r / (FittedDrag.CriticalSpin * FittedDrag.CriticalSpin));
    }
}
