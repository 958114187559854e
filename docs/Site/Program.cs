using System.Reflection;
using FootballPhysics.Site;

string root = typeof(SiteWriter).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().First(item => item.Key == "Repository").Value!;
string folder = args.Length == 1 ? args[0] : Path.Combine("out", "site");
IReadOnlyList<string> pages = SiteWriter.Write(Path.GetFullPath(root), folder);
Console.WriteLine($"{pages.Count} pages: {Path.Combine(folder, pages[0])}");
