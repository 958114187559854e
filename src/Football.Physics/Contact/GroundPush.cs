using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>What pushes a ball along the ground but friction: the air and the game's own forces; and what they and the damping do to its spin.</summary>
internal struct GroundPush
{
    /// <summary>Acceleration along x, m/s².</summary>
    public double X;

    /// <summary>Acceleration along z, m/s².</summary>
    public double Z;

    /// <summary>Angular acceleration about the vertical, rad/s².</summary>
    public double AboutVertical;

    /// <summary>|ω|, rad/s.</summary>
    public double SpinRate;

    /// <summary>Decay by the air, 1/s; without spin the angular deceleration itself, rad/s².</summary>
    public double Decay;

    /// <summary>Angular acceleration by torques that are not along the spin, rad/s².</summary>
    public Vector3d SpinAcceleration;

    /// <summary>The push at one instant.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void On<TAir>(
        Surroundings<TAir> around, DragBranch branch, MotionState motion, double time, in PlanarMotion at, out GroundPush push)
        where TAir : struct, IAir
    {
        if (around.Air.Varies)
        {
            OnVarying(around, branch, motion, time, in at, out push);
            return;
        }

        double ux = at.VX - around.Wind.X;
        double uy = 0 - around.Wind.Y;
        double uz = at.VZ - around.Wind.Z;
        push.SpinRate = AirRates.Factors(
            around.Air.Laws, ux, uy, uz, at.WX, at.WY, at.WZ, branch, out double drag, out double lift, out push.Decay);
        push.AboutVertical = -(push.Decay + around.Ground.SpinDamping) * at.WY;
        push.SpinAcceleration = Vector3d.Zero;
        push.X = 0;
        push.Z = 0;
        if ((around.Air.Drags || around.Air.Lifts) && around.AirActsOnGround)
        {
            // L (ω × u) − D u
            push.X = (lift * ((at.WY * uz) - (at.WZ * uy))) - (drag * ux);
            push.Z = (lift * ((at.WX * uy) - (at.WY * ux))) - (drag * uz);
        }
    }

    /// <summary>The same for air that varies, and for the game's own forces, whose vertical part is dropped as the air's is.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void OnVarying<TAir>(
        Surroundings<TAir> around, DragBranch branch, MotionState motion, double time, in PlanarMotion at, out GroundPush push)
        where TAir : struct, IAir
    {
        var u = new Vector3d(at.VX - around.Wind.X, 0 - around.Wind.Y, at.VZ - around.Wind.Z);
        var ball = new ForceInput(time, new Vector3d(at.X, around.ContactHeight, at.Z), at.Velocity, in u, at.Spin, motion);
        push.SpinRate = around.Air.Evaluate(in ball, branch, out AirFactors air);
        u = air.AirVelocity;
        push.Decay = air.Decay;
        push.AboutVertical = (-(air.Decay + around.Ground.SpinDamping) * at.WY) + air.SpinAcceleration.Y;
        push.SpinAcceleration = air.SpinAcceleration;
        push.X = 0;
        push.Z = 0;
        if (around.AirActsOnGround)
        {
            push.X = (air.Lift * ((at.WY * u.Z) - (at.WZ * u.Y))) - (air.Drag * u.X);
            push.Z = (air.Lift * ((at.WX * u.Y) - (at.WY * u.X))) - (air.Drag * u.Z);
        }

        push.X += air.Acceleration.X;
        push.Z += air.Acceleration.Z;
    }
}
