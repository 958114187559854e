namespace Godot;

[AttributeUsage(AttributeTargets.Class)]
public sealed class ToolAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class GlobalClassAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class IconAttribute : Attribute
{
    public IconAttribute(string path) => Path = path;

    public string Path { get; }
}

public enum PropertyHint
{
    None,
    Range,
    Layers3DPhysics,
}

[AttributeUsage(AttributeTargets.Property | AttributeTargets.Field)]
public sealed class ExportAttribute : Attribute
{
    public ExportAttribute(PropertyHint hint = PropertyHint.None, string hintString = "")
    {
        Hint = hint;
        HintString = hintString;
    }

    public PropertyHint Hint { get; }

    public string HintString { get; }
}

[AttributeUsage(AttributeTargets.Delegate)]
public sealed class SignalAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Property | AttributeTargets.Field)]
public sealed class ExportGroupAttribute : Attribute
{
    public ExportGroupAttribute(string name, string prefix = "")
    {
        Name = name;
        Prefix = prefix;
    }

    public string Name { get; }

    public string Prefix { get; }
}
