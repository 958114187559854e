using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>The equations of sliding and rolling on a plane, in its axes: the form of <see cref="SurfaceSystem"/> for flat ground.</summary>
/// <remarks>
/// Symbols: a_b gravity and buoyancy, a_air the acceleration by the air, T its torque per moment of inertia, N the load per mass.
/// Sliding: a = a_b + a_air − μ_s N ŝ, ω̇ = (μ_s N/(α r)) n × ŝ + T.
/// Rolling: a = (a_b + a_air + α r T × n)/(1 + α) − (c₀ + c₁|v|) N v̂ if the spin shares the air's force; otherwise a_b/(1 + α) + a_air − ….
/// About the normal: −(c_ω/I) ω_n − sign(ω_n) b μ_s N m/I.
/// </remarks>
/// <typeparam name="TAir">The laws of the air.</typeparam>
internal sealed class PlaneLaw<TAir>
    where TAir : struct, IFlightAir
{
    /// <summary>The axes of the plane.</summary>
    public readonly PlaneAxes Axes;

    /// <summary>The wind along these axes, m/s.</summary>
    public readonly double WindX;
    public readonly double WindUp;
    public readonly double WindZ;

    /// <summary>−a_b·n, m/s²: the load by the weight.</summary>
    public readonly double Weight;

    /// <summary>True if the air depends on the position.</summary>
    public readonly bool HasField;
    private TAir _air;
    private readonly bool _jumps;
    private readonly double _bodyX;
    private readonly double _bodyZ;
    private readonly double _radius;
    private readonly double _perRadius;
    private readonly double _radiusSquared;
    private readonly double _airInLoad;
    private readonly double _airInSlide;
    private readonly double _bodyXInRoll;
    private readonly double _bodyZInRoll;
    private readonly double _airInRoll;
    private readonly double _decayInRoll;
    private readonly double _bodyXInTraction;
    private readonly double _bodyZInTraction;
    private readonly double _airInTraction;

    public PlaneLaw(Scene scene, Surroundings around, in TAir air)
    {
        _air = air;
        HasField = air.HasField;
        _jumps = around.Air.Laws.Jumps;
        Axes = new PlaneAxes(scene.Ground);
        Vector3d wind = around.Wind;
        WindX = Vector3d.Dot(in wind, in Axes.X);
        WindUp = Vector3d.Dot(in wind, in Axes.Normal);
        WindZ = Vector3d.Dot(in wind, in Axes.Z);
        Vector3d body = around.Weight;
        _bodyX = Vector3d.Dot(in body, in Axes.X);
        _bodyZ = Vector3d.Dot(in body, in Axes.Z);
        Weight = -Vector3d.Dot(in body, in Axes.Normal);

        // Constants of the equations in the remarks: the shares of weight and air in the load, in a slide, in a roll and in its traction.
        World world = around.World;
        double alpha = scene.Ball.InertiaFactor;
        _radius = scene.Ball.Radius;
        _perRadius = 1.0 / _radius;
        _radiusSquared = _radius * _radius;
        _airInLoad = world.AirLoads && world.AirActs ? 1 : 0;
        _airInSlide = world.AirActs ? 1 : 0;
        _bodyXInRoll = _bodyX / (1.0 + alpha);
        _bodyZInRoll = _bodyZ / (1.0 + alpha);
        _airInRoll = world.SharesAir ? 1.0 / (1.0 + alpha) : _airInSlide;
        _decayInRoll = world.SharesAir ? alpha / (1.0 + alpha) : 0;
        _bodyXInTraction = alpha * _bodyXInRoll;
        _bodyZInTraction = alpha * _bodyZInRoll;
        _airInTraction = _decayInRoll;
    }

    /// <summary>Computes the rates of change at one instant: the laws of the air, then the forces that follow from them.</summary>
    /// <remarks>
    /// The laws of the air have a long latency, so everything else is summed meanwhile: a = A + lift B − drag C − decay D.
    /// B and C contain the air's share in the load, and so in friction.
    /// </remarks>
    /// <returns>The acceleration along the plane, m/s².</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public PlaneAcceleration RatesOf<TMotion>(
        in PlaneStart on, in PlaneMaterial material, double vx, double vz, double wx, double wy, double wz, double after, double wayX, double wayZ, out PlaneRates rates)
        where TMotion : struct, ISurfaceMotion
    {
        // The velocity u relative to the air, and ω × u, the direction of the Magnus force for the spin ω.
        double ux = vx - WindX;
        double uy = -WindUp;
        double uz = vz - WindZ;

        // Only the wind varies here: custom forces are excluded, and the knuckle force acts only in flight.
        double spinSquared = (wx * wx) + (wy * wy) + (wz * wz);
        DragBranch branch = _air.HasField ? AddWind(in on, spinSquared, after, wayX, wayZ, ref ux, ref uy, ref uz) : on.Branch;
        double speedSquared = (ux * ux) + (uy * uy) + (uz * uz);
        double crossX = (wy * uz) - (wz * uy);
        double crossUp = (wz * ux) - (wx * uz);
        double crossZ = (wx * uy) - (wy * ux);
        bool spins = _air.FactorsPerSpin(
            speedSquared, spinSquared, (crossX * crossX) + (crossUp * crossUp) + (crossZ * crossZ), branch, out double drag, out double lift, out double decay);

        // The air gives a_air = L (ω × u) − D u, with the factors L of lift and D of drag. The load is N/m = −a_b·n, minus a_air·n if the air adds to it.
        double upByLift = _airInLoad * crossUp;
        double upByDrag = _airInLoad * uy;
        double load = Weight - ((lift * upByLift) - (drag * upByDrag));
        double slowing = spins ? decay : 0;
        rates.Load = load;
        rates.BY = -(((material.Damping + slowing) * wy) + (on.SpinSign * material.Drilling * load));
        if (default(TMotion).Rolls)
        {
            double squared = (vx * vx) + (vz * vz);
            double speed = Math.Sqrt(squared);
            bool goesOn = (vx * on.X) + (vz * on.Z) > 0;
            double perSpeed = speed * (1.0 / squared); // the division does not wait for the root
            double friction = material.Rolling + (material.RollingBySpeed * speed);
            double fx = friction * (goesOn ? vx * perSpeed : on.X);
            double fz = friction * (goesOn ? vz * perSpeed : on.Z);

            // The air's torque T = −decay ω accelerates a rolling ball by r T × n, which equals −decay v.
            double ax = (_bodyXInRoll - (Weight * fx)) + (lift * ((_airInRoll * crossX) + (upByLift * fx)))
                - ((drag * ((_airInRoll * ux) + (upByDrag * fx))) + (decay * (_decayInRoll * vx)));
            double az = (_bodyZInRoll - (Weight * fz)) + (lift * ((_airInRoll * crossZ) + (upByLift * fz)))
                - ((drag * ((_airInRoll * uz) + (upByDrag * fz))) + (decay * (_decayInRoll * vz)));
            rates.BX = az * _perRadius;
            rates.BZ = -ax * _perRadius;
            double tractionX = _bodyXInTraction + (_airInTraction * ((lift * crossX) - (drag * ux) + (decay * vx)));
            double tractionZ = _bodyZInTraction + (_airInTraction * ((lift * crossZ) - (drag * uz) + (decay * vz)));
            rates.TractionSquared = (tractionX * tractionX) + (tractionZ * tractionZ);
            rates.BrakingSquared = 0;
            return new PlaneAcceleration(ax, az);
        }
        else
        {
            double sx = vx + (_radius * wz);
            double sz = vz - (_radius * wx);
            double squared = (sx * sx) + (sz * sz);
            double perSize = Math.Sqrt(squared) * (1.0 / squared); // the division does not wait for the root
            bool slips = (sx * on.X) + (sz * on.Z) > 0;
            sx = slips ? perSize * sx : on.X;
            sz = slips ? perSize * sz : on.Z;
            double fx = material.Sliding * sx;
            double fz = material.Sliding * sz;
            double ax = (_bodyX - (Weight * fx)) + ((lift * ((_airInSlide * crossX) + (upByLift * fx))) - (drag * ((_airInSlide * ux) + (upByDrag * fx))));
            double az = (_bodyZ - (Weight * fz)) + ((lift * ((_airInSlide * crossZ) + (upByLift * fz))) - (drag * ((_airInSlide * uz) + (upByDrag * fz))));

            // Friction turns the ball about n × ŝ, across the direction ŝ of the slip. If the ball has no spin, the air's torque reduces the torque
            // of friction, but never reverses it.
            double turning = material.SlidingTorque * load;
            turning = spins ? turning : Math.Max(0, turning - decay);
            rates.BX = (turning * sz) - (slowing * wx);
            rates.BZ = -((turning * sx) + (slowing * wz));
            rates.TractionSquared = 0;
            rates.BrakingSquared = spins ? decay * decay * spinSquared : decay * decay;
            return new PlaneAcceleration(ax, az);
        }
    }

    /// <summary>Subtracts the wind field at a position and time from a velocity, and returns the branch of the drag law for the result.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private DragBranch AddWind(in PlaneStart on, double spinSquared, double after, double wayX, double wayZ, ref double ux, ref double uy, ref double uz)
    {
        Vector3d at = on.From + Axes.InWorld(wayX, 0, wayZ);
        Vector3d wind = _air.WindAt(on.Time + after, at.X, at.Y, at.Z);
        ux -= Vector3d.Dot(in wind, in Axes.X);
        uy -= Vector3d.Dot(in wind, in Axes.Normal);
        uz -= Vector3d.Dot(in wind, in Axes.Z);
        return DragJump.Choose(_jumps, locates: false, on.Branch, (ux * ux) + (uy * uy) + (uz * uz), _radiusSquared * spinSquared);
    }

    /// <summary>True if the step may have crossed the jump in the drag law (conservative).</summary>
    public bool MayCrossJump(in PlaneStart on, in PlaneMotion start, PlaneAcceleration along, in PlaneRates rates, in PlaneMotion end, double h)
    {
        DragJump from = JumpAt(in start);
        double ux = start.VX - WindX;
        double uz = start.VZ - WindZ;
        var change = DragJump.Rate(
            2.0 * ((ux * along.X) + (uz * along.Z)), 2.0 * _radiusSquared * ((start.WX * rates.BX) + (start.WY * rates.BY) + (start.WZ * rates.BZ)));
        DragJump to = JumpAt(in end);
        return DragJump.MayCross(on.Branch, in from, in change, in to, h);
    }

    private DragJump JumpAt(in PlaneMotion at)
    {
        double ux = at.VX - WindX;
        double uz = at.VZ - WindZ;
        return DragJump.At(
            (ux * ux) + (WindUp * WindUp) + (uz * uz), _radiusSquared * at.SpinSquared);
    }
}
