using System.Reflection;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace FootballPhysics.Site.Live;

/// <summary>A slider of a live example.</summary>
/// <param name="Path">The number in the example that it sets, such as "scene.air.wind.0".</param>
/// <param name="Name">Its name on the page.</param>
/// <param name="Unit">The unit of its value.</param>
/// <param name="Min">The smallest value.</param>
/// <param name="Max">The largest value.</param>
/// <param name="Step">The distance between values.</param>
/// <param name="Divide">The number of its units in a unit of the library.</param>
internal sealed record LiveSlider(string Path, string Name, string Unit, double Min, double Max, double Step, double Divide);

/// <summary>An example that a page runs through the npm package: a scene, a kick or an aim, and sliders.</summary>
internal sealed class LiveExample
{
    private readonly JsonObject _description;

    private LiveExample(JsonObject description)
    {
        _description = description;
        Id = Word("id");
        Page = Word("page") + ".html";
        Section = Word("section");
        Name = Word("name");
        Sliders =
        [
            .. description["sliders"]!.AsArray().Select(slider => new LiveSlider(
                slider!["path"]!.GetValue<string>(), slider["name"]!.GetValue<string>(), slider["unit"]!.GetValue<string>(),
                slider["min"]!.GetValue<double>(), slider["max"]!.GetValue<double>(), slider["step"]!.GetValue<double>(), slider["divide"]?.GetValue<double>() ?? 1)),
        ];
    }

    /// <summary>All examples, in the order of their file.</summary>
    public static IReadOnlyList<LiveExample> All { get; } = Read();

    public string Id { get; }

    /// <summary>The page of the site that shows it.</summary>
    public string Page { get; }

    /// <summary>The anchor of the heading above it; empty for the first page.</summary>
    public string Section { get; }

    public string Name { get; }

    public IReadOnlyList<LiveSlider> Sliders { get; }

    /// <summary>The description as JSON, as the page runs it.</summary>
    public string Json => _description.ToJsonString();

    /// <summary>The description with one slider at a value; the others stay at their defaults.</summary>
    public JsonObject With(LiveSlider slider, double value)
    {
        var changed = (JsonObject)_description.DeepClone();
        string[] path = slider.Path.Split('.');
        JsonNode at = changed;
        foreach (string name in path[..^1])
        {
            at = (at is JsonArray list ? list[int.Parse(name)] : at[name])!;
        }

        JsonNode number = JsonValue.Create(value / slider.Divide);
        if (at is JsonArray numbers)
        {
            numbers[int.Parse(path[^1])] = number;
        }
        else
        {
            at[path[^1]] = number;
        }

        return changed;
    }

    /// <summary>The description with all sliders at their defaults.</summary>
    public JsonObject Default() => (JsonObject)_description.DeepClone();

    private string Word(string name) => _description[name]!.GetValue<string>();

    private static LiveExample[] Read()
    {
        using Stream text = Assembly.GetExecutingAssembly().GetManifestResourceStream("live.json")!;
        return [.. JsonNode.Parse(text, documentOptions: new JsonDocumentOptions { CommentHandling = JsonCommentHandling.Skip })!.AsArray().Select(item => new LiveExample((JsonObject)item!.DeepClone()))];
    }
}
