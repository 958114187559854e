using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball that rolls: F = −μ_r N v̂ and the horizontal part of the air's forces; ω̇_h = ŷ × v̇ / r; about y −c_ω ω_y + T_D·ŷ.</summary>
internal struct RollingSystem<TAir> : IPlanarSystem
    where TAir : struct, IAir
{
    public Surroundings<TAir> Around;
    public DragBranch Branch;

    /// <summary>Direction of motion at the step's start, x: what friction keeps to where a stage passes zero.</summary>
    public double DirectionX;

    /// <summary>The same, z.</summary>
    public double DirectionZ;

    /// <summary>Whether the ball stands on its spot and only spins about the vertical.</summary>
    public bool Pinned;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Rates(double time, in PlanarMotion at, out PlanarRates rates)
    {
        GroundPush.On(Around, Branch, MotionState.Rolling, time, in at, out GroundPush push);
        rates.BY = push.AboutVertical;
        if (Pinned)
        {
            rates.AX = 0;
            rates.AZ = 0;
            rates.BX = 0;
            rates.BZ = 0;
            return;
        }

        double dx = DirectionX;
        double dz = DirectionZ;
        double speedSquared = at.SpeedSquared;
        if ((at.VX * dx) + (at.VZ * dz) > 0 && speedSquared > 0)
        {
            double perSpeed = 1.0 / Math.Sqrt(speedSquared);
            dx = at.VX * perSpeed;
            dz = at.VZ * perSpeed;
        }

        ref readonly GroundForces ground = ref Around.Ground;
        double ax = push.X - (ground.Rolling * dx);
        double az = push.Z - (ground.Rolling * dz);
        rates.AX = ax;
        rates.AZ = az;
        rates.BX = az * ground.PerRadius;
        rates.BZ = -ax * ground.PerRadius;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Move(ref BallState s, in PlanarStep step)
    {
        // ω_h = ŷ × v / r
        var spin = new Vector3d(step.End.VZ / Around.Radius, step.End.WY, -step.End.VX / Around.Radius);
        GroundForces.Move(ref s, in step, in spin, Around.Air.Varies);
    }
}
