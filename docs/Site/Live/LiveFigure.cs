using System.Globalization;
using System.Net;
using System.Text;
using System.Text.Json;

namespace FootballPhysics.Site.Live;

/// <summary>A live example as HTML, with its recorded path and results. It needs no library before the first click.</summary>
internal static class LiveFigure
{
    private static readonly Dictionary<string, (string Words, string Unit)> s_names = new()
    {
        ["apex"] = ("greatest height", "m"),
        ["carry"] = ("first bounce after", "m"),
        ["hang"] = ("in the air", "s"),
        ["bend"] = ("to the left", "m"),
        ["speed"] = ("speed at the first bounce", "m/s"),
        ["rise"] = ("height after the bounce", "m"),
        ["bounces"] = ("bounces", ""),
        ["end"] = ("distance at the end", "m"),
        ["time"] = ("ends after", "s"),
        ["goal"] = ("goal", "s"),
        ["hits"] = ("hits", ""),
        ["status"] = ("status", ""),
        ["elevation"] = ("elevation", "°"),
        ["azimuth"] = ("azimuth", "°"),
        ["topSpin"] = ("topspin", "rad/s"),
        ["sideSpin"] = ("sidespin", "rad/s"),
        ["arrives"] = ("arrives after", "s"),
        ["saved"] = ("saved", ""),
        ["latest"] = ("dives by", "s"),
    };

    /// <summary>The figure of an example.</summary>
    public static string Html(LiveExample example)
    {
        var recorded = new LiveRun(example.Default());
        var html = new StringBuilder();
        html.Append($"<figure class=\"live\" id=\"live-{example.Id}\"><figcaption>{WebUtility.HtmlEncode(example.Name)}</figcaption>\n");
        html.Append($"<canvas role=\"img\" aria-label=\"The path of the ball: {WebUtility.HtmlEncode(example.Name)}\"></canvas>\n<div class=\"sliders\">\n");
        foreach (LiveSlider slider in example.Sliders)
        {
            double value = Math.Round(Value(example, slider), 6);
            html.Append(CultureInfo.InvariantCulture, $"<label>{WebUtility.HtmlEncode(slider.Name)} <output></output><input type=\"range\" min=\"{slider.Min}\" max=\"{slider.Max}\" step=\"{slider.Step}\" value=\"{value}\" data-unit=\"{slider.Unit}\" autocomplete=\"off\"></label>\n");
        }

        html.Append("</div>\n<dl>");
        foreach ((string name, object? shown) in recorded.Shown)
        {
            html.Append($"<div><dt>{s_names[name].Words}</dt><dd>{WebUtility.HtmlEncode(Text(name, shown))}</dd></div>");
        }

        html.Append("</dl>\n<p class=\"hint\">Recorded. Move a slider to compute it in this page.</p>\n");
        string rows = string.Join(',', recorded.Times.SelectMany((time, i) => (double[])[time, recorded.Points[i].X, recorded.Points[i].Y, recorded.Points[i].Z]).Select(number => Math.Round(number, 3).ToString(CultureInfo.InvariantCulture)));
        html.Append($"<script type=\"application/json\">{{\"example\":{example.Json.Replace("<", "\\u003c", StringComparison.Ordinal)},\"rows\":[{rows}]}}</script></figure>\n");
        return html.ToString();
    }

    /// <summary>The default of a slider, in its own unit.</summary>
    public static double Value(LiveExample example, LiveSlider slider)
    {
        using var document = JsonDocument.Parse(example.Json);
        JsonElement at = document.RootElement;
        foreach (string name in slider.Path.Split('.'))
        {
            at = at.ValueKind == JsonValueKind.Array ? at[int.Parse(name, CultureInfo.InvariantCulture)] : at.GetProperty(name);
        }

        return at.GetDouble() * slider.Divide;
    }

    private static string Text(string name, object? value) => value switch
    {
        null => "–",
        string words => words,
        double number when name == "bounces" => number.ToString("F0", CultureInfo.InvariantCulture),
        double number => string.Create(CultureInfo.InvariantCulture, $"{number:F2} {s_names[name].Unit}").Trim(),
        _ => throw new InvalidOperationException($"{name} is {value}."),
    };
}
