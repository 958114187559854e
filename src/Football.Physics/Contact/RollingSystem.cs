namespace Football.Physics;

/// <summary>A ball that rolls: F = −μ_r N v̂ and the horizontal part of the air's forces; ω̇_h = ŷ × v̇ / r; about y −c_ω ω_y + T_D·ŷ.</summary>
internal struct RollingSystem<TAir> : IMotionSystem
    where TAir : struct, IAerodynamics
{
    public TAir Air;
    public CustomForces Custom;
    public GroundForces Ground;
    public Vector3d Wind;
    public bool AirActs;
    public DragBranch Branch;

    /// <summary>Direction of motion at the step's start: what friction keeps to where a stage passes zero.</summary>
    public Vector3d Direction;

    /// <summary>Whether the ball stands on its spot and only spins about the vertical.</summary>
    public bool Pinned;

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        MotionRates pushed = Pushed(time, in at);
        if (Pinned)
        {
            rates = new MotionRates(Vector3d.Zero, new Vector3d(0, pushed.SpinAcceleration.Y, 0));
            return;
        }

        Vector3d v = at.Velocity.Horizontal;
        double speed = v.Length;
        Vector3d direction = Vector3d.Dot(in v, in Direction) > 0 && speed > 0 ? v / speed : Direction;
        Vector3d a = pushed.Acceleration - (Ground.Rolling * direction);
        rates = new MotionRates(in a, Slip.RollingSpin(in a, pushed.SpinAcceleration.Y, Ground.Radius));
    }

    /// <summary>What the air and the game's own forces do, and the damping of the spin about the vertical.</summary>
    public MotionRates Pushed(double time, in Motion at)
    {
        Vector3d u = at.Velocity - Wind;
        MotionRates air = AirRates.Of(ref Air, in u, at.Spin, Vector3d.Zero, Branch);
        Vector3d acceleration = AirActs ? air.Acceleration : Vector3d.Zero;
        double aboutVertical = air.SpinAcceleration.Y - (Ground.SpinDamping * at.Spin.Y);
        if (Custom.Act)
        {
            MotionRates custom = Custom.Rates(time, in at, in u, MotionState.Rolling);
            acceleration += custom.Acceleration;
            aboutVertical += custom.SpinAcceleration.Y;
        }

        return new MotionRates(acceleration.Horizontal, new Vector3d(0, aboutVertical, 0));
    }
}
