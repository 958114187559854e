namespace System.Text.Json.Serialization;

/// <summary>Replaces the attribute of newer targets, which include a JSON serializer.</summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct)]
internal sealed class JsonNumberHandlingAttribute : Attribute
{
    public JsonNumberHandlingAttribute(JsonNumberHandling handling) => Handling = handling;

    public JsonNumberHandling Handling { get; }
}
