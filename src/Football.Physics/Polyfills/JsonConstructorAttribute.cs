namespace System.Text.Json.Serialization;

/// <summary>Replaces the attribute of newer targets, which include a JSON serializer.</summary>
[AttributeUsage(AttributeTargets.Constructor)]
internal sealed class JsonConstructorAttribute : Attribute;
