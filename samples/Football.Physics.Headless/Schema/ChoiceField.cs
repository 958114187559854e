using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>One of a few words.</summary>
internal sealed class ChoiceField<T>(string path, T defaultValue, params (string Word, T Value)[] choices)
    : Field<T>(path, string.Join(" | ", choices.Select(choice => choice.Word)), defaultValue)
    where T : struct, Enum
{
    protected override T Parse(JsonValue value)
    {
        if (value.Kind == JsonKind.String)
        {
            foreach ((string word, T chosen) in choices)
            {
                if (word == value.Text)
                {
                    return chosen;
                }
            }
        }

        throw Refuse(value);
    }
}
