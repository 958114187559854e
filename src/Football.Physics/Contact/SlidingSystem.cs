using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball that slides: F = −μ_s N ŝ, T = r μ_s N (ŷ × ŝ) − c_ω ω_y ŷ + T_D, and the horizontal part of the air's forces.</summary>
internal struct SlidingSystem<TAir> : IPlanarSystem
    where TAir : struct, IAir
{
    public Surroundings<TAir> Around;
    public DragBranch Branch;

    /// <summary>Direction of the slip at the step's start, x: what friction keeps to where a stage passes zero.</summary>
    public double SlipX;

    /// <summary>The same, z.</summary>
    public double SlipZ;

    /// <summary>The spin at the step's start, rad/s.</summary>
    public Vector3d StartSpin;

    /// <summary>Angular deceleration by the air at the last point, rad/s².</summary>
    private double _decay;

    /// <summary>Whether the ball had a spin, as the air sees it, where the rates were taken last.</summary>
    private bool _spins;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Rates(double time, in PlanarMotion at, out PlanarRates rates)
    {
        // s = v + r ŷ × ω
        ref readonly GroundForces ground = ref Around.Ground;
        double sx = at.VX + (ground.Radius * at.WZ);
        double sz = at.VZ - (ground.Radius * at.WX);
        double size = Math.Sqrt((sx * sx) + (sz * sz));
        double perSize = 1.0 / size;
        bool slips = (sx * SlipX) + (sz * SlipZ) > 0 && size > 0;
        sx = slips ? perSize * sx : SlipX;
        sz = slips ? perSize * sz : SlipZ;

        // ŷ × ŝ = (s_z, 0, −s_x)
        Pushed(time, in at, sz, -sx, out rates);
        rates.AX -= ground.Sliding * sx;
        rates.AZ -= ground.Sliding * sz;
        rates.BX += ground.SlidingTorque * sz;
        rates.BZ += ground.SlidingTorque * -sx;
        if (!_spins && !Around.Air.Varies && (rates.BX * sz) + (rates.BZ * -sx) < 0)
        {
            // The air holds a ball that friction is too weak to turn, but it turns none.
            rates.BX = 0;
            rates.BY = 0;
            rates.BZ = 0;
        }
    }

    /// <summary>All but the friction: the air, the damping of the spin about the vertical, the game's own forces.</summary>
    /// <param name="time">Time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="torqueX">Axis of the friction's torque, x: a ball without spin is about to turn about it.</param>
    /// <param name="torqueZ">The same, z.</param>
    /// <param name="rates">What they do.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Pushed(double time, in PlanarMotion at, double torqueX, double torqueZ, out PlanarRates rates)
    {
        GroundPush.On(Around, Branch, MotionState.Sliding, time, in at, out GroundPush push);
        bool spins = push.SpinRate > 0;
        _spins = spins;
        _decay = spins ? push.Decay * push.SpinRate : push.Decay;
        rates.AX = push.X;
        rates.AZ = push.Z;
        rates.BX = -push.Decay * (spins ? at.WX : torqueX);
        rates.BY = spins ? -push.Decay * at.WY : 0;
        rates.BZ = -push.Decay * (spins ? at.WZ : torqueZ);
        if (StopsSpin(at.WX, at.WY, at.WZ))
        {
            // Past zero the decay goes on as before, so that the step's end shows it, but there is no spin to lift the ball.
            double start = StartSpin.Length;
            double perSpin = start > AirRates.NoSpin ? -_decay / start : 0;
            rates.BX = perSpin * StartSpin.X;
            rates.BY = perSpin * StartSpin.Y;
            rates.BZ = perSpin * StartSpin.Z;
            WithoutSpin(time, in at, out rates.AX, out rates.AZ);
        }

        rates.BY -= Around.Ground.SpinDamping * at.WY;
        if (Around.Air.Varies)
        {
            rates.BX += push.SpinAcceleration.X;
            rates.BY += push.SpinAcceleration.Y;
            rates.BZ += push.SpinAcceleration.Z;
        }
    }

    /// <summary>The push on a ball whose spin has ended: drag, and no lift.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly void WithoutSpin(double time, in PlanarMotion at, out double ax, out double az)
    {
        PlanarMotion still = at;
        still.WX = 0;
        still.WY = 0;
        still.WZ = 0;
        GroundPush.On(Around, Branch, MotionState.Sliding, time, in still, out GroundPush push);
        ax = push.X;
        az = push.Z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Move(ref BallState s, in PlanarStep step)
    {
        var end = new Vector3d(step.End.WX, step.End.WY, step.End.WZ);

        // Where friction does not turn the ball, or too weakly, its spin ends at zero. One that is then faster at the end has ended on the way, where a stage found it next to zero and pointing anywhere.
        bool stops = StopsSpin(end.X, end.Y, end.Z) || (AirEndsSpin && end.LengthSquared > StartSpin.LengthSquared);
        Vector3d spin = stops ? Vector3d.Zero : end;
        GroundForces.Move(ref s, in step, in spin, Around.Air.Varies);
    }

    /// <summary>Whether the air takes more of the spin than friction can add: it can only get slower.</summary>
    private readonly bool AirEndsSpin
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _decay > Around.Ground.SlidingTorque && !Around.Air.Varies;
    }

    /// <summary>Whether the air stops this ball's spin although friction turns it, and a stage has gone past that.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly bool StopsSpin(double wx, double wy, double wz) =>
        AirEndsSpin && (wx * StartSpin.X) + (wy * StartSpin.Y) + (wz * StartSpin.Z) < 0;
}
