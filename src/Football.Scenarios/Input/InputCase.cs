using System.Globalization;
using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>One object of the input, bare or as {"name", "scenario"}, with its overrides; its fields are not yet checked.</summary>
/// <param name="Name">The name; null if not given. A rejected input may have a name too.</param>
/// <param name="Scenario">The scenario's fields; null if the input was rejected.</param>
/// <param name="Refusal">The error; null if the input was accepted.</param>
public sealed record InputCase(string? Name, InputFields? Scenario, RefusedException? Refusal)
{
    private const string ScenarioMember = "scenario";
    private const string NameMember = "name";

    /// <summary>Reads an object.</summary>
    /// <param name="line">The text of the object.</param>
    /// <param name="overrides">The values to set before the check.</param>
    public static InputCase Read(InputLine line, IReadOnlyList<FieldOverride> overrides)
    {
        JsonFault? fault = JsonText.Parse(line.Text, out JsonElement root);
        string? name = fault is null ? NameOf(root) : fault.Name;
        try
        {
            if (line.IsCut)
            {
                throw new RefusedException(
                    "the input", "too long", string.Create(CultureInfo.InvariantCulture, $"at most {LineReader.LongestInput} bytes an object"));
            }

            return fault is null
                ? new InputCase(name, new InputFields(FieldOverride.Apply(Unwrapped(root), overrides)), null)
                : throw new RefusedException(FieldOf(fault), fault.Value, fault.Expected);
        }
        catch (RefusedException refusal)
        {
            return new InputCase(name, null, refusal);
        }
    }

    private static string FieldOf(JsonFault fault)
    {
        string path = fault.Path.StartsWith(ScenarioMember + ".", StringComparison.Ordinal) ? fault.Path[(ScenarioMember.Length + 1)..] : fault.Path;
        return path.Length > 0 ? path : "the input";
    }

    private static string? NameOf(JsonElement root) =>
        root.ValueKind == JsonValueKind.Object && root.TryGetProperty(NameMember, out JsonElement name) && name.ValueKind == JsonValueKind.String
            ? name.GetString()
            : null;

    private static JsonElement Unwrapped(JsonElement root)
    {
        if (root.ValueKind != JsonValueKind.Object)
        {
            throw new RefusedException("the input", Quote.Short(root.GetRawText()), "an object: a scenario, or {\"name\", \"scenario\"}");
        }

        bool named = root.TryGetProperty(NameMember, out JsonElement name);
        if (root.TryGetProperty(ScenarioMember, out JsonElement scenario))
        {
            return !named || name.ValueKind is JsonValueKind.String or JsonValueKind.Null
                ? scenario
                : throw new RefusedException(NameMember, Quote.Short(name.GetRawText()), "a string");
        }

        return named ? throw new RefusedException(ScenarioMember, "missing", "an object next to \"name\"") : root;
    }
}
