using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>true or false.</summary>
internal sealed class FlagField(string path, bool defaultValue) : Field<bool>(path, "true | false", defaultValue)
{
    protected override bool Parse(JsonValue value) => value.Kind == JsonKind.Boolean ? value.Text == "true" : throw Refuse(value);
}
