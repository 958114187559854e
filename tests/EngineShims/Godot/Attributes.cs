namespace Godot;

[AttributeUsage(AttributeTargets.Class)]
public sealed class ToolAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class GlobalClassAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Property | AttributeTargets.Field)]
public sealed class ExportAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Delegate)]
public sealed class SignalAttribute : Attribute
{
}
