using System.Reflection;

namespace FootballPhysics.Tool;

/// <summary>The interactive page: the library as WebAssembly, in one file that opens from disk.</summary>
public static class Playground
{
    /// <summary>The name of the file next to other pages.</summary>
    public const string File = "play.html";

    /// <summary>The content of the page.</summary>
    public static string Html
    {
        get
        {
            using Stream page = Assembly.GetExecutingAssembly().GetManifestResourceStream("Playground.html")!;
            return new StreamReader(page).ReadToEnd();
        }
    }
}
