#nullable enable
using System.Collections.Generic;
using FootballPhysics.Engines;
using FootballPhysics.Shapes;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>
/// Godot's bodies as colliders of the ball, found by PhysicsDirectSpaceState3D.CastMotion and GetRestInfo. Spheres, capsules and boxes have their exact shapes. Any
/// other shape acts as its tangent plane at the point that the ball would touch.
/// </summary>
/// <remarks>The size of a shape is read when the ball first hits it. Godot returns its results as dictionaries, which it allocates.</remarks>
public sealed class FootballColliders : IEngineColliders
{
    /// <summary>The maximum number of bodies that a cast finds.</summary>
    private const int MostBodies = 32;

    /// <summary>The distance beyond the unsafe fraction of a cast at which contacts are queried, m.</summary>
    private const float Beyond = 1e-3f;

    /// <summary>The ball touches a surface up to this multiple of its radius from its centre.</summary>
    private const float Skin = 1.01f;

    /// <summary>The number of casts after the first one. Godot's cast is a bisection of 8 steps, up to 1/256 of its motion late; each cast between safe and unsafe divides that by 256.</summary>
    private const int Refinements = 1;

    private readonly Dictionary<(ulong Body, int Owner), EngineCollider> _known = new();
    private readonly Dictionary<EngineCollider, CollisionObject3D> _bodies = new();
    private readonly PhysicsDirectSpaceState3D _space;
    private readonly bool _pushes;
    private bool _warned;
    private readonly SphereShape3D _sphere = new();
    private readonly PhysicsShapeQueryParameters3D _query = new();
    private readonly Godot.Collections.Array<Rid> _excluded = new();
    private readonly Godot.Collections.Array<Rid> _others = new();

    /// <summary>Creates the colliders for a ball in a space.</summary>
    /// <param name="space">The space: GetWorld3D().DirectSpaceState, in _PhysicsProcess.</param>
    /// <param name="mask">The layers that the ball hits.</param>
    /// <param name="greatestSpeed">An upper bound of the speed of any point of the bodies in them, m/s, including rotation.</param>
    /// <param name="pushes">True if dynamic bodies react with their mass. The event contains the impulse, which the game applies.</param>
    public FootballColliders(PhysicsDirectSpaceState3D space, uint mask, double greatestSpeed, bool pushes = false)
    {
        _pushes = pushes;
        _space = space;
        _query.CollisionMask = mask;
        _query.Shape = _sphere;
        MaximumSpeed = greatestSpeed;
    }

    /// <summary>The time at which the positions of Godot's bodies hold, on the ball's clock, s. Set it before every step.</summary>
    public double Time { get; set; }

    /// <summary>An upper bound of the speed of the bodies, m/s.</summary>
    public double MaximumSpeed { get; set; }

    /// <summary>Returns Godot's body of a collider; null if there is none.</summary>
    public CollisionObject3D? Of(EngineCollider? collider) => collider is not null && _bodies.TryGetValue(collider, out CollisionObject3D? body) ? body : null;

    /// <summary>Adds the bodies that a sphere touches on its path.</summary>
    public void Cast(in SphereCast cast, EngineHits hits)
    {
        Vector3 from = GodotFrame.ToGodot(cast.From);
        Vector3 motion = GodotFrame.ToGodot(cast.Distance * cast.Direction);
        _sphere.Radius = (float)cast.Radius;
        _excluded.Clear();

        // First add the bodies that overlap the sphere at the start, which a cast omits, then those on its path, one by one.
        while (_excluded.Count < MostBodies && TryRest(from, in cast, hits))
        {
        }

        while (_excluded.Count < MostBodies && cast.Distance > 0 && TryCast(from, motion, _excluded, out Vector3 place))
        {
            // A ball that only grazes a body may have left it this far beyond the end of the cast.
            if (!TryRest(place + (motion * (Beyond / (float)cast.Distance)), in cast, hits) && !TryRest(place, in cast, hits))
            {
                break;
            }
        }
    }

    /// <summary>Finds the position at which the sphere first touches a body on its path. Returns false if it touches none.</summary>
    private bool TryCast(Vector3 from, Vector3 motion, Godot.Collections.Array<Rid> excluded, out Vector3 place)
    {
        place = from + motion;
        for (int i = 0; i <= Refinements; i++)
        {
            _query.Transform = new Transform3D(Basis.Identity, from);
            _query.Motion = motion;
            _query.Exclude = excluded;
            float[] fractions = _space.CastMotion(_query);
            if (fractions.Length < 2)
            {
                // The space rejects queries, for instance while it is locked. Find nothing now; the next step tries again.
                if (!_warned)
                {
                    _warned = true;
                    GD.PushWarning("Godot's space rejected a query of the football: it hits no bodies in this step. Step the ball in _PhysicsProcess.");
                }

                return false;
            }

            if (fractions[1] >= 1)
            {
                // In a refinement, rounding alone may find nothing. Then use the end of the motion.
                return i > 0;
            }

            place = from + (motion * fractions[1]);
            from += motion * fractions[0];
            motion *= fractions[1] - fractions[0];
        }

        return true;
    }

    /// <summary>Returns the contact of the sphere at a position; empty if there is none.</summary>
    private Godot.Collections.Dictionary RestAt(Vector3 place, Godot.Collections.Array<Rid> excluded)
    {
        _query.Transform = new Transform3D(Basis.Identity, place);
        _query.Motion = Vector3.Zero;
        _query.Exclude = excluded;
        return _space.GetRestInfo(_query);
    }

    private bool TryRest(Vector3 place, in SphereCast cast, EngineHits hits)
    {
        Godot.Collections.Dictionary rest = RestAt(place, _excluded);
        if (rest.Count == 0)
        {
            return false;
        }

        Rid rid = rest["rid"].AsRid();
        _excluded.Add(rid);
        ulong id = rest["collider_id"].AsUInt64();

        // The velocity is that of the body's surface at this point: v + ω × r.
        if (GodotObject.InstanceFromId(id) is not CollisionObject3D body || !AddShapes(id, body, rest["point"].AsVector3(), rest["linear_velocity"].AsVector3(), hits))
        {
            rest = Exact(rid, rest, in cast);
            EngineCollider plane = Known(id, -1, (GodotObject.InstanceFromId(id) as Node)?.Name.ToString() ?? "body", null);
            plane.TouchAt(
                GodotFrame.FromGodot(rest["point"].AsVector3()), GodotFrame.FromGodot(rest["normal"].AsVector3()), GodotFrame.FromGodot(rest["linear_velocity"].AsVector3()));
            hits.Add(plane);
        }

        return true;
    }

    /// <summary>Returns the contact of the ball itself with a body of another shape. The sphere of the cast is larger; if the ball does not reach the body, the contact of the sphere is returned.</summary>
    /// <param name="rid">The body.</param>
    /// <param name="rest">The contact of the sphere.</param>
    /// <param name="cast">The cast.</param>
    private Godot.Collections.Dictionary Exact(Rid rid, Godot.Collections.Dictionary rest, in SphereCast cast)
    {
        Vector3 from = GodotFrame.ToGodot(cast.From);
        float radius = (float)cast.BallRadius;
        if (!(cast.Distance > 0) || (from - rest["point"].AsVector3()).Dot(rest["normal"].AsVector3()) <= Skin * radius)
        {
            return rest;
        }

        Vector3 motion = GodotFrame.ToGodot((cast.Distance + cast.Radius) * cast.Direction);
        Vector3 beyond = GodotFrame.ToGodot(Beyond * cast.Direction);
        _others.Clear();
        foreach (Rid other in _excluded)
        {
            if (other != rid)
            {
                _others.Add(other);
            }
        }

        // Godot can exclude bodies, but cannot query a single one, so exclude the others one by one.
        _sphere.Radius = radius;
        while (_others.Count < MostBodies && TryCast(from, motion, _others, out Vector3 place))
        {
            Godot.Collections.Dictionary touched = RestAt(place + beyond, _others);
            touched = touched.Count > 0 ? touched : RestAt(place, _others);
            if (touched.Count == 0 || touched["rid"].AsRid() == rid)
            {
                rest = touched.Count > 0 ? touched : rest;
                break;
            }

            _others.Add(touched["rid"].AsRid());
        }

        _sphere.Radius = (float)cast.Radius;
        return rest;
    }

    /// <summary>Adds all enabled shapes of a body, if the library has all of them.</summary>
    /// <param name="id">The instance ID of the body.</param>
    /// <param name="body">The body.</param>
    /// <param name="point">The point of the contact.</param>
    /// <param name="velocity">The velocity of the surface at this point.</param>
    /// <param name="hits">Receives the shapes.</param>
    private bool AddShapes(ulong id, CollisionObject3D body, Vector3 point, Vector3 velocity, EngineHits hits)
    {
        int[] owners = System.Array.FindAll(body.GetShapeOwners(), owner => !body.IsShapeOwnerDisabled((uint)owner));
        foreach (int owner in owners)
        {
            if (body.ShapeOwnerGetShapeCount((uint)owner) != 1 || Shape(body.ShapeOwnerGetShape((uint)owner, 0)) is null)
            {
                return false;
            }
        }

        Vector3 spin = body is RigidBody3D rigid ? rigid.AngularVelocity : Vector3.Zero;
        foreach (int owner in owners)
        {
            EngineCollider known = Known(id, owner, body.Name.ToString(), body.ShapeOwnerGetShape((uint)owner, 0));
            Transform3D at = body.GlobalTransform * body.ShapeOwnerGetTransform((uint)owner);

            // At the origin of the shape, the velocity differs from that at the contact by ω × r.
            Vector3 there = velocity - spin.Cross(point - at.Origin);
            known.MoveTo(GodotFrame.FromGodot(at.Origin), GodotFrame.FromGodot(at.Basis.GetRotationQuaternion()), GodotFrame.FromGodot(there), GodotFrame.SpinFromGodot(spin));
            hits.Add(known);
        }

        return owners.Length > 0;
    }

    private EngineCollider Known(ulong body, int owner, string name, Shape3D? shape)
    {
        // A body that was frozen or released, or changed its mass, needs a new collider.
        var met = GodotObject.InstanceFromId(body) as CollisionObject3D;
        double mass = _pushes && met is RigidBody3D { Freeze: false } free ? free.Mass : double.PositiveInfinity;
        if (!_known.TryGetValue((body, owner), out EngineCollider? known) || known.Mass != mass)
        {
            SurfaceMaterial surface = GodotObject.InstanceFromId(body) is Node node && node.HasMeta("football_surface")
                ? SurfaceOf(node.GetMeta("football_surface").AsString())
                : SurfaceMaterial.GoalFrame;
            known = shape is not null && Shape(shape) is { } own ? new EngineCollider(name, own, surface) { Mass = mass } : new EngineCollider(name, surface) { Mass = mass };
            _known[(body, owner)] = known;
            if (met is not null)
            {
                _bodies.Add(known, met);
            }
        }

        return known;
    }

    /// <summary>Returns the material for the metadata football_surface of a body: a preset, or turf. Any other name gives the frame of a goal.</summary>
    private static SurfaceMaterial SurfaceOf(string name) => name == "turf" ? SurfaceMaterial.MatchTurf : SurfaceMaterial.Presets.GetValueOrDefault(name, SurfaceMaterial.GoalFrame);

    private static IShape? Shape(Shape3D shape)
    {
        switch (shape)
        {
            case SphereShape3D sphere:
                return new SphereShape(Vector3d.Zero, sphere.Radius);
            case BoxShape3D box:
                return new BoxShape(Vector3d.Zero, new Vector3d(0.5 * box.Size.X, 0.5 * box.Size.Y, 0.5 * box.Size.Z));
            case CapsuleShape3D capsule:
                double half = (0.5 * capsule.Height) - capsule.Radius;
                return half > 0
                    ? new CapsuleShape(new Vector3d(0, -half, 0), new Vector3d(0, half, 0), capsule.Radius)
                    : new SphereShape(Vector3d.Zero, capsule.Radius);
            default:
                return null;
        }
    }
}
