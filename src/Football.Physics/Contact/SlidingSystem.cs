namespace Football.Physics;

/// <summary>A ball that slides: F = −μ_s N ŝ, T = r μ_s N (ŷ × ŝ) − c_ω ω_y ŷ + T_D, and the horizontal part of the air's forces.</summary>
internal struct SlidingSystem<TAir> : IMotionSystem
    where TAir : struct, IAerodynamics
{
    public TAir Air;
    public CustomForces Custom;
    public GroundForces Ground;
    public Vector3d Wind;
    public bool AirActs;
    public DragBranch Branch;

    /// <summary>Direction of the slip at the step's start: what friction keeps to where a stage passes zero.</summary>
    public Vector3d SlipDirection;

    /// <summary>The spin at the step's start.</summary>
    public Vector3d StartSpin;

    /// <summary>Whether the air stops this ball's spin although friction turns it, and a stage has gone past that.</summary>
    public readonly bool StopsSpin(in Vector3d spin) => !Custom.Act && Decay > Ground.SlidingTorque && Vector3d.Dot(in spin, in StartSpin) < 0;

    /// <summary>Angular deceleration by the air at the last point, rad/s².</summary>
    public double Decay;

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        Vector3d slip = Slip.Of(at.Velocity, at.Spin, Ground.Radius);
        double size = slip.Length;
        Vector3d s = Vector3d.Dot(in slip, in SlipDirection) > 0 && size > 0 ? slip / size : SlipDirection;
        var torqueAxis = new Vector3d(s.Z, 0, -s.X); // ŷ × ŝ
        MotionRates pushed = Pushed(time, in at, in torqueAxis);
        Vector3d spinAcceleration = pushed.SpinAcceleration + (Ground.SlidingTorque * torqueAxis);
        if (!Custom.Act && at.Spin == Vector3d.Zero && Vector3d.Dot(in spinAcceleration, in torqueAxis) < 0)
        {
            // The air holds a ball that friction is too weak to turn, but it turns none.
            spinAcceleration = Vector3d.Zero;
        }

        rates = new MotionRates(pushed.Acceleration - (Ground.Sliding * s), in spinAcceleration);
    }

    /// <summary>All but the friction: the air, the damping of the spin about the vertical, the game's own forces.</summary>
    /// <param name="time">Time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="torqueAxis">Axis of the friction's torque: a ball without spin is about to turn about it.</param>
    public MotionRates Pushed(double time, in Motion at, in Vector3d torqueAxis)
    {
        Vector3d u = at.Velocity - Wind;
        MotionRates air = AirRates.Of(ref Air, in u, at.Spin, in torqueAxis, Branch);
        Vector3d acceleration = AirActs ? air.Acceleration : Vector3d.Zero;
        Vector3d turn = air.SpinAcceleration;
        Decay = turn.Length;
        if (StopsSpin(at.Spin))
        {
            // Past zero the decay goes on as before: at the step's end it stops there.
            turn = (-Decay / StartSpin.Length) * StartSpin;
        }

        Vector3d spinAcceleration = turn - new Vector3d(0, Ground.SpinDamping * at.Spin.Y, 0);
        if (Custom.Act)
        {
            MotionRates custom = Custom.Rates(time, in at, in u, MotionState.Sliding);
            acceleration += custom.Acceleration;
            spinAcceleration += custom.SpinAcceleration;
        }

        return new MotionRates(acceleration.Horizontal, in spinAcceleration);
    }
}
