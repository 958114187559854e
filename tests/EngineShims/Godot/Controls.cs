namespace Godot;

public class Control : Node
{
    public Vector2 Position { get; set; }

    public Vector2 Size { get; set; } = new(200, 40);

    public Vector2 CustomMinimumSize { get; set; }

    /// <summary>What was drawn since the last time.</summary>
    public List<Vector2[]> Drawn { get; } = [];

    public virtual void _Draw()
    {
    }

    /// <summary>In the shim at once.</summary>
    public void QueueRedraw()
    {
        Drawn.Clear();
        _Draw();
    }

    public void DrawPolyline(Vector2[] points, Color color, float width = -1, bool antialiased = false) => Drawn.Add(points);
}

public class VBoxContainer : Control
{
}

public class Label : Control
{
    public string Text { get; set; } = "";

    public TextServer.AutowrapMode AutowrapMode { get; set; }
}

public static class TextServer
{
    public enum AutowrapMode
    {
        Off,
        Arbitrary,
        Word,
        WordSmart,
    }
}

public class Button : Control
{
    public event Action? Pressed;

    public string Text { get; set; } = "";

    /// <summary>A click.</summary>
    public void Click() => Pressed?.Invoke();
}

public class HSlider : Control
{
    private double _value;

    public event Action<double>? ValueChanged;

    public double MinValue { get; set; }

    public double MaxValue { get; set; } = 100;

    public double Step { get; set; } = 0.01;

    public double Value
    {
        get => _value;
        set
        {
            if (value != _value)
            {
                _value = value;
                ValueChanged?.Invoke(value);
            }
        }
    }
}

public class EditorFileDialog : Node
{
    public enum FileModeEnum
    {
        OpenFile,
    }

    public enum AccessEnum
    {
        Resources,
        Userdata,
        Filesystem,
    }

    public event Action<string>? FileSelected;

    public FileModeEnum FileMode { get; set; }

    public AccessEnum Access { get; set; }

    /// <summary>The file that a test chooses at once; empty for none.</summary>
    public static string Chosen { get; set; } = "";

    public void PopupCenteredRatio(float ratio = 0.8f)
    {
        if (Chosen.Length > 0)
        {
            FileSelected?.Invoke(Chosen);
        }
    }
}

public static class FileAccess
{
    public static byte[] GetFileAsBytes(string path) => File.ReadAllBytes(path);
}

public static class ProjectSettings
{
    /// <summary>Where res:// is.</summary>
    public static string Root { get; set; } = "";

    /// <summary>In the shim the default of the gravity alone.</summary>
    public static Variant GetSetting(string name) => name == "physics/3d/default_gravity" ? 9.8 : throw new ArgumentException(name, nameof(name));

    public static string GlobalizePath(string path) => path.Replace("res://", Root, StringComparison.Ordinal);
}

public class EditorInspectorPlugin : Resource
{
    /// <summary>What was added.</summary>
    public List<Control> Added { get; } = [];

    public virtual bool _CanHandle(GodotObject @object) => false;

    public virtual void _ParseBegin(GodotObject @object)
    {
    }

    public void AddCustomControl(Control control) => Added.Add(control);
}

/// <summary>From Godot 4.6 on.</summary>
public class EditorDock : Control
{
    public enum DockSlot
    {
        None = -1,
        LeftUl,
        LeftBl,
        LeftUr,
        LeftBr,
        RightUl,
        RightBl,
        RightUr,
        RightBr,
        Bottom,
    }

    public string Title { get; set; } = "";

    public DockSlot DefaultSlot { get; set; } = DockSlot.None;
}

public class EditorPlugin : Node
{
    public enum DockSlot
    {
        LeftUl,
        LeftBl,
        LeftUr,
        LeftBr,
        RightUl,
        RightBl,
        RightUr,
        RightBr,
    }

    /// <summary>What is docked.</summary>
    public List<Control> Docked { get; } = [];

    /// <summary>What is asked when something is inspected.</summary>
    public List<EditorInspectorPlugin> Inspectors { get; } = [];

    /// <summary>From Godot 4.6 on.</summary>
    public void AddDock(EditorDock? dock) => Docked.Add(dock!);

    /// <summary>From Godot 4.6 on.</summary>
    public void RemoveDock(EditorDock? dock) => Docked.Remove(dock!);

    /// <summary>Before Godot 4.6.</summary>
    public void AddControlToDock(DockSlot slot, Control? control) => Docked.Add(control!);

    /// <summary>Before Godot 4.6.</summary>
    public void RemoveControlFromDocks(Control? control) => Docked.Remove(control!);

    public void AddInspectorPlugin(EditorInspectorPlugin? plugin) => Inspectors.Add(plugin!);

    public void RemoveInspectorPlugin(EditorInspectorPlugin? plugin) => Inspectors.Remove(plugin!);
}
