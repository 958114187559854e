using System.Reflection;

namespace FootballPhysics.Tool;

/// <summary>The page to play with: the library itself as WebAssembly, in one file that opens from disk.</summary>
public static class Playground
{
    /// <summary>Its name where it is written beside other pages.</summary>
    public const string File = "play.html";

    /// <summary>The page.</summary>
    public static string Html
    {
        get
        {
            using Stream page = Assembly.GetExecutingAssembly().GetManifestResourceStream("Playground.html")!;
            return new StreamReader(page).ReadToEnd();
        }
    }
}
