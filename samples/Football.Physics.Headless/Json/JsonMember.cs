namespace Football.Physics.Headless.Json;

/// <summary>A named value of an object.</summary>
internal readonly record struct JsonMember(string Name, JsonValue Value);
