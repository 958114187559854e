namespace System.Text.Json.Serialization;

/// <summary>Stands in for the attribute of newer targets, which have a JSON serializer of their own.</summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct)]
internal sealed class JsonNumberHandlingAttribute : Attribute
{
    public JsonNumberHandlingAttribute(JsonNumberHandling handling) => Handling = handling;

    public JsonNumberHandling Handling { get; }
}
