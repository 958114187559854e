using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenes;

namespace FootballPhysics.Scenarios;

/// <summary>Reads the objects of a scene beyond a level pitch: obstacles, nets, goals, uneven ground.</summary>
public static class WorldInput
{
    /// <summary>Reads the obstacles.</summary>
    public static IReadOnlyList<Obstacle> Obstacles(InputObject root, SurfaceMaterial frame) =>
        [.. root.Objects("obstacles").Select((item, i) => Obstacle(item, i, frame)).OfType<Obstacle>()];

    /// <summary>Reads the zones.</summary>
    public static IReadOnlyList<Zone> Zones(InputObject root) => [.. root.Objects("zones").Select(Zone).OfType<Zone>()];

    /// <summary>Reads the bodies that the game moves; null if there are none.</summary>
    public static KinematicBodies? Bodies(InputObject root)
    {
        IReadOnlyList<InputObject> items = root.Objects("bodies");
        var bodies = new KinematicBodies();
        for (int i = 0; i < items.Count; i++)
        {
            string name = items[i].Text("name", FormattableString.Invariant($"body {i}"));
            IShape? shape = Shape(items[i]);
            SurfaceMaterial surface = Surface(items[i], SurfaceMaterial.Boot);
            double mass = items[i].Limit("mass", double.PositiveInfinity);
            int layer = items[i].Whole("layer", 0);
            KinematicBody? body = shape is null ? null : items[i].Make(() => bodies.Add(name, shape, surface, mass, layer));
            Move(items[i], body);
        }

        return bodies.Count > 0 ? bodies : null;
    }

    /// <summary>Reads the motion of a body at time 0, and sets it. Without these members, the body stays at the origin.</summary>
    private static void Move(InputObject item, KinematicBody? body)
    {
        Vector3d position = item.Vector("position", Vector3d.Zero);
        Vector3d velocity = item.Vector("velocity", Vector3d.Zero);
        Vector3d spin = item.Vector("spin", Vector3d.Zero);
        double[] r = item.Numbers("orientation", "[x, y, z, w]", [0, 0, 0, 1]);
        bool isWithdrawn = item.Flag("withdrawn", false);
        if (body is null)
        {
            return;
        }

        if (isWithdrawn)
        {
            body.Withdraw();
        }
        else if (item.Has("position") || item.Has("velocity") || item.Has("spin") || item.Has("orientation"))
        {
            item.Make(() =>
            {
                body.MoveTo(position, new Quaterniond(r[0], r[1], r[2], r[3]), velocity, spin, 0);
                return body;
            });
        }
    }

    /// <summary>Reads the free-standing nets.</summary>
    public static IReadOnlyList<Net> Nets(InputObject root) => [.. root.Objects("nets").Select((item, i) => Net(item, i))];

    /// <summary>Reads the goals.</summary>
    public static IReadOnlyList<Goal> Goals(InputObject root, SurfaceMaterial frame) => [.. root.Objects("goals").Select(item => Goal(item, frame))];

    /// <summary>Reads the height field of uneven ground; null if not given.</summary>
    public static HeightField? Heights(InputObject ground)
    {
        if (!ground.Has("heights"))
        {
            return null;
        }

        InputObject heights = ground.Object("heights");
        double[] origin = heights.Numbers("origin", "[x, z]", [0, 0]);
        double spacing = heights.Number("spacing");
        heights.Exclude("nodes", "values");
        string name = heights.Has("nodes") ? "nodes" : "values";
        return heights.Table(name) is { } table
            ? heights.Make(() => new HeightField(origin[0], origin[1], spacing, table, name, areNodes: name == "nodes"))
            : null;
    }

    private static Obstacle? Obstacle(InputObject item, int index, SurfaceMaterial frame)
    {
        string name = item.Text("name", FormattableString.Invariant($"obstacle {index}"));
        IShape? shape = Shape(item);
        SurfaceMaterial surface = Surface(item, frame);
        Vector3d velocity = item.Vector("velocity", Vector3d.Zero);
        Vector3d spin = item.Vector("spin", Vector3d.Zero);
        Vector3d pivot = item.Vector("pivot", Vector3d.Zero);
        double mass = item.Limit("mass", double.PositiveInfinity);
        int layer = item.Whole("layer", 0);
        return shape is null ? null : new Obstacle { Name = name, Shape = shape, Surface = surface, Velocity = velocity, Spin = spin, Pivot = pivot, Mass = mass, Layer = layer };
    }

    private static Zone? Zone(InputObject item, int index)
    {
        string name = item.Text("name", FormattableString.Invariant($"zone {index}"));
        IShape? shape = Shape(item);
        ZonePart of = item.Has("of") && item.OneOf("of", "ball", "centre") == "centre" ? ZonePart.Center : ZonePart.Ball;
        int layer = item.Whole("layer", 0);
        return shape is null ? null : new Zone { Name = name, Shape = shape, Of = of, Layer = layer };
    }

    private static IShape? Shape(InputObject item)
    {
        switch (item.OneOf("shape", "plane", "sphere", "capsule", "box"))
        {
            case "plane":
                Vector3d point = item.Vector("point");
                Vector3d normal = item.Vector("normal");
                return item.Make(() => new PlaneShape(point, normal));
            case "sphere":
                Vector3d center = item.Vector("center");
                double radius = item.Number("radius");
                return item.Make(() => new SphereShape(center, radius));
            case "capsule":
                Vector3d from = item.Vector("from");
                Vector3d to = item.Vector("to");
                double around = item.Number("radius");
                return item.Make(() => new CapsuleShape(from, to, around));
            default:
                Vector3d middle = item.Vector("center");
                Vector3d halfSize = item.Vector("halfSize");
                double[] r = item.Numbers("rotation", "[x, y, z, w]", [0, 0, 0, 1]);
                return item.Make(() => new BoxShape(middle, halfSize, new Quaterniond(r[0], r[1], r[2], r[3])));
        }
    }

    /// <summary>Reads the material of an object: its numbers, and the name of the preset for the other numbers.</summary>
    private static SurfaceMaterial Surface(InputObject item, SurfaceMaterial defaults) => Material(item.Object("surface"), defaults);

    /// <summary>Reads the numbers of a material. <c>"material"</c> names the preset of those that are missing.</summary>
    public static SurfaceMaterial Material(InputObject surface, SurfaceMaterial defaults)
    {
        string name = surface.Preset("material", SurfaceMaterial.Presets, "");
        return surface.Numbers(SceneFields.Material, name.Length > 0 ? SurfaceMaterial.Presets[name] : defaults);
    }

    private static Net Net(InputObject item, int index)
    {
        double[] half = item.Numbers("halfSize", "[along, across]", [double.NaN, double.NaN]);
        var net = new Net
        {
            Name = item.Text("name", FormattableString.Invariant($"net {index}")),
            Center = item.Vector("center"),
            Normal = item.Vector("normal"),
            Along = item.Vector("along"),
            HalfLength = half[0],
            HalfWidth = half[1],
        };
        return item.Numbers(SceneFields.Net, net);
    }

    private static Goal Goal(InputObject item, SurfaceMaterial frame)
    {
        var goal = new Goal { Center = item.Vector("center"), Facing = item.Vector("facing") };
        double[] depth = item.Numbers("depth", "[at the bar, on the ground]", [goal.DepthAtBar, goal.DepthOnGround]);
        return goal with
        {
            Width = item.Number("width", goal.Width),
            Height = item.Number("height", goal.Height),
            PostRadius = item.Number("postRadius", goal.PostRadius),
            DepthAtBar = depth[0],
            DepthOnGround = depth[1],
            HasNet = item.Flag("net", true),
            Surface = Surface(item, frame),
        };
    }
}
