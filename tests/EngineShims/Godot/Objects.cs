namespace Godot;

public interface ISerializationListener
{
    void OnBeforeSerialize();

    void OnAfterDeserialize();
}

public class GodotObject
{
    /// <summary>What was emitted, in order.</summary>
    public List<(string Signal, Variant[] Arguments)> Emitted { get; } = [];

    /// <summary>What was set by name.</summary>
    public Dictionary<string, Variant> Properties { get; } = [];

    private static readonly List<GodotObject> s_all = [];

    public GodotObject()
    {
        lock (s_all)
        {
            s_all.Add(this);
            Id = (ulong)s_all.Count;
        }
    }

    private ulong Id { get; }

    private readonly Dictionary<string, Variant> _meta = [];

    /// <summary>True once it was freed.</summary>
    public bool IsFreed { get; protected set; }

    public ulong GetInstanceId() => Id;

    public static GodotObject? InstanceFromId(ulong id) => s_all[(int)id - 1];

    public static bool IsInstanceValid(GodotObject? instance) => instance is { IsFreed: false };

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
    public enum InternalMode
    {
        Disabled,
        Front,
        Back,
    }

    private readonly List<(Node Node, bool IsInternal)> _all = [];

    public StringName Name { get; set; } = "";

    private Node? _parent;
    private bool _ready;

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

    /// <summary>The root of the shim's only tree.</summary>
    public static Node Root { get; } = new Node { Name = "root" };

    public Node? GetParent() => _parent;

    public bool IsInsideTree() => this == Root || (_parent?.IsInsideTree() ?? false);

    public Collections.Array<Node> GetChildren(bool includeInternal = false) => [.. _all.Where(child => includeInternal || !child.IsInternal).Select(child => child.Node)];

    public void AddChild(Node node, bool forceReadableName = false, InternalMode @internal = InternalMode.Disabled)
    {
        if (node._parent is not null)
        {
            throw new InvalidOperationException("The node has a parent already.");
        }

        node._parent = this;
        _all.Add((node, @internal != InternalMode.Disabled));
        if (IsInsideTree())
        {
            node.Enter();
        }
    }

    public void RemoveChild(Node node)
    {
        if (IsInsideTree())
        {
            node.Exit();
        }

        _all.RemoveAll(child => child.Node == node);
        node._parent = null;
    }

    /// <summary>In the shim at once.</summary>
    public void QueueFree()
    {
        _parent?.RemoveChild(this);
        Free();
    }

    public Viewport GetViewport() => Viewport.Only;

    // The shim's tree has whatever node is asked for, ready.
    public T GetNode<T>(string path)
        where T : Node, new()
    {
        if (_all.Select(child => child.Node).FirstOrDefault(child => child.Name.ToString() == path) is T found)
        {
            return found;
        }

        var node = new T { Name = path };
        AddChild(node);
        if (!node._ready)
        {
            node.Ready();
        }

        return node;
    }

    /// <summary>Physics frames, and a frame after each, of all in the tree.</summary>
    public static void Play(int frames, double delta)
    {
        for (int i = 0; i < frames; i++)
        {
            Root.Visit(node => node._PhysicsProcess(delta));
            Root.Visit(node => node._Process(delta));
        }
    }

    private void Visit(Action<Node> what)
    {
        what(this);
        foreach ((Node child, bool _) in _all.ToArray())
        {
            child.Visit(what);
        }
    }

    private void Enter()
    {
        _EnterTree();
        foreach ((Node child, bool _) in _all.ToArray())
        {
            child.Enter();
        }

        if (!_ready)
        {
            Ready();
        }
    }

    private void Exit()
    {
        foreach ((Node child, bool _) in _all.ToArray())
        {
            child.Exit();
        }

        _ExitTree();
    }

    private void Ready()
    {
        _ready = true;
        _Ready();
    }

    private void Free()
    {
        IsFreed = true;
        foreach ((Node child, bool _) in _all)
        {
            child.Free();
        }
    }
}

public class Node3D : Node
{
    private Transform3D _global = Transform3D.Identity;

    public bool TopLevel { get; set; }

    public Transform3D Transform
    {
        get => _global;
        set => GlobalTransform = value;
    }

    /// <summary>In the shim a node stands where it is put, and does not follow its parent: but when its scene is loaded.</summary>
    public Transform3D GlobalTransform
    {
        get => _global;
        set => _global = value;
    }

    public World3D GetWorld3D() => World3D.Only;

    public Vector3 GlobalPosition
    {
        get => GlobalTransform.Origin;
        set => GlobalTransform = new Transform3D(GlobalTransform.Basis, value);
    }
}

public class CanvasLayer : Node
{
}

public class Viewport : Node
{
    public static Viewport Only { get; } = new();

    /// <summary>The camera that a test has.</summary>
    public Camera3D? Camera { get; set; }

    public Camera3D? GetCamera3D() => Camera;

    public Vector2 GetMousePosition() => default;
}

public class Resource : GodotObject
{
}

public static class Time
{
    /// <summary>What <see cref="GetTicksMsec"/> returns.</summary>
    public static ulong Ticks { get; set; }

    public static ulong GetTicksMsec() => Ticks;
}

public static class Engine
{
    public static int PhysicsTicksPerSecond { get; set; } = 60;

    public static double TimeScale { get; set; } = 1;

    /// <summary>What <see cref="GetPhysicsInterpolationFraction"/> says.</summary>
    public static double InterpolationFraction { get; set; }

    /// <summary>What <see cref="IsEditorHint"/> says.</summary>
    public static bool InEditor { get; set; }

    public static double GetPhysicsInterpolationFraction() => InterpolationFraction;

    public static bool IsEditorHint() => InEditor;
}

public static class GD
{
    /// <summary>Warnings and errors.</summary>
    public static List<string> Pushed { get; } = [];

    public static void PushWarning(string message) => Pushed.Add(message);

    public static void PushError(string message) => Pushed.Add(message);
}
