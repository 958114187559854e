namespace Godot;

public class GodotObject
{
    /// <summary>What was emitted, in order.</summary>
    public List<(string Signal, Variant[] Arguments)> Emitted { get; } = [];

    /// <summary>What was set by name.</summary>
    public Dictionary<string, Variant> Properties { get; } = [];

    private static readonly List<GodotObject> s_all = [];

    public GodotObject()
    {
        s_all.Add(this);
        Id = (ulong)s_all.Count;
    }

    private ulong Id { get; }

    private readonly Dictionary<string, Variant> _meta = [];

    public ulong GetInstanceId() => Id;

    public static GodotObject? InstanceFromId(ulong id) => s_all[(int)id - 1];

    public bool HasMeta(StringName name) => _meta.ContainsKey(name.ToString());

    public Variant GetMeta(StringName name) => _meta[name.ToString()];

    public void SetMeta(StringName name, Variant value) => _meta[name.ToString()] = value;

    public void Set(StringName property, Variant value) => Properties[property.ToString()] = value;

    public void EmitSignal(StringName signal, params Variant[] arguments)
    {
        // As the engine does: the signal must be declared, with as many arguments.
        Type declared = GetType().GetNestedType(signal + "EventHandler") ?? throw new InvalidOperationException($"There is no signal {signal}.");
        if (declared.GetMethod("Invoke")!.GetParameters().Length != arguments.Length)
        {
            throw new InvalidOperationException($"The signal {signal} does not have {arguments.Length} arguments.");
        }

        Emitted.Add((signal.ToString(), arguments));
    }
}

public class Node : GodotObject
{
    public StringName Name { get; set; } = "";

    public virtual void _Ready()
    {
    }

    public virtual void _EnterTree()
    {
    }

    public virtual void _ExitTree()
    {
    }

    public virtual void _Process(double delta)
    {
    }

    public virtual void _PhysicsProcess(double delta)
    {
    }

    public virtual void _UnhandledInput(InputEvent @event)
    {
    }

    public class SignalName
    {
    }

    private readonly Dictionary<string, Node> _children = [];

    public IReadOnlyCollection<Node> GetChildren() => _children.Values;

    // The shim's tree has whatever node is asked for, ready.
    public T GetNode<T>(string path)
        where T : Node, new()
    {
        if (!_children.TryGetValue(path, out Node? node))
        {
            node = new T();
            _children.Add(path, node);
            node._Ready();
        }

        return (T)node;
    }
}

public class Node3D : Node
{
    public Transform3D GlobalTransform { get; set; } = new(Basis.Identity, Vector3.Zero);

    public World3D GetWorld3D() => World3D.Only;

    public Vector3 GlobalPosition
    {
        get => GlobalTransform.Origin;
        set => GlobalTransform = new Transform3D(GlobalTransform.Basis, value);
    }
}

public class Resource : GodotObject
{
}

public class EditorPlugin : Node
{
}

public static class Engine
{
    public static int PhysicsTicksPerSecond { get; set; } = 60;

    /// <summary>What <see cref="GetPhysicsInterpolationFraction"/> says.</summary>
    public static double InterpolationFraction { get; set; }

    public static double GetPhysicsInterpolationFraction() => InterpolationFraction;
}
