using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball that slides: F = −μ_s N ŝ, T = r μ_s N (ŷ × ŝ) − c_ω ω_y ŷ + T_D, and the horizontal part of the air's forces.</summary>
internal struct SlidingSystem<TAir> : IMotionSystem
    where TAir : struct, IAir
{
    public Surroundings<TAir> Around;
    public DragBranch Branch;

    /// <summary>Direction of the slip at the step's start: what friction keeps to where a stage passes zero.</summary>
    public Vector3d SlipDirection;

    /// <summary>The spin at the step's start.</summary>
    public Vector3d StartSpin;

    /// <summary>Whether the air stops this ball's spin although friction turns it, and a stage has gone past that.</summary>
    public readonly bool StopsSpin(in Vector3d spin) => !Around.Custom.Act && Decay > Around.Ground.SlidingTorque && Vector3d.Dot(in spin, in StartSpin) < 0;

    /// <summary>Angular deceleration by the air at the last point, rad/s².</summary>
    public double Decay;

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        ref readonly GroundForces ground = ref Around.Ground;
        Vector3d slip = Slip.Of(at.Velocity, at.Spin, ground.Radius);
        double size = slip.Length;
        Vector3d s = Vector3d.Dot(in slip, in SlipDirection) > 0 && size > 0 ? (1.0 / size) * slip : SlipDirection;
        var torqueAxis = new Vector3d(s.Z, 0, -s.X); // ŷ × ŝ
        Push(time, in at, in torqueAxis, out Vector3d acceleration, out Vector3d spinAcceleration);
        spinAcceleration += ground.SlidingTorque * torqueAxis;
        if (!Around.Custom.Act && at.Spin == Vector3d.Zero && Vector3d.Dot(in spinAcceleration, in torqueAxis) < 0)
        {
            // The air holds a ball that friction is too weak to turn, but it turns none.
            spinAcceleration = Vector3d.Zero;
        }

        rates = new MotionRates(acceleration - (ground.Sliding * s), in spinAcceleration);
    }

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        // Where friction does not turn the ball, or too weakly, its spin ends at zero.
        Vector3d spin = StopsSpin(in step.End.Spin) ? Vector3d.Zero : step.End.Spin;
        GroundForces.Move(ref s, in step, in spin, Around.ContactHeight, Around.HasOwnForces);
    }

    /// <summary>All but the friction: the air, the damping of the spin about the vertical, the game's own forces.</summary>
    /// <param name="time">Time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="torqueAxis">Axis of the friction's torque: a ball without spin is about to turn about it.</param>
    public MotionRates Pushed(double time, in Motion at, in Vector3d torqueAxis)
    {
        Push(time, in at, in torqueAxis, out Vector3d acceleration, out Vector3d spinAcceleration);
        return new MotionRates(in acceleration, in spinAcceleration);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Push(double time, in Motion at, in Vector3d torqueAxis, out Vector3d acceleration, out Vector3d spinAcceleration)
    {
        Surroundings<TAir> around = Around;
        Vector3d u = at.Velocity - around.Wind;
        Vector3d spin = at.Spin;
        double rate = AirRates.Factors(ref around.Air, time, in at.Position, in u, in spin, Branch, out AirFactors air);
        Decay = rate > 0 ? air.Decay * rate : air.Decay;
        spinAcceleration = rate > 0 ? -air.Decay * spin : -air.Decay * torqueAxis;
        if (StopsSpin(in spin))
        {
            // Past zero the decay goes on as before: at the step's end it stops there.
            spinAcceleration = (-Decay / StartSpin.Length) * StartSpin;
        }

        spinAcceleration -= new Vector3d(0, around.Ground.SpinDamping * spin.Y, 0);
        acceleration = Vector3d.Zero;
        if (around.AirActsOnGround)
        {
            // L (ω × u) − D u
            acceleration = new Vector3d(
                (air.Lift * ((spin.Y * u.Z) - (spin.Z * u.Y))) - (air.Drag * u.X), 0, (air.Lift * ((spin.X * u.Y) - (spin.Y * u.X))) - (air.Drag * u.Z));
            if (around.Air.Varies)
            {
                acceleration += air.Side.Horizontal;
            }
        }

        if (around.Custom.Act)
        {
            MotionRates custom = around.Custom.Rates(time, in at, in u, MotionState.Sliding);
            acceleration += custom.Acceleration.Horizontal;
            spinAcceleration += custom.SpinAcceleration;
        }
    }
}
