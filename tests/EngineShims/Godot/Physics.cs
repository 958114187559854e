namespace Godot;

public readonly record struct Rid(ulong Id);

public class Shape3D : Resource
{
    /// <summary>Distance of a point in the shape's frame.</summary>
    public virtual float Distance(Vector3 point) => float.PositiveInfinity;
}

public class SphereShape3D : Shape3D
{
    public float Radius { get; set; } = 0.5f;

    public override float Distance(Vector3 point) => point.Length() - Radius;
}

public class BoxShape3D : Shape3D
{
    public Vector3 Size { get; set; } = new(1, 1, 1);

    public override float Distance(Vector3 point)
    {
        var q = new Vector3(MathF.Abs(point.X) - (0.5f * Size.X), MathF.Abs(point.Y) - (0.5f * Size.Y), MathF.Abs(point.Z) - (0.5f * Size.Z));
        return new Vector3(MathF.Max(q.X, 0), MathF.Max(q.Y, 0), MathF.Max(q.Z, 0)).Length() + MathF.Min(0, MathF.Max(q.X, MathF.Max(q.Y, q.Z)));
    }
}

public class CapsuleShape3D : Shape3D
{
    public float Radius { get; set; } = 0.5f;

    public float Height { get; set; } = 2;

    public override float Distance(Vector3 point)
    {
        float half = MathF.Max(0, (0.5f * Height) - Radius);
        return (point - new Vector3(0, Math.Clamp(point.Y, -half, half), 0)).Length() - Radius;
    }
}

public class CylinderShape3D : Shape3D
{
    public float Radius { get; set; } = 0.5f;

    public float Height { get; set; } = 2;

    public override float Distance(Vector3 point)
    {
        float aside = MathF.Sqrt((point.X * point.X) + (point.Z * point.Z)) - Radius;
        float above = MathF.Abs(point.Y) - (0.5f * Height);
        float x = MathF.Max(aside, 0);
        float y = MathF.Max(above, 0);
        return MathF.Sqrt((x * x) + (y * y)) + MathF.Min(0, MathF.Max(aside, above));
    }
}

/// <summary>In the shim always the xz plane of its owner.</summary>
public class WorldBoundaryShape3D : Shape3D
{
    public override float Distance(Vector3 point) => point.Y;
}

public class CollisionObject3D : Node3D
{
    private readonly List<(Shape3D Shape, Transform3D Transform)> _shapes = [];

    public uint CollisionLayer { get; set; } = 1;

    public Rid GetRid() => new(GetInstanceId());

    public void Add(Shape3D shape, Transform3D transform) => _shapes.Add((shape, transform));

    public int[] GetShapeOwners() => [.. Enumerable.Range(0, _shapes.Count)];

    public int ShapeOwnerGetShapeCount(uint owner) => 1;

    public bool IsShapeOwnerDisabled(uint owner) => false;

    public Shape3D ShapeOwnerGetShape(uint owner, int shape) => _shapes[(int)owner].Shape;

    public Transform3D ShapeOwnerGetTransform(uint owner) => _shapes[(int)owner].Transform;

    public float Distance(Vector3 place)
    {
        float least = float.PositiveInfinity;
        foreach ((Shape3D shape, Transform3D own) in _shapes)
        {
            Transform3D at = GlobalTransform * own;
            least = MathF.Min(least, shape.Distance(at.Basis.Transposed() * (place - at.Origin)));
        }

        return least;
    }
}

public class StaticBody3D : CollisionObject3D
{
}

public class RigidBody3D : CollisionObject3D
{
    public Vector3 LinearVelocity { get; set; }

    public Vector3 AngularVelocity { get; set; }

    public float Mass { get; set; } = 1;

    public bool Freeze { get; set; }

    public enum DampMode
    {
        Combine,
        Replace,
    }

    private Vector3 _force;
    private Vector3 _torque;

    public bool Sleeping { get; set; }

    public float GravityScale { get; set; } = 1;

    public float LinearDamp { get; set; }

    public float AngularDamp { get; set; }

    public DampMode LinearDampMode { get; set; }

    public DampMode AngularDampMode { get; set; }

    /// <summary>Zero: that of its shapes, which the shim does not know.</summary>
    public Vector3 Inertia { get; set; }

    public void ApplyCentralForce(Vector3 force) => _force += force;

    public void ApplyTorque(Vector3 torque) => _torque += torque;

    /// <summary>A step of the engine without contacts: semi-implicit Euler, with the project's damping of 0.1 where the body combines its own with it.</summary>
    public void Simulate(float step)
    {
        float damp = LinearDamp + (LinearDampMode == DampMode.Combine ? 0.1f : 0);
        float angularDamp = AngularDamp + (AngularDampMode == DampMode.Combine ? 0.1f : 0);
        LinearVelocity = (LinearVelocity + ((new Vector3(0, -9.8f * GravityScale, 0) + (_force * (1 / Mass))) * step)) * (1 - (step * damp));
        AngularVelocity = (AngularVelocity + (_torque * (step / Inertia.X))) * (1 - (step * angularDamp));
        GlobalPosition += LinearVelocity * step;
        _force = Vector3.Zero;
        _torque = Vector3.Zero;
    }

    /// <summary>In the shim an impulse changes the velocity at once, and turns nothing.</summary>
    public void ApplyImpulse(Vector3 impulse, Vector3? position = null) => LinearVelocity += impulse * (1 / Mass);
}

public class PhysicsShapeQueryParameters3D : Resource
{
    public Shape3D Shape { get; set; } = new();

    public Transform3D Transform { get; set; }

    public Vector3 Motion { get; set; }

    public uint CollisionMask { get; set; }

    public Collections.Array<Rid> Exclude { get; set; } = [];
}

public class World3D : Resource
{
    public static World3D Only { get; } = new();

    public PhysicsDirectSpaceState3D DirectSpaceState { get; } = new();
}

/// <summary>Queries among the bodies that a test has put there, for spheres, in single precision as the engine has it.</summary>
public class PhysicsDirectSpaceState3D : GodotObject
{
    private const int MostSteps = 200;
    private const float Touching = 1e-5f;

    public List<CollisionObject3D> All { get; } = [];

    /// <summary>True for a space that rejects queries, as one that is locked.</summary>
    public bool IsLocked { get; set; }

    /// <summary>The fractions of the motion that are safe and unsafe, found as the engine does: by 8 steps, each of which asks if the swept shape touches. Empty if the space rejects the query. What is touched at the start is left out.</summary>
    public float[] CastMotion(PhysicsShapeQueryParameters3D parameters)
    {
        if (IsLocked)
        {
            return [];
        }

        float safe = 1;
        float unsafeFraction = 1;
        float radius = ((SphereShape3D)parameters.Shape).Radius;
        foreach (CollisionObject3D body in All.Where(body => (body.CollisionLayer & parameters.CollisionMask) != 0 && !parameters.Exclude.Contains(body.GetRid()) && body.Distance(parameters.Transform.Origin) > radius))
        {
            float touches = FirstTouch(body, parameters.Transform.Origin, parameters.Motion, radius);
            if (touches > 1)
            {
                continue;
            }

            float low = 0;
            float high = 1;
            float share = 0.5f;
            for (int i = 0; i < 8; i++)
            {
                float fraction = low + ((high - low) * share);
                if (touches <= fraction)
                {
                    high = fraction;
                    share = i == 0 || low > 0 ? 0.5f : 0.25f;
                }
                else
                {
                    low = fraction;
                    share = i == 0 || high < 1 ? 0.5f : 0.75f;
                }
            }

            if (low < safe)
            {
                safe = low;
                unsafeFraction = high;
            }
        }

        return [safe, unsafeFraction];
    }

    /// <summary>The fraction of a motion at which a sphere first touches a body; above 1 if it does not.</summary>
    private static float FirstTouch(CollisionObject3D body, Vector3 from, Vector3 motion, float radius)
    {
        float length = motion.Length();
        float gone = 0;
        for (int i = 0; i < MostSteps && gone <= length; i++)
        {
            float gap = body.Distance(from + (motion * (gone / length))) - radius;
            if (gap <= Touching)
            {
                return gone / length;
            }

            gone += gap;
        }

        return 2;
    }

    public Collections.Dictionary GetRestInfo(PhysicsShapeQueryParameters3D parameters)
    {
        float radius = ((SphereShape3D)parameters.Shape).Radius;
        Vector3 at = parameters.Transform.Origin;
        CollisionObject3D? body = All.Where(body => (body.CollisionLayer & parameters.CollisionMask) != 0 && !parameters.Exclude.Contains(body.GetRid()) && body.Distance(at) <= radius).MinBy(body => body.Distance(at));
        var info = new Collections.Dictionary();
        if (body is not null)
        {
            const float Step = 1e-3f;
            var gradient = new Vector3(
                body.Distance(at + new Vector3(Step, 0, 0)) - body.Distance(at - new Vector3(Step, 0, 0)),
                body.Distance(at + new Vector3(0, Step, 0)) - body.Distance(at - new Vector3(0, Step, 0)),
                body.Distance(at + new Vector3(0, 0, Step)) - body.Distance(at - new Vector3(0, 0, Step)));
            Vector3 normal = gradient * (1 / gradient.Length());
            info.Add("collider_id", body.GetInstanceId());
            info.Add("rid", body.GetRid());
            info.Add("normal", normal);
            info.Add("point", at - (normal * body.Distance(at)));

            // As the engine's own: the velocity of the body at the point of contact.
            var rigid = body as RigidBody3D;
            Vector3 spin = rigid?.AngularVelocity ?? Vector3.Zero;
            info.Add("linear_velocity", (rigid?.LinearVelocity ?? Vector3.Zero) + spin.Cross(at - (normal * body.Distance(at)) - body.GlobalTransform.Origin));
        }

        return info;
    }
}
