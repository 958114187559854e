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

/// <summary>In the shim always the xz plane of its owner.</summary>
public class WorldBoundaryShape3D : Shape3D
{
    public override float Distance(Vector3 point) => point.Y;
}

public class CollisionObject3D : Node3D
{
    private readonly List<(Shape3D Shape, Transform3D Transform)> _shapes = [];

    public virtual Vector3 LinearVelocity { get; set; }

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
    public Vector3 AngularVelocity { get; set; }

    public float Mass { get; set; } = 1;

    public bool Freeze { get; set; }

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

    /// <summary>The fractions of the motion that are safe and unsafe; what is touched at the start is left out.</summary>
    public float[] CastMotion(PhysicsShapeQueryParameters3D parameters)
    {
        float best = 1;
        float length = parameters.Motion.Length();
        float radius = ((SphereShape3D)parameters.Shape).Radius;
        foreach (CollisionObject3D body in All.Where(body => !parameters.Exclude.Contains(body.GetRid()) && body.Distance(parameters.Transform.Origin) > radius))
        {
            float gone = 0;
            for (int i = 0; i < MostSteps && gone < length; i++)
            {
                float gap = body.Distance(parameters.Transform.Origin + (parameters.Motion * (gone / length))) - radius;
                if (gap <= Touching)
                {
                    best = MathF.Min(best, gone / length);
                    break;
                }

                gone += gap;
            }
        }

        return [best, best];
    }

    public Collections.Dictionary GetRestInfo(PhysicsShapeQueryParameters3D parameters)
    {
        float radius = ((SphereShape3D)parameters.Shape).Radius;
        Vector3 at = parameters.Transform.Origin;
        CollisionObject3D? body = All.Where(body => !parameters.Exclude.Contains(body.GetRid()) && body.Distance(at) <= radius).MinBy(body => body.Distance(at));
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
            Vector3 spin = body is RigidBody3D rigid ? rigid.AngularVelocity : Vector3.Zero;
            info.Add("linear_velocity", body.LinearVelocity + spin.Cross(at - (normal * body.Distance(at)) - body.GlobalTransform.Origin));
        }

        return info;
    }
}
