namespace System.Text.Json.Serialization;

/// <summary>Stands in for the attribute of newer targets, which have a JSON serializer of their own.</summary>
[AttributeUsage(AttributeTargets.Property | AttributeTargets.Field)]
internal sealed class JsonIgnoreAttribute : Attribute;
