using System.Runtime.CompilerServices;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>The equations of a ball that slides or rolls on a surface (contact.md, One contact).</summary>
/// <remarks>
/// Symbols: n the normal, q the velocity relative to the shape, H the curvature, V_c and V_p the velocities of the carrier's material at
/// the
/// contact point and at the ball's centre, A the rate of V_c, a_t the tangential acceleration by all forces except friction.
/// Load: N/m = max(0, −(a_b − A_s)·n − qᵀHq), minus the normal part of the air's acceleration if it acts.
/// Sliding: v̇_t = a_t − μ_s (N/m) ŝ, ω̇ = (μ_s N r/I) n × ŝ + torques.
/// Rolling: v̇_t = (a_b,t + α (A_t + r ω_n n × ṅ))/(1+α) + a_air,t/κ − (μ_r + c₁|v−V_p|)(N/m) v̂, ω_t = n × (v−V_c)/r.
/// The normal part of v̇ keeps the ball on the surface.
/// </remarks>
internal unsafe struct SurfaceSystem : IContactMotion
{
    /// <summary>The share of the distance to the singularity of the direction that a part takes, and the greatest product of length and turning rate.</summary>
    private const double ShareOfPart = 0.6;
    private const double TurnOfPart = 3.0;

    /// <summary>The events that end a piece: the ball leaves the surface, slips, comes to rest, or drilling friction stops its spin about the
    /// normal.</summary>
    private enum Limit
    {
        Load,
        Grip,
        Rest,
        Spin,
    }

    public Surroundings Around;
    public World World;
    public Collider Carrier;

    /// <summary>The forces of the last evaluation.</summary>
    public SurfaceForces Forces;

    /// <summary>Material of the carrier below the ball, for the entire piece.</summary>
    public ContactMaterial Material;
    public DragBranch Branch;

    /// <summary>The orientation at the start of the piece; set only if a knuckle force acts.</summary>
    public Quaterniond Orientation;
    public ulong Nets;
    public ulong NetSides;

    /// <summary>The nets that stay slack for the entire piece; the others stay taut. If null, the velocity decides at each instant.</summary>
    public ulong? NetsSlack;

    /// <summary>True if the ball rolls; false if it slides.</summary>
    public bool Rolls;

    /// <summary>True if it rolls however little friction holds it.</summary>
    public bool KeepsGrip;

    /// <summary>Direction of the slip or the roll at the start of the piece.</summary>
    /// <remarks>Friction keeps this direction if a stage passes zero.</remarks>
    public Vector3d Direction;

    /// <summary>The velocity of the carrier from which the slip or the roll of a ball in a net is measured, m/s.</summary>
    public Vector3d Reference;

    /// <summary>The part of the rate of the slip or the roll that is due to friction, m/s².</summary>
    public double Slowing;

    /// <summary>The minimum length of a part, s.</summary>
    public double ShortestPart;

    /// <summary>True if friction keeps <see cref="Direction"/> for the entire piece.</summary>
    /// <remarks>
    /// It is used for a slip or a roll so slow that friction could reverse it within the piece. The integrator would then amplify rounding
    /// errors across it.
    /// </remarks>
    public bool LocksDirection;

    /// <summary>True if friction acts along the push on the slip at each instant, see SlowSlip.</summary>
    public bool FollowsPush;

    /// <summary>True if the ball is at a standstill on the carrier and only spins about the normal.</summary>
    public bool Pinned;

    /// <summary>True if the ball is on a flat face for the entire piece.</summary>
    public bool IsFace;

    /// <summary>True if <see cref="FaceNormal"/> is the normal for the entire piece: the shape is a plane or a face, does not rotate, and is not
    /// evaluated.</summary>
    public bool IsFlat;

    /// <summary>The normal at the start of the piece.</summary>
    public Vector3d FaceNormal;

    /// <summary>The carrier's velocity jump at the start of the step, divided by its length, m/s².</summary>
    /// <remarks>A ball does not come to rest on a carrier that accelerates faster than rolling friction can take it along.</remarks>
    public Vector3d CarrierGain;

    /// <summary>Sign of the ball's spin about the normal, relative to the carrier. Drilling friction keeps this sign.</summary>
    public double SpinSign;

    /// <summary>The spin at the start of the piece, rad/s.</summary>
    public Vector3d StartSpin;

    /// <summary>Spin decay by the air in a slide if it exceeds the torque of friction, rad/s²; otherwise 0.</summary>
    /// <remarks>The spin can then only decrease.</remarks>
    private double _ending;

    public ForceTrace* Trace { get; set; }

    /// <summary>Creates the system of a ball on a carrier, which slides unless <see cref="Rolls"/> is set.</summary>
    /// <param name="around">The forces.</param>
    /// <param name="carrier">The carrier.</param>
    /// <param name="s">The ball.</param>
    /// <param name="branch">The branch of the drag law.</param>
    public static SurfaceSystem On(Surroundings around, Collider carrier, in BallState s, DragBranch branch) => new()
    {
        Around = around,
        World = around.World,
        Carrier = carrier,
        Material = carrier.MaterialAt(s.Position),
        Branch = branch,
        Nets = s.Nets,
        NetSides = s.NetSides,
        Orientation = around.Air.HasSide ? s.Orientation : default,
    };

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        if (HasEnded(in at.Spin))
        {
            // Continue the decay beyond zero, so that the end of the piece can be located, but with no spin to lift the ball.
            var still = new Motion(in at.Position, in at.Velocity, Vector3d.Zero);
            Look(time, in still);
            rates = new MotionRates(Sliding(in still, in Forces).Acceleration, (-_ending / StartSpin.Length) * StartSpin);
            return;
        }

        Look(time, in at);
        rates = RatesAt(in at);
    }

    /// <summary>Returns the rates of change for the forces of the last evaluation.</summary>
    public MotionRates RatesAt(in Motion at)
    {
        if (!Rolls)
        {
            // A spin whose square underflows has no direction in which it could end.
            _ending = Forces.Braking > Turning(in Forces) && !Around.Air.Varies && StartSpin.LengthSquared > 0 ? Forces.Braking : 0;
        }

        MotionRates rates = Rolls ? Rolling(in at, in Forces) : Sliding(in at, in Forces);
        return Around.Air.HasSide ? rates.Turned(in at) : rates;
    }

    public readonly int Margins => (int)Limit.Spin + 1;

    public void Look(double time, in Motion at) => ForcesOn(time, in at, out Forces);

    public readonly double Margin(int index, double time, in Motion at)
    {
        switch ((Limit)index)
        {
            case Limit.Load:
                return Forces.FreeLoad;
            case Limit.Grip when Rolls && !KeepsGrip:
                return MostFriction(in Forces) - Traction(in Forces).Length;
            case Limit.Rest when Rolls:
                return Rests(in Forces) ? World.AboveRest(in at, Carrier, time) : 1;
            case Limit.Spin when Material.Resistance.Drills && SpinSign != 0:
                // Without drilling friction, the end of the spin has no effect.
                return SpinSign * AboutCarrier(in at.Spin, in Forces.Normal);
            default:
                return 0;
        }
    }

    public double LongestPart(in Motion at, in MotionRates rates)
    {
        double longest = World.NetForces.Longest(Nets, NetSides, in at.Position, in at.Velocity);
        if (LocksDirection || Pinned)
        {
            return longest;
        }

        // In complex time, the direction of a slip s is singular at the distance |s|/|ṡ|. Friction turns it at the rate k/|s|.
        Vector3d velocity = at.Velocity - Reference;
        double r = World.Ball.Radius;
        Vector3d moving = Rolls ? Tangential(in velocity, in FaceNormal) : Slip.Of(in velocity, in at.Spin, in FaceNormal, r);
        Vector3d rate = Rolls ? Tangential(rates.Acceleration, in FaceNormal) : Slip.Of(rates.Acceleration, rates.SpinAcceleration, in FaceNormal, r);
        double size = moving.Length;
        Direction = size > 0 ? moving / size : Direction;
        return Math.Min(longest, Math.Max(ShortestPart, ShareOfPart * size / Math.Max(rate.Length, Slowing / TurnOfPart)));
    }

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in step.Rotation);
        s.Position = step.End.Position;
        s.Velocity = step.End.Velocity;

        // A greater spin at the end means that the spin has passed zero: near zero, a stage gave it an arbitrary direction.
        Vector3d spin = step.End.Spin;
        bool ended = HasEnded(in spin) || (_ending > 0 && spin.LengthSquared > StartSpin.LengthSquared);
        s.SpinAxis = ended ? Vector3d.Zero : spin;
    }

    /// <summary>True if the air has stopped the spin.</summary>
    private readonly bool HasEnded(in Vector3d spin) => _ending > 0 && Vector3d.Dot(in spin, in StartSpin) < 0;

    /// <summary>Returns the angular acceleration of a sliding ball by friction, rad/s².</summary>
    private readonly double Turning(in SurfaceForces on) => MostFriction(in on) / (World.Ball.InertiaFactor * World.Ball.Radius);

    /// <summary>Computes all forces except friction.</summary>
    public readonly void ForcesOn(double time, in Motion at, out SurfaceForces on)
    {
        Unsafe.SkipInit(out on);

        // Get the normal n, its rate ṅ, and qᵀHq − A_s·n: the acceleration of the carrier below the ball, from the curvature H and the velocity q along it.
        if (IsFlat && Carrier.Spin == Vector3d.Zero)
        {
            on.DescribeFlat(Carrier, in FaceNormal, in at);
        }
        else
        {
            ShapePoint point = IsFlat ? new ShapePoint(World.Ball.Radius, in FaceNormal, SymmetricMatrix3d.Zero) : Carrier.At(in at.Position, time);
            SurfaceForces.Describe(Carrier, World.Ball.Radius, in point, time, in at, ref on);
        }

        Vector3d n = on.Normal;
        on.Slip = Rolls ? Vector3d.Zero : Slip.Of(at.Velocity - on.Surface, in at.Spin, in n, World.Ball.Radius);

        // N/m = −(a_b − A_s)·n − qᵀHq is the load that makes the ball follow the surface; a_b is gravity and buoyancy, A_s the material's acceleration.
        Vector3d body = Around.Weight;
        double load = -Vector3d.Dot(in body, in n) - on.Centripetal;
        on.Body = Tangential(in body, in n);

        // In the measured profile, the normal component of the air and the custom forces adds to the load.
        var free = new FreeForces(Around, Branch, Rolls ? MotionState.Rolling : MotionState.Sliding, time, in at, Trace);
        Vector3d push = free.Push;
        load -= World.AirLoads ? Vector3d.Dot(in push, in n) : 0;
        on.Air = Tangential(in push, in n);
        on.Own = free.Air.Acceleration;
        on.OwnTorque = free.Air.SpinAcceleration;
        on.Torque = free.Torque;
        on.Spins = free.SpinRate > 0;
        on.Braking = on.Spins ? free.Air.Decay * free.SpinRate : free.Air.Decay;

        // A net's force acts fully along the surface. Along the normal, only the component that presses the ball onto the surface acts; on the end of a net,
        // all of it does, because the net pulls the ball off its end.
        double pressing = 0;
        if (Nets != 0)
        {
            MotionRates nets = World.NetForces.Push(Nets, NetSides, NetsSlack, in at);
            pressing = -Vector3d.Dot(nets.Acceleration, in n);
            pressing = Carrier.IsNetEnd ? pressing : Math.Max(0, pressing);
            on.Body += Tangential(nets.Acceleration, in n);
            on.Torque += nets.SpinAcceleration;
        }

        // Forces that act in flight but not on a surface also hold the ball on the surface, without friction. Otherwise, the ball would leave and
        // return at once.
        on.FreeLoad = pressing + (World.SharesAir ? load : Math.Max(load, -Vector3d.Dot(body + free.Air.Acceleration + free.Flow, in n) - on.Centripetal));
        on.Load = Math.Max(0, load);
        if (Around.Air.HasSide && on.FreeLoad <= ContactTolerances.LeastLoad)
        {
            // A knuckle force acts only in flight. If it would press the ball back at once, the ball stays on the surface.
            Vector3d side = Around.Air.Side(in free.Air.AirVelocity, in at.Spin, at.AirDistance, Orientation.Turned(in at.Turn));
            on.FreeLoad -= Math.Min(0, Vector3d.Dot(in side, in n));
        }
    }

    /// <summary>Returns the negative of the friction per mass that prevents a slip, m/s².</summary>
    /// <remarks>
    /// It is α/(1+α) of the push along the surface, minus the acceleration of the surface, and minus the part that the air's torque turns
    /// on its own, if that torque acts.
    /// </remarks>
    public readonly Vector3d Traction(in SurfaceForces on)
    {
        double alpha = World.Ball.InertiaFactor;
        Vector3d pushed = World.SharesAir ? on.Body + on.Air : on.Body;
        Vector3d traction = alpha / (1.0 + alpha) * (pushed - on.SurfaceRate - on.Gyration);
        return World.SharesAir ? traction - (alpha * World.Ball.Radius / (1.0 + alpha) * Vector3d.Cross(in on.Torque, in on.Normal)) : traction;
    }

    /// <summary>Returns the push on a ball that moves along with its carrier, relative to the carrier, m/s².</summary>
    /// <remarks>The ball stays at rest if rolling friction can hold it against this push.</remarks>
    public readonly Vector3d PushFromRest(in SurfaceForces on)
    {
        // The drive of a rolling ball is (a_b,t − A_s,t)/(1 + α), with the inertia factor α; A_s is the acceleration of the carrier's material.
        Vector3d drive = World.SharesAir ? Drive(in on) : (on.Body / (1.0 + World.Ball.InertiaFactor)) + Tangential(on.Own, in on.Normal);
        return drive - (on.MaterialRate / (1.0 + World.Ball.InertiaFactor));
    }

    /// <summary>Returns the tangential acceleration of a rolling ball without friction, m/s².</summary>
    public readonly Vector3d Drive(in SurfaceForces on)
    {
        double alpha = World.Ball.InertiaFactor;

        // The body force a_b, the air's force a_air and its torque T give (a_b + a_air + α r T × n)/(1 + α). If the spin does not share the air's force:
        // a_b/(1 + α) + a_air. α is the inertia factor.
        Vector3d shared = World.SharesAir ? on.Body + on.Air + (alpha * World.Ball.Radius * Vector3d.Cross(in on.Torque, in on.Normal)) : on.Body;
        Vector3d drive = shared / (1.0 + alpha);
        return World.SharesAir ? drive : drive + on.Air;
    }

    /// <summary>True if rolling friction holds a ball at a standstill.</summary>
    /// <remarks>If the spin does not share the air's force, a ball at rest stays at rest in any wind.</remarks>
    public readonly bool Rests(in SurfaceForces on) =>
        (PushFromRest(in on) - (1.0 / (1.0 + World.Ball.InertiaFactor) * CarrierGain)).Length <= MostRolling(in on, 0);

    /// <summary>True if friction can hold the ball without slip.</summary>
    public readonly bool Grips(in SurfaceForces on) => Traction(in on).Length + ContactTolerances.LeastLoad <= MostFriction(in on);

    /// <summary>μ_s N/m, m/s².</summary>
    public readonly double MostFriction(in SurfaceForces on) => Material.Resistance.MostFriction(on.Load);

    /// <summary>(c₀ + c₁ |v|) N/m, m/s².</summary>
    public readonly double MostRolling(in SurfaceForces on, double speed) => Material.Resistance.MostRolling(on.Load, speed);

    /// <summary>Returns the acceleration of the slip without friction, m/s²: the push along the surface, r n × torques, and the turning
    /// normal.</summary>
    public readonly Vector3d SlipPush(in SurfaceForces on, in Vector3d spin) =>
        on.Body + on.Air + (World.Ball.Radius * (Vector3d.Cross(in on.Normal, in on.Torque) + SlipTurn(in on, in spin))) - on.SurfaceRate;

    /// <summary>The rate of the slip: ṡ = v̇_t − A_t + r (ṅ × ω)_t + r n × ω̇.</summary>
    public readonly Vector3d SlipRate(in SurfaceForces on, in MotionRates rates, in Vector3d spin) =>
        Tangential(in rates.Acceleration, on.Normal)
        + (World.Ball.Radius * (Vector3d.Cross(on.Normal, in rates.SpinAcceleration) + SlipTurn(in on, in spin))) - on.SurfaceRate;

    /// <summary>Returns the part of the rate of the slip or the roll that is due to friction, m/s².</summary>
    /// <param name="on">The forces.</param>
    /// <param name="speed">The speed of a roll, m/s.</param>
    public readonly double SlowingOf(in SurfaceForces on, double speed) => Rolls ? MostRolling(in on, speed) : SlipFriction(in on);

    /// <summary>Returns the deceleration of the slip by friction, m/s².</summary>
    public readonly double SlipFriction(in SurfaceForces on) => (1.0 + (1.0 / World.Ball.InertiaFactor)) * MostFriction(in on);

    /// <summary>Returns the tangential part of ṅ × ω, rad/s²: if the normal turns, spin about it becomes slip.</summary>
    public static Vector3d SlipTurn(in SurfaceForces on, in Vector3d spin) => Vector3d.Dot(in spin, in on.Normal) * Vector3d.Cross(in on.Turning, in on.Normal);

    /// <summary>Returns the rate of the spin about the normal in a slide, rad/s².</summary>
    public readonly double AboutRate(in SurfaceForces on, in Motion at) =>
        AboutNormal(AboutCarrier(in at.Spin, in on.Normal), in on) + Vector3d.Dot(in on.Torque, in on.Normal);

    /// <summary>(ω − Ω)·n, rad/s.</summary>
    public readonly double AboutCarrier(in Vector3d spin, in Vector3d normal) => Vector3d.Dot(in spin, in normal) - Vector3d.Dot(Carrier.Spin, in normal);

    /// <summary>Returns the tangential part of a vector.</summary>
    public static Vector3d Tangential(in Vector3d vector, in Vector3d normal) => vector - (Vector3d.Dot(in vector, in normal) * normal);

    /// <summary>Returns the friction in the rates of a slide or a roll, with rolling resistance, per mass, m/s².</summary>
    public readonly Vector3d FrictionOn(in Motion at, in SurfaceForces on)
    {
        if (Rolls && Pinned)
        {
            return on.MaterialRate - on.Body - on.Air;
        }

        return Rolls ? -Traction(in on) - (MostRolling(in on, on.Rolling.Length) * Along(in on.Rolling)) : -MostFriction(in on) * Along(SlipIn(in on, in at.Spin));
    }

    /// <summary>Returns the vector that friction acts against: the slip, or the push that a slow slip follows.</summary>
    private readonly Vector3d SlipIn(in SurfaceForces on, in Vector3d spin) => FollowsPush ? SlipPush(in on, in spin) : on.Slip;

    /// <summary>Returns the direction of a slip or a roll, or the one at the start if it has reversed within a stage: friction can stop it, but not reverse it.</summary>
    private readonly Vector3d Along(in Vector3d moving)
    {
        double size = moving.Length;
        return size > 0 && !LocksDirection && Vector3d.Dot(in moving, in Direction) > 0 ? moving / size : Direction;
    }

    private readonly MotionRates Sliding(in Motion at, in SurfaceForces on)
    {
        Vector3d n = on.Normal;

        Vector3d s = Along(SlipIn(in on, in at.Spin));
        double friction = MostFriction(in on);

        // If the ball has no spin, the air's torque reduces the torque of friction, but never reverses it.
        double turning = Math.Max(0, Turning(in on) - (on.Spins ? 0 : on.Braking));

        // v̇ = a_t − μ_s (N/m) ŝ − (v − V)ᵀH(v − V) n: forces a_t along the surface, friction against the slip ŝ, and the curvature H.
        Vector3d acceleration = on.Body + on.Air - (friction * s) - (on.Centripetal * n);
        Vector3d spin = on.Torque
            + (turning * Vector3d.Cross(in n, in s))
            + (AboutNormal(AboutCarrier(in at.Spin, in n), in on) * n);
        return new MotionRates(in acceleration, in spin);
    }

    private readonly MotionRates Rolling(in Motion at, in SurfaceForces on)
    {
        Vector3d n = on.Normal;
        double r = World.Ball.Radius;
        double alpha = World.Ball.InertiaFactor;
        double about = Vector3d.Dot(in at.Spin, in n);
        Vector3d sliding = at.Velocity - on.Surface;
        Vector3d rolling = Vector3d.Cross(in n, in sliding) / r;

        // ω̇_n = −(c_ω/I) (ω − Ω)·n + T·n/I + ω_t·ṅ: damping c_ω relative to the carrier's spin Ω, torques T, and the turning normal.
        double aboutRate = AboutNormal(AboutCarrier(in at.Spin, in n), in on) + Vector3d.Dot(in on.Torque, in n) + Vector3d.Dot(in rolling, in on.Turning);
        if (Pinned && Carrier.Spin == Vector3d.Zero)
        {
            return new MotionRates(Vector3d.Zero, aboutRate * n);
        }

        // v̇_t = drive + α (A_t + r ω_n n × ṅ)/(1 + α) − (c₀ + c₁|v|)(N/m) v̂, with the rate A_t of the surface's velocity and rolling resistance c₀, c₁.
        // A pinned ball accelerates like the carrier's material.
        Vector3d along = Pinned ? on.MaterialRate
            : Drive(in on)
                + (alpha * r * about / (1.0 + alpha) * Vector3d.Cross(in n, in on.Turning))
                + (alpha / (1.0 + alpha) * on.SurfaceRate)
                - (MostRolling(in on, on.Rolling.Length) * Along(in on.Rolling));

        // The spin of a rolling ball, ω = n × (v − V_c)/r + ω_n n, and its derivative ω̇. V_c is the velocity of the surface.
        Vector3d spin = ((Vector3d.Cross(in on.Turning, in sliding) + Vector3d.Cross(in n, along - on.SurfaceRate)) / r) + (aboutRate * n) + (about * on.Turning);
        return new MotionRates(along - (on.Centripetal * n), in spin);
    }

    /// <summary>Returns the angular acceleration about the normal by the surface, rad/s².</summary>
    /// <remarks>It is −(c_ω/I) ω_n − sign(ω_n) b μ_s N/I, with ω_n relative to the carrier.</remarks>
    private readonly double AboutNormal(double about, in SurfaceForces on)
    {
        double inertia = World.Ball.MomentOfInertia;
        double drilling = SpinSign * Material.Resistance.MostDrilling(on.Load) * World.Ball.Mass / inertia;
        return (-Material.Resistance.Damping / inertia * about) - drilling;
    }
}
