using System.Globalization;
using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Input;

/// <summary>One object of the input, bare or as {"name", "scenario"}, with its overrides; its fields are not yet checked.</summary>
internal sealed class InputCase
{
    /// <summary>Bytes that one object may have: far more than a scenario can need, far less than would hurt.</summary>
    public const int LongestInput = 1 << 20;

    private const string ScenarioMember = "scenario";
    private const string NameMember = "name";

    private InputCase(string? name, JsonValue? scenario, RefusedException? refusal)
    {
        Name = name;
        Scenario = scenario;
        Refusal = refusal;
    }

    /// <summary>The name, where there is one; a refused input may have one too.</summary>
    public string? Name { get; }

    /// <summary>The scenario; null where the input was refused.</summary>
    public JsonValue? Scenario { get; }

    /// <summary>Why there is no scenario.</summary>
    public RefusedException? Refusal { get; }

    /// <summary>Reads the object.</summary>
    /// <param name="text">Its text, at most its first <see cref="LongestInput"/> bytes.</param>
    /// <param name="length">How long it was.</param>
    /// <param name="fields">The fields it may have, for messages.</param>
    /// <param name="overrides">Values to put in before anything is checked.</param>
    public static InputCase Read(ReadOnlySpan<byte> text, long length, FieldSet fields, IReadOnlyList<FieldOverride> overrides)
    {
        JsonValue root;
        try
        {
            root = JsonLoader.Load(text);
        }
        catch (JsonFaultException fault)
        {
            return new InputCase(NameOf(fault.Root), null, length > text.Length ? TooLong(length) : Explain(fault, fields));
        }

        if (length > text.Length)
        {
            return new InputCase(NameOf(root), null, TooLong(length));
        }

        try
        {
            (string? name, JsonValue scenario) = Unwrap(root, fields);
            foreach (FieldOverride item in overrides)
            {
                item.Apply(scenario);
            }

            return new InputCase(name, scenario, null);
        }
        catch (RefusedException refusal)
        {
            return new InputCase(NameOf(root), null, refusal);
        }
    }

    private static (string? Name, JsonValue Scenario) Unwrap(JsonValue root, FieldSet fields)
    {
        if (root.Kind != JsonKind.Object)
        {
            throw new RefusedException("the input", root.ToString(), "an object: a scenario, or {\"name\", \"scenario\"}");
        }

        bool named = root.Find(NameMember) is not null;
        bool bare = root.Find(ScenarioMember) is null && !(named && !root.Members.Exists(member => fields.HasRootMember(member.Name)));
        if (bare)
        {
            return (null, root);
        }

        foreach (string once in (string[])[NameMember, ScenarioMember])
        {
            if (root.Members.Count(member => member.Name == once) > 1)
            {
                throw new RefusedException(once, "given twice", "once");
            }
        }

        JsonValue? name = root.Find(NameMember);
        if (name is not null && name.Kind is not (JsonKind.String or JsonKind.Null))
        {
            throw new RefusedException(NameMember, name.ToString(), "a string");
        }

        JsonValue scenario = root.Find(ScenarioMember) ?? throw new RefusedException(ScenarioMember, "missing", "an object beside \"name\"");
        return (NameOf(root), scenario);
    }

    private static string? NameOf(JsonValue? root) => root?.Find(NameMember) is { Kind: JsonKind.String } name ? name.Text : null;

    private static RefusedException TooLong(long length) => new(
        "the input", string.Create(CultureInfo.InvariantCulture, $"{length} bytes long"), string.Create(CultureInfo.InvariantCulture, $"at most {LongestInput} bytes an object"));

    private static RefusedException Explain(JsonFaultException fault, FieldSet fields)
    {
        string path = fault.Path.StartsWith(ScenarioMember + ".", StringComparison.Ordinal) ? fault.Path[(ScenarioMember.Length + 1)..] : fault.Path;
        string field = path.Length > 0 ? path : "the input";
        string allowed = path.Length > 0 ? fields.Allowed(path) ?? "JSON" : $"a JSON object {fields.Allowed(path)}";
        string at = fault.Position.ToString(CultureInfo.InvariantCulture);
        return fault.Fault switch
        {
            JsonFault.Empty => new RefusedException("the input", "empty", "a JSON object"),
            JsonFault.CutOff => new RefusedException(field, $"cut off: the JSON ends too early, after byte {fault.Position - 1}", allowed),
            JsonFault.NotFinite => new RefusedException(field, fault.Token, allowed),
            JsonFault.MoreFollows => new RefusedException("the input", $"more than one value ({fault.Token} at byte {at})", "one JSON object; one a line with --batch"),
            JsonFault.TooDeep => new RefusedException(field, $"nested too deep (byte {at})", allowed),
            _ => new RefusedException(field, $"not JSON at byte {at} ({fault.Token})", allowed),
        };
    }
}
