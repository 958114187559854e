using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>A page with all shots. It needs no other file except the animated page next to it.</summary>
internal static class ContactSheet
{
    /// <summary>The animated page with the same shots.</summary>
    public const string Moving = "replay.html";

    private const string Style = """
        :root { --ink: #1f2933; --faint: #5b6773; --page: #f5f7fa; --card: #ffffff; --edge: #e4e7eb; --link: #0072b2; }
        @media (prefers-color-scheme: dark) {
          :root { --ink: #e4e7eb; --faint: #a3b0bd; --page: #0f1418; --card: #171d23; --edge: #2b3640; --link: #56b4e9; color-scheme: dark; }
        }
        * { box-sizing: border-box; }
        body { font: 15px/1.45 system-ui, 'Segoe UI', Helvetica, Arial, sans-serif; color: var(--ink); background: var(--page); margin: 0 auto; max-width: 1460px; padding: 24px; }
        h1 { font-size: 26px; margin: 0 0 4px; }
        h2 { font-size: 18px; margin: 0 0 4px; }
        a { color: var(--link); }
        .scroll { overflow-x: auto; }
        table { border-collapse: collapse; background: var(--card); margin: 16px 0 24px; font-variant-numeric: tabular-nums; }
        th, td { padding: 5px 12px; text-align: right; border-bottom: 1px solid var(--edge); white-space: nowrap; }
        th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: var(--card); }
        th { font-weight: 600; }
        .shots { columns: 430px; column-gap: 18px; margin-top: 16px; }
        article { background: var(--card); border: 1px solid var(--edge); border-radius: 8px; padding: 12px 14px; margin-bottom: 18px; break-inside: avoid; }
        article p { margin: 0 0 8px; }
        .moving + p { margin-top: 8px; }
        .kick { color: var(--faint); font-size: 14px; }
        .first { display: flex; gap: 10px; flex-wrap: wrap; margin: 14px 0; }
        .big { background: #0b6e4f; color: #ffffff; font-weight: 700; font-size: 18px; padding: 12px 22px; border-radius: 10px; text-decoration: none; }
        .second { background: var(--card); color: var(--link); border: 1px solid var(--edge); }
        summary { cursor: pointer; color: var(--link); padding: 2px 0; }
        svg { width: 100%; height: auto; display: block; }
        pre span { white-space: nowrap; }
        pre { font: 12px/1.5 ui-monospace, Consolas, monospace; background: var(--page); border: 1px solid var(--edge); border-radius: 6px; margin: 6px 0; padding: 8px 64px 8px 10px; white-space: pre-wrap; }
        button { position: absolute; top: 5px; right: 5px; font: inherit; font-size: 12px; color: var(--ink); background: var(--card); border: 1px solid var(--edge); border-radius: 5px; padding: 3px 9px; cursor: pointer; }
        @media (max-width: 640px) { body { padding: 10px; } article { padding: 10px 8px; } article svg { width: calc(100% + 14px); margin: 0 -7px; } h1 { font-size: 22px; } th, td { padding: 4px 8px; } }
        """;

    /// <summary>Copies the text next to a button. The script contains no characters that XML and HTML escape differently.</summary>
    private const string Script = """
        document.addEventListener("click", function (e) {
          if (e.target.tagName !== "BUTTON") return;
          navigator.clipboard.writeText(e.target.previousSibling.textContent).then(function () { e.target.textContent = "copied"; });
        });
        """;

    public static string Html(IReadOnlyList<ShownShot> shots)
    {
        var page = new XElement(
            "html",
            new XAttribute("lang", "en"),
            new XElement(
                "head",
                new XElement("meta", new XAttribute("charset", "utf-8")),
                new XElement("meta", new XAttribute("name", "viewport"), new XAttribute("content", "width=device-width, initial-scale=1")),
                new XElement("title", "Football.Physics: gallery"),
                new XElement("style", Style, Svg.DarkStyle(".plots", Palette.Dark), Svg.DarkStyle(".moving", SceneSketch.Dark))),
            new XElement(
                "body",
                new XElement("h1", "Football.Physics: gallery"),
                new XElement(
                    "p",
                    new XAttribute("class", "first"),
                    new XElement("a", new XAttribute("class", "big"), new XAttribute("href", Playground.File), "Kick the ball yourself"),
                    new XElement("a", new XAttribute("class", "big second"), new XAttribute("href", Moving), "Watch all shots, from all sides")),
                new XElement(
                    "p",
                    "Each picture shows what the library computes, and its code prints the same events. ",
                    new XElement("a", new XAttribute("href", "#numbers"), "All in numbers"),
                    "."),
                new XElement("main", new XAttribute("class", "shots"), shots.Select(Card)),
                new XElement("h2", new XAttribute("id", "numbers"), "All in numbers"),
                new XElement("p", "Carry, hang time and deflection are those of the first touchdown; the deflection is to the left of the launch direction, negative to the right. Heights are of the ball's centre."),
                new XElement("div", new XAttribute("class", "scroll"), Table(shots)),
                new XElement("script", Script)));
        return new StringBuilder("<!DOCTYPE html>\n").Append(page.ToString(SaveOptions.DisableFormatting)).Append('\n').ToString();
    }

    private static XElement Table(IReadOnlyList<ShownShot> shots) => new(
        "table",
        new XElement("thead", new XElement("tr", new XElement("th", "shot"), ShotFigures.Columns.Select(column => new XElement("th", column)))),
        new XElement("tbody", shots.Select(Row)));

    private static XElement Row(ShownShot shown) => new(
        "tr",
        new XElement("td", new XElement("a", new XAttribute("href", "#" + shown.Shot.Id), shown.Shot.Name)),
        shown.Figures.Texts.Select(text => new XElement("td", text)));

    private static XElement Card(ShownShot shown)
    {
        var kick = KickNumbers.Of(shown.Shot.Scenario);
        return new XElement(
            "article",
            new XAttribute("id", shown.Shot.Id),
            new XElement("h2", shown.Shot.Name),
            new XElement(
                "p",
                new XAttribute("class", "kick"),
                kick.Text + ". ",
                new XElement("a", new XAttribute("href", $"{Moving}#picture={shown.Shot.Id}"), "Watch it move")),
            new XElement("a", new XAttribute("href", $"{Moving}#picture={shown.Shot.Id}"), new XAttribute("aria-label", "Watch it move"), new XAttribute("class", "moving"), Unstyled(MovingDrawing.Draw(shown.Moving))),
            new XElement("p", $"{shown.Shot.About} {shown.Remark.Trim()}".TrimEnd()),
            Folded("Plots", new XElement("div", new XAttribute("class", "plots"), Unstyled(new XElement(shown.Drawing)))),
            shown.Shot.Command is { } command ? Folded("Code and command", Copied(shown.Shot.Code), Copied(command)) : Folded("Code", Copied(shown.Shot.Code)));
    }

    /// <summary>Returns a drawing without its style element, which would apply to all drawings of the page.</summary>
    private static XElement Unstyled(XElement drawing)
    {
        drawing.Descendants().Where(part => part.Name.LocalName == "style").Remove();
        return drawing;
    }

    private static XElement Folded(string what, params XElement[] content) => new("details", new XElement("summary", what), content);

    private static XElement Copied(string code) => new(
        "div",
        new XAttribute("style", "position: relative"),
        new XElement("pre", Unbroken(code)),
        new XElement("button", new XAttribute("type", "button"), new XAttribute("aria-label", "Copy the line"), "copy"));

    /// <summary>Returns a code in which no line breaks within words.</summary>
    private static IEnumerable<object> Unbroken(string code) =>
        Regex.Split(code, @"(\s+)").Select((part, i) => i % 2 == 0 ? (object)new XElement("span", part) : part);
}
