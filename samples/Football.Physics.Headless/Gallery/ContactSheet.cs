using System.Text;
using System.Xml.Linq;

namespace Football.Physics.Headless.Gallery;

/// <summary>All shots on one page that needs nothing but itself.</summary>
internal static class ContactSheet
{
    private const string Style = """
        body { font: 15px/1.45 system-ui, 'Segoe UI', Helvetica, Arial, sans-serif; color: #1f2933; background: #f5f7fa; margin: 0 auto; max-width: 1380px; padding: 24px; }
        h1 { font-size: 26px; margin: 0 0 4px; }
        .scroll { overflow-x: auto; }
        table { border-collapse: collapse; background: #fff; margin: 16px 0 24px; font-variant-numeric: tabular-nums; }
        th, td { padding: 5px 14px; text-align: right; border-bottom: 1px solid #e4e7eb; white-space: nowrap; }
        th:first-child, td:first-child { text-align: left; }
        th { font-weight: 600; background: #e4e7eb; }
        a { color: #0072b2; text-decoration: none; }
        .shots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 620px), 1fr)); gap: 20px; }
        article { background: #fff; border-radius: 8px; padding: 12px 14px; box-shadow: 0 1px 3px #0002; }
        article p { margin: 0 0 6px; }
        svg { max-width: 100%; height: auto; display: block; }
        article svg { width: 100%; }
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
                new XElement("style", Style)),
            new XElement(
                "body",
                new XElement("h1", "Football.Physics: gallery"),
                new XElement("p", "Every shot is played to rest with RK4 at 10 ms. Carry, hang time and deflection are those of the first touchdown; the deflection is to the left of the launch direction, negative to the right. Heights are of the ball's centre."),
                new XElement("div", new XAttribute("class", "scroll"), Table(shots)),
                new XElement("div", new XAttribute("class", "shots"), shots.Select(Card))));
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

    private static XElement Card(ShownShot shown) => new(
        "article",
        new XAttribute("id", shown.Shot.Id),
        new XElement(shown.Drawing),
        new XElement("p", $"{shown.Shot.About} {shown.Remark.Trim()}".TrimEnd()));
}
