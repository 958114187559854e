using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>One contact of a contact set at the level of forces: its mode, its material, and its last load and friction.</summary>
internal struct SetContact
{
    /// <summary>Index of the collider.</summary>
    public int Collider;

    /// <summary>True if it has a load. Otherwise the contact is only monitored.</summary>
    public bool Bears;

    /// <summary>True if it sticks; otherwise it slips along <see cref="Direction"/>.</summary>
    public bool Sticks;

    /// <summary>True if its normal and its velocity are constant throughout a piece.</summary>
    public bool IsFixed;

    /// <summary>ŝ, the direction of the slip at the start of the piece. Friction keeps this direction if a stage passes zero.</summary>
    public Vector3d Direction;

    /// <summary>n, towards the ball, and two directions along the surface.</summary>
    public Vector3d Normal;
    public Vector3d First;
    public Vector3d Second;

    /// <summary>V_c, the velocity of the surface at the contact point, m/s, and its rate along the path, m/s².</summary>
    public Vector3d Surface;
    public Vector3d SurfaceRate;

    /// <summary>v − V_p, m/s, and the acceleration of the material at the ball's centre, m/s².</summary>
    public Vector3d RollingVelocity;
    public Vector3d MaterialRate;

    /// <summary>Ω·n, rad/s.</summary>
    public double CarrierSpin;

    /// <summary>ṅ, 1/s, and qᵀHq − A_s·n, m/s²; n·v̇ is at least the negative of the latter.</summary>
    public Vector3d Turning;
    public double Centripetal;

    /// <summary>The resistance of the surface.</summary>
    public Resistance Resistance;

    /// <summary>N/m and F/m of the last solution, m/s².</summary>
    public double Load;
    public Vector3d Friction;

    /// <summary>Acceleration off the surface of a contact without load, m/s².</summary>
    public double Opening;

    /// <summary>s, the slip, m/s.</summary>
    public Vector3d Slip;

    /// <summary>μ_s N − |F|, m/s²: at zero a sticking contact starts to slip.</summary>
    public readonly double Grip => Resistance.MostFriction(Load) - Friction.Length;

    /// <summary>c₀ N/m, m/s²: the rolling resistance at a standstill.</summary>
    public readonly double MostRolling => Resistance.MostRolling(Load, 0);

    /// <summary>|F| − μ_s N, m/s²: the friction beyond the cone that sticking needs. Above 0 the contact must slip.</summary>
    public readonly double Excess => Friction.Length - (Resistance.MostFriction(Load) * (1.0 + ContactTolerances.BeyondCone));

    /// <summary>The number of unknown forces: a load, and two friction components if the contact sticks.</summary>
    public readonly int Width => !Bears ? 0 : Sticks ? 3 : 1;

    /// <summary>True if a slip begins here: it has a direction, but no size yet.</summary>
    public readonly bool StartsToSlip => Bears && !Sticks && Direction != Vector3d.Zero && Slip == Vector3d.Zero;

    /// <summary>The direction of the slip, or that at the start if a stage has passed zero: friction must not push the slip beyond
    /// zero.</summary>
    public readonly Vector3d SlipDirection
    {
        get
        {
            double size = Slip.Length;
            return size > 0 && Vector3d.Dot(in Slip, in Direction) > 0 ? Slip / size : Direction;
        }
    }

    /// <summary>True if rolling resistance acts at this contact and not at another: sticking before slipping, then the greater
    /// load.</summary>
    public readonly bool Outweighs(in SetContact other) =>
        (Sticks && !other.Sticks) || (Sticks == other.Sticks && Load > other.Load * (1.0 + ContactTolerances.SameLoad));

    /// <summary>Activates the contact. It sticks if its slip is below a limit, m/s.</summary>
    public void Press(double sticking)
    {
        Bears = true;
        Sticks = Slip.Length < sticking && Resistance.Rubs;
    }

    /// <summary>Starts a slip against the friction that sticking needed.</summary>
    public void StartSlip()
    {
        Sticks = false;
        Slip = default;
        Direction = -1.0 / Friction.Length * Friction;
    }

    /// <summary>Turns a starting slip in the direction of its rate, m/s².</summary>
    /// <returns>True if the direction has changed.</returns>
    public bool TurnSlip(in Vector3d rate)
    {
        double size = rate.Length;
        Vector3d direction = size > 0 ? rate / size : Direction;
        bool changes = (direction - Direction).Length > ContactTolerances.SameDirection;
        Direction = direction;
        return changes;
    }

    /// <summary>ṡ = (v̇ − A + r ṅ × ω + r n × ω̇)_t, m/s².</summary>
    public readonly Vector3d SlipRate(in MotionRates rates, in Vector3d spin, double radius) => SurfaceSystem.Tangential(
        rates.Acceleration - SurfaceRate + (radius * (Vector3d.Cross(in Turning, in spin) + Vector3d.Cross(in Normal, in rates.SpinAcceleration))), in Normal);

    /// <summary>Prepares a contact that a ball touches.</summary>
    public void Prepare(in Contact contact, Collider collider)
    {
        this = default;
        Collider = contact.Collider;
        Bears = true;
        Resistance = contact.Material.Resistance;

        // A plane or a flat face that does not rotate is constant throughout the piece.
        IsFixed = contact.IsFlat && collider.Spin == Vector3d.Zero && (collider.HasFaces || collider.IsPlane);
        Surface = contact.Velocity;
        Turn(contact.Normal);
    }

    /// <summary>Sets the normal and the tangent directions.</summary>
    public void Turn(in Vector3d normal)
    {
        Normal = normal;
        Vector3d across = Math.Abs(normal.X) < 0.6 ? new Vector3d(1, 0, 0) : Vector3d.Up;
        First = (across - (Vector3d.Dot(in across, in normal) * normal)).Normalized();
        Second = Vector3d.Cross(in normal, in First);
    }

    /// <summary>Updates the geometry and the velocities for a motion of the ball.</summary>
    public void Look(World world, double time, in Motion at)
    {
        double r = world.Ball.Radius;
        if (!IsFixed)
        {
            Collider collider = world.ByIndex[Collider];
            ShapePoint point = collider.At(in at.Position, time);
            Unsafe.SkipInit(out SurfaceForces on);
            SurfaceForces.Describe(collider, r, in point, time, in at, ref on);
            Turn(on.Normal);
            Surface = on.Surface;
            SurfaceRate = on.SurfaceRate;
            RollingVelocity = on.Rolling;
            MaterialRate = on.MaterialRate;
            CarrierSpin = Vector3d.Dot(collider.Spin, on.Normal);
            Turning = on.Turning;
            Centripetal = on.Centripetal;
        }
        else
        {
            RollingVelocity = at.Velocity - Surface;
        }

        Slip = Contacts.Slip.Of(at.Velocity - Surface, in at.Spin, in Normal, r);
    }
}
