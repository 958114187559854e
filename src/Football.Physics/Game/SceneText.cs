using System.Globalization;
using System.Text;
using FootballPhysics.Scenes;

namespace FootballPhysics.Game;

/// <summary>Writes a scene as scenario JSON with exact numbers. It rejects parts that are code, and names them.</summary>
internal sealed class SceneText
{
    /// <summary>The number of multiples of a rotation that are tried.</summary>
    private const int MostScales = 1024;

    private readonly StringBuilder _text = new();

    /// <summary>True if the next member of the object, or item of the list, is the first.</summary>
    private bool _first = true;

    /// <summary>Returns the text so far.</summary>
    public override string ToString() => _text.ToString();

    /// <summary>Adds the settings, scene and bodies of a simulator as the members "solver", "scene" and "bodies".</summary>
    /// <exception cref="InvalidOperationException">A part of the scene is code.</exception>
    public SceneText Add(Simulator simulator)
    {
        Solver(simulator.Settings, null);
        Object("scene", () => AddScene(simulator.Scene));
        List("bodies", simulator.Scene.Bodies ?? Enumerable.Empty<KinematicBody>(), AddBody);
        return this;
    }

    /// <summary>Adds the settings as the member "solver".</summary>
    /// <param name="settings">The settings.</param>
    /// <param name="timeStep">The step, in s; null for none.</param>
    /// <exception cref="InvalidOperationException">The format has no field for a setting.</exception>
    public SceneText Solver(SolverSettings settings, double? timeStep)
    {
        if (!settings.LocateJump)
        {
            throw Code("solver.locateJump");
        }

        Object("solver", () =>
        {
            Word("integrator", settings.Integrator).Word("collisionTiming", settings.CollisionTiming)
                .Number("collisionTolerance", settings.CollisionTolerance).Word("rollingTransition", settings.RollingTransition);
            _ = timeStep is { } step ? Number("timeStep", step) : this;
        });
        return this;
    }

    /// <summary>Adds the members of a scene, without its bodies.</summary>
    /// <exception cref="InvalidOperationException">A part of the scene is code.</exception>
    public SceneText Add(Scene scene)
    {
        AddScene(scene);
        return this;
    }

    /// <summary>Adds the bodies of a scene as the member "bodies", with their motions; nothing if there are none.</summary>
    /// <param name="bodies">The bodies.</param>
    /// <param name="time">The time of the positions, in s; null for those of the last moves.</param>
    public SceneText Bodies(KinematicBodies? bodies, double? time)
    {
        if (bodies is { Count: > 0 })
        {
            List("bodies", bodies, body =>
            {
                AddBody(body);
                AddMotion(body, (time ?? body.Time) - body.Time);
            });
        }

        return this;
    }

    /// <summary>Adds the motion of a ball as the member "launch".</summary>
    public SceneText Launch(in BallState ball)
    {
        BallState at = ball;
        Object("launch", () => Vector("position", at.Position).Vector("velocity", at.Velocity).Vector("spin", at.Spin).Rotation("orientation", at.Orientation));
        return this;
    }

    /// <summary>Adds a string member.</summary>
    public SceneText Text(string name, string value)
    {
        Name(name);
        Quote(value);
        return this;
    }

    /// <summary>Begins the document.</summary>
    public SceneText Begin()
    {
        _text.Append('{');
        return this;
    }

    /// <summary>Ends the document.</summary>
    public SceneText End()
    {
        _text.Append("}\n");
        return this;
    }

    private void AddScene(Scene scene)
    {
        if (scene.EngineColliders is not null)
        {
            throw Code("engineColliders");
        }

        Text("profile", "measured");
        Object("ball", () => Numbers(SceneFields.Ball, scene.Ball).Whole("seamSeed", scene.Ball.SeamSeed).Curve(scene.Ball.DragCurve).Ignores(scene.Ball.Ignores));
        Object("air", () => AddAir(scene.Air, scene.Ground));
        _ = scene.Sideways == Vector3d.Zero ? Number("gravity", scene.Gravity) : Vector("gravity", scene.GravityVector);
        Object("forces", () => AddForces(scene.Forces));
        Object("ground", () => AddGround(scene.Ground));
        List("obstacles", scene.Obstacles, item => Text("name", item.Name).Shape("obstacles", item.Shape).Material(item.Surface).Vector("velocity", item.Velocity)
            .Vector("spin", item.Spin).Vector("pivot", item.Pivot).Limit("mass", item.Mass).Layer(item.Layer));
        List("nets", scene.Nets, net => Text("name", net.Name).Vector("center", net.Center).Vector("normal", net.Normal).Vector("along", net.Along)
            .Numbers("halfSize", net.HalfLength, net.HalfWidth).Numbers(SceneFields.Net, net));
        List("goals", scene.Goals, goal => Vector("center", goal.Center).Vector("facing", goal.Facing).Number("width", goal.Width).Number("height", goal.Height)
            .Number("postRadius", goal.PostRadius).Numbers("depth", goal.DepthAtBar, goal.DepthOnGround).Flag("net", goal.HasNet).Material(goal.Frame(scene.Forces).First().Surface));
        if (scene.Zones.Count > 0)
        {
            List("zones", scene.Zones, zone => Text("name", zone.Name).Shape("zones", zone.Shape).Text("of", zone.Of == ZonePart.Ball ? "ball" : "centre").Layer(zone.Layer));
        }
    }

    private void AddBody(KinematicBody body) =>
        Text("name", body.Name).Shape("bodies", body.Shape).Material(body.Surface).Limit("mass", body.Mass).Layer(body.Layer);

    /// <summary>Adds the motion of a body, unless it has never been moved.</summary>
    /// <param name="body">The body.</param>
    /// <param name="later">The time since its last move, in s.</param>
    private void AddMotion(KinematicBody body, double later)
    {
        if (body.IsWithdrawn)
        {
            Flag("withdrawn", true);
            return;
        }

        // A step extrapolates a body in the same way: its position moves along its velocity, and it turns about its position.
        Vector3d position = body.Position + (later * body.Velocity);
        Quaterniond turned = later == 0 ? body.Orientation : (Quaterniond.FromRotationVector(later * body.Spin) * body.Orientation).Normalized();
        _ = position == Vector3d.Zero ? this : Vector("position", position);
        _ = body.Velocity == Vector3d.Zero ? this : Vector("velocity", body.Velocity);
        _ = body.Spin == Vector3d.Zero ? this : Vector("spin", body.Spin);
        _ = turned.Equals(Quaterniond.Identity) ? this : Rotation("orientation", in turned);
    }

    /// <summary>Returns a rotation that has the bits of a unit rotation after a reader has normalized it.</summary>
    /// <remarks>Normalizing a unit rotation again can change its last bits, so try multiples of it.</remarks>
    private static Quaterniond Written(in Quaterniond unit, string list)
    {
        for (int i = 0; i < MostScales; i++)
        {
            double scale = 1.0 + (i / (double)MostScales);
            var scaled = new Quaterniond(scale * unit.X, scale * unit.Y, scale * unit.Z, scale * unit.W);
            if (scaled.Normalized().Equals(unit))
            {
                return scaled;
            }
        }

        throw Code($"{list}.rotation ({unit})");
    }

    private SceneText Rotation(string name, in Quaterniond value) => Numbers(name, value.X, value.Y, value.Z, value.W);

    private void AddAir(Air air, Ground ground)
    {
        Numbers(SceneFields.Air, air);
        if (air.WindField is null)
        {
            Vector("wind", air.Wind);
            return;
        }

        // The format supports the library's wind profile, but not a custom wind field, nor a profile plus a steady wind.
        if (air.WindField is not WindByHeight wind || air.Wind != Vector3d.Zero || wind.GroundHeight != (ground.IsNone ? 0 : ground.Height))
        {
            throw Code("air.windField");
        }

        Object("wind", () =>
        {
            Number("speed", wind.Speed).Numbers("direction", wind.Direction.X, wind.Direction.Z).Number("referenceHeight", wind.ReferenceHeight).Number("roughness", wind.Roughness);
            if (wind.Gusts is { } gusts)
            {
                Object("gusts", () => Whole("seed", gusts.Seed).Number("intensity", gusts.Intensity).Number("length", gusts.Length));
            }
        });
    }

    private void AddForces(ForceSet forces)
    {
        if (forces.CustomForces.Count > 0)
        {
            throw Code($"forces.customForces[0] ({forces.CustomForces[0].GetType().Name})");
        }

        Flag("buoyancy", forces.Buoyancy).Word("drag", forces.Drag).Word("magnus", forces.Magnus).Word("spinDecay", forces.SpinDecay).Word("coefficients", forces.Coefficients)
            .Numbers(SceneFields.Forces, forces);
        if (forces.KnuckleSeed is { } seed)
        {
            Whole("knuckleSeed", seed);
        }
    }

    private void AddGround(Ground ground)
    {
        if (ground.Pattern is not null)
        {
            throw Code("ground.pattern");
        }

        // Level ground can have two tangential restitutions; the scenario contains them as [x, z].
        double along = ground.Material.TangentialRestitution;
        Numbers(SceneFields.GroundMaterial, ground.Material).Numbers(SceneFields.Ground, ground)
            .Numbers("tangentialRestitution", along, ground.TangentialRestitutionZ ?? along);

        // Missing ground has an infinite height, which JSON cannot represent: write the preset "none".
        SceneText place = ground.IsNone ? Text("surface", "none") : Number("height", ground.Height).Vector("normal", ground.Normal);
        place.Word("aerodynamics", ground.Aerodynamics);
        if (ground.Heights is { } heights)
        {
            Object("heights", () =>
            {
                Numbers("origin", heights.OriginX, heights.OriginZ).Number("spacing", heights.Spacing);
                Raw(heights.HasNodes ? "nodes" : "values", "[" + string.Join(",", heights.Rows.Select(row => "[" + string.Join(",", row.Select(Digits)) + "]")) + "]");
            });
        }
    }

    private SceneText Curve(DragCurve curve)
    {
        Object("dragCurve", () => Numbers(SceneFields.Drag, curve));
        return this;
    }

    private SceneText Material(SurfaceMaterial surface)
    {
        Object("surface", () => Numbers(SceneFields.Material, surface));
        return this;
    }

    private SceneText Shape(string list, IShape shape) => shape switch
    {
        PlaneShape plane => Text("shape", "plane").Vector("point", plane.Point).Vector("normal", plane.Normal),
        SphereShape sphere => Text("shape", "sphere").Vector("center", sphere.Center).Number("radius", sphere.Radius),
        CapsuleShape capsule => Text("shape", "capsule").Vector("from", capsule.From).Vector("to", capsule.To).Number("radius", capsule.Radius),
        BoxShape box => Text("shape", "box").Vector("center", box.Center).Vector("halfSize", box.HalfSize)
            .Rotation("rotation", Written(box.Rotation, list)),
        _ => throw Code($"{list}.shape ({shape.GetType().Name})"),
    };

    private SceneText Layer(int layer) => layer == 0 ? this : Number("layer", layer);

    private SceneText Ignores(uint set) =>
        set == 0 ? this : Numbers("ignores", [.. Enumerable.Range(0, Layers.Highest + 1).Where(layer => Layers.Contains(set, layer)).Select(layer => (double)layer)]);

    private SceneText Whole(string name, long value) => Raw(name, value.ToString(CultureInfo.InvariantCulture));

    private SceneText Number(string name, double value) => Raw(name, Digits(value));

    /// <summary>Adds a number that may be infinite; infinity is written as null.</summary>
    private SceneText Limit(string name, double value) => Raw(name, double.IsPositiveInfinity(value) ? "null" : Digits(value));

    /// <summary>Adds all numeric fields of a part of the scene.</summary>
    private SceneText Numbers<T>(NumberField<T>[] fields, T part)
    {
        foreach (NumberField<T> field in fields)
        {
            Limit(field.Name, field.Get(part));
        }

        return this;
    }

    private SceneText Flag(string name, bool value) => Raw(name, value ? "true" : "false");

    private SceneText Vector(string name, in Vector3d value) => Numbers(name, value.X, value.Y, value.Z);

    private SceneText Numbers(string name, params double[] values) => Raw(name, "[" + string.Join(",", values.Select(Digits)) + "]");

    private SceneText Word<T>(string name, T value)
        where T : struct, Enum
    {
        // Use the spelling of the scenario format.
        string word = value is AerodynamicModel.Regularized ? "regularised" : value.ToString();
        return Text(name, char.ToLowerInvariant(word[0]) + word[1..]);
    }

    private SceneText Raw(string name, string value)
    {
        Name(name);
        _text.Append(value);
        return this;
    }

    private void Object(string name, Action members)
    {
        Name(name);
        Braced(members);
    }

    private void List<T>(string name, IEnumerable<T> items, Action<T> members)
    {
        Name(name);
        _text.Append('[');
        bool first = true;
        foreach (T item in items)
        {
            _text.Append(first ? "" : ",");
            first = false;
            Braced(() => members(item));
        }

        _text.Append(']');
    }

    private void Braced(Action members)
    {
        // Each nested object starts a new list of members.
        bool before = _first;
        _first = true;
        _text.Append('{');
        members();
        _text.Append('}');
        _first = before;
    }

    private void Name(string name)
    {
        _text.Append(_first ? "" : ",");
        _first = false;
        Quote(name);
        _text.Append(':');
    }

    private void Quote(string text)
    {
        _text.Append('"');
        foreach (char letter in text)
        {
            // Write quotes, backslashes and control characters as \uXXXX, because every JSON reader supports this form.
            if (letter is '"' or '\\' or < ' ')
            {
                _text.Append("\\u").Append(((int)letter).ToString("x4", CultureInfo.InvariantCulture));
            }
            else
            {
                _text.Append(letter);
            }
        }

        _text.Append('"');
    }

    /// <summary>Returns the shortest text that reads back as the same number, or 17 digits if a Unity runtime rounds the shortest one.</summary>
    private static string Digits(double value)
    {
        // Use the shortest text if it parses back to the same number.
        string brief = value.ToString("R", CultureInfo.InvariantCulture);
        return double.Parse(brief, CultureInfo.InvariantCulture).Equals(value) ? brief : value.ToString("G17", CultureInfo.InvariantCulture);
    }

    private static InvalidOperationException Code(string what) => new($"The scene cannot be written as a scenario, because {what} is code or has no scenario member. Use a scene that consists of numbers only.");
}
