namespace System.Text.Json.Serialization;

/// <summary>Stands in for the attribute of newer targets, which have a JSON serializer of their own.</summary>
[AttributeUsage(AttributeTargets.Constructor)]
internal sealed class JsonConstructorAttribute : Attribute;
