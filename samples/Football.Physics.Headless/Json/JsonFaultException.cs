namespace Football.Physics.Headless.Json;

/// <summary>A text is not JSON: what is wrong, at which field, with what text.</summary>
internal sealed class JsonFaultException(JsonFault fault, string path, string token, int position, JsonValue? root) : Exception
{
    public JsonFault Fault { get; } = fault;

    /// <summary>The field at which it happened, empty for the whole.</summary>
    public string Path { get; } = path;

    /// <summary>What stands there, on one short line.</summary>
    public string Token { get; } = token;

    /// <summary>Byte at which it happened, from 1.</summary>
    public int Position { get; } = position;

    /// <summary>As much as was read; null where nothing was.</summary>
    public JsonValue? Root { get; } = root;
}
