using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball that rolls: F = −μ_r N v̂ and the horizontal part of the air's forces; ω̇_h = ŷ × v̇ / r; about y −c_ω ω_y + T_D·ŷ.</summary>
internal struct RollingSystem<TAir> : IMotionSystem
    where TAir : struct, IAir
{
    public Surroundings<TAir> Around;
    public DragBranch Branch;

    /// <summary>Direction of motion at the step's start: what friction keeps to where a stage passes zero.</summary>
    public Vector3d Direction;

    /// <summary>Whether the ball stands on its spot and only spins about the vertical.</summary>
    public bool Pinned;

    public readonly void Rates(double time, in Motion at, out MotionRates rates)
    {
        Push(time, in at, out double ax, out double az, out double aboutVertical);
        if (Pinned)
        {
            rates = new MotionRates(Vector3d.Zero, new Vector3d(0, aboutVertical, 0));
            return;
        }

        double vx = at.Velocity.X;
        double vz = at.Velocity.Z;
        double dx = Direction.X;
        double dz = Direction.Z;
        double speedSquared = (vx * vx) + (vz * vz);
        if ((vx * dx) + (vz * dz) > 0 && speedSquared > 0)
        {
            double perSpeed = 1.0 / Math.Sqrt(speedSquared);
            dx = vx * perSpeed;
            dz = vz * perSpeed;
        }

        ref readonly GroundForces ground = ref Around.Ground;
        ax -= ground.Rolling * dx;
        az -= ground.Rolling * dz;
        rates = new MotionRates(new Vector3d(ax, 0, az), new Vector3d(az * ground.PerRadius, aboutVertical, -ax * ground.PerRadius));
    }

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        Vector3d spin = Slip.RollingSpin(in step.End.Velocity, step.End.Spin.Y, Around.Radius);
        GroundForces.Move(ref s, in step, in spin, Around.ContactHeight, Around.HasOwnForces);
    }

    /// <summary>What the air and the game's own forces do, and the damping of the spin about the vertical.</summary>
    public readonly MotionRates Pushed(double time, in Motion at)
    {
        Push(time, in at, out double ax, out double az, out double aboutVertical);
        return new MotionRates(new Vector3d(ax, 0, az), new Vector3d(0, aboutVertical, 0));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Push(double time, in Motion at, out double ax, out double az, out double aboutVertical)
    {
        Surroundings<TAir> around = Around;
        Vector3d u = at.Velocity - around.Wind;
        AirRates.Factors(ref around.Air, time, in at.Position, in u, in at.Spin, Branch, out AirFactors air);
        aboutVertical = -(air.Decay + around.Ground.SpinDamping) * at.Spin.Y;
        ax = 0;
        az = 0;
        if (around.AirActsOnGround)
        {
            // L (ω × u) − D u
            ax = (air.Lift * ((at.Spin.Y * u.Z) - (at.Spin.Z * u.Y))) - (air.Drag * u.X);
            az = (air.Lift * ((at.Spin.X * u.Y) - (at.Spin.Y * u.X))) - (air.Drag * u.Z);
            if (around.Air.Varies)
            {
                ax += air.Side.X;
                az += air.Side.Z;
            }
        }

        if (around.Custom.Act)
        {
            MotionRates custom = around.Custom.Rates(time, in at, in u, MotionState.Rolling);
            ax += custom.Acceleration.X;
            az += custom.Acceleration.Z;
            aboutVertical += custom.SpinAcceleration.Y;
        }
    }
}
