using System.Reflection;
using System.Xml.Linq;
using FootballPhysics.Site;
using FootballPhysics.Site.Pictures;

string root = Path.GetFullPath(typeof(SiteWriter).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().First(item => item.Key == "Repository").Value!);
switch (args)
{
    case ["--table"]:
        Console.Write(PageTable.Of(root));
        break;
    case ["--pictures"]:
        foreach ((string name, Func<XElement> draw) in DocPictures.All)
        {
            File.WriteAllText(Path.Combine(root, DocPictures.Folder, name + ".svg"), draw().ToString(SaveOptions.DisableFormatting));
        }

        Console.WriteLine($"{DocPictures.All.Count} pictures: {DocPictures.Folder}");
        break;
    default:
        string folder = args.Length == 1 ? args[0] : Path.Combine("out", "site");
        IReadOnlyList<string> pages = SiteWriter.Write(root, folder);
        Console.WriteLine($"{pages.Count} pages: {Path.Combine(folder, pages[0])}");
        break;
}
