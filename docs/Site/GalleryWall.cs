using System.Net;
using System.Xml.Linq;
using FootballPhysics.Tool.Gallery;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Site;

/// <summary>The gallery of the site: a wall of thumbnails that move, each of which opens its shot in the page that plays all shots.</summary>
internal static class GalleryWall
{
    /// <summary>The name of the page.</summary>
    public const string File = "gallery.html";

    private const string Folder = "gallery";

    private const string Moving = Folder + "/replay.html";

    /// <summary>The page as Markdown.</summary>
    public static string Text { get; } = "# Gallery\n\nEach picture is computed by the library. Click one to see it from all sides.\n\n<div class=\"wall\">\n" + string.Concat(GalleryShots.All.Select(shot =>
        $"<a href=\"{Moving}#picture={shot.Id}\"><img src=\"{Folder}/{shot.Id}.svg\" alt=\"{WebUtility.HtmlEncode(shot.About)}\" loading=\"lazy\" width=\"480\" height=\"300\"><span>{WebUtility.HtmlEncode(shot.Name)}</span></a>\n")) + "</div>\n";

    /// <summary>Simulates the shots, and writes their pictures and the page that plays them.</summary>
    /// <param name="folder">The folder of the site.</param>
    public static void Write(string folder)
    {
        Directory.CreateDirectory(Path.Combine(folder, Folder));
        ShownShot[] shown = [.. GalleryShots.All.Select(ShownShot.Make)];
        foreach (ShownShot shot in shown)
        {
            System.IO.File.WriteAllText(Path.Combine(folder, Folder, shot.Shot.Id + ".svg"), MovingDrawing.Draw(shot.Moving).ToString(SaveOptions.DisableFormatting));
        }

        System.IO.File.WriteAllText(Path.Combine(folder, Moving), ReplayPage.Html("Football.Physics: gallery", [.. shown.Select(shot => shot.Moving)]));
    }
}
