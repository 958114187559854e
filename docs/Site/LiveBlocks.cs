using FootballPhysics.Site.Live;
using Markdig.Renderers.Html;
using Markdig.Syntax;

namespace FootballPhysics.Site;

/// <summary>Puts the live examples into their pages, and the reason below each recipe that has none.</summary>
internal static class LiveBlocks
{
    /// <summary>The pages whose recipes either run or state the reason.</summary>
    public static IReadOnlyList<string> Pages { get; } = ["cookbook.html", "prediction.html", "aiming.html"];

    /// <summary>The types in a program that a page cannot run, and the reason. The first that applies is shown.</summary>
    private static readonly (string[] Types, string Reason)[] s_reasons =
    [
        (["KinematicBodies", "KinematicBody", "KeeperDive", "BallScene"], "the program moves bodies between the steps"),
        (["BallGroup"], "the npm package simulates one ball at a time"),
        (["FixedStepRunner", "Rollback", "Snapshot", "TrajectoryCache", "LookAheadRun", "Recording", "PlaceInput"], "the program is about the steps of a game and not about one path"),
        (["PassFan", "GoalChance", "KickSpread", "Interception", "Foot", "Touches", "BankShotAimer", "LaunchDerivatives", "Player"], "the npm package does not have the query of this program"),
        (["IWind", "IForce", "ISurfacePattern", "ScaledAir"], "the program contains a force, a wind or a surface of its own"),
    ];

    /// <summary>Inserts the examples of a page after the first paragraph of their section.</summary>
    public static void Insert(MarkdownDocument document, string file)
    {
        foreach (LiveExample example in LiveExample.All.Where(example => example.Page == file))
        {
            int at = 0;
            while (at < document.Count && !(document[at] is HeadingBlock heading && (example.Section.Length == 0 || heading.GetAttributes().Id == example.Section)))
            {
                at++;
            }

            if (at == document.Count)
            {
                throw new InvalidOperationException($"live.json: the example {example.Id} is in section {example.Section}, and {file} has no such heading.");
            }

            at++;
            // A paragraph that ends with a colon belongs to the program below it.
            at += at < document.Count && document[at] is ParagraphBlock words && !SitePage.Words(words).EndsWith(':') ? 1 : 0;
            document.Insert(at, LanguageTabs.Raw(LiveFigure.Html(example)));
        }

        if (Pages.Contains(file))
        {
            AddReasons(document, [.. LiveExample.All.Where(example => example.Page == file).Select(example => example.Section)]);
        }
    }

    /// <summary>The reason for which the programs of a section do not run in a page.</summary>
    public static string Reason(string code)
    {
        HashSet<string> words = [.. code.Split([.. code.Where(letter => !char.IsLetterOrDigit(letter)).Distinct()], StringSplitOptions.RemoveEmptyEntries)];
        return s_reasons.FirstOrDefault(reason => reason.Types.Any(words.Contains)).Reason ?? "no number of this program is worth a slider";
    }

    private static void AddReasons(MarkdownDocument document, string[] live)
    {
        int end = document.Count;
        string code = "";
        bool isProgram = false;
        for (int i = document.Count - 1; i >= 0; i--)
        {
            if (document[i] is HeadingBlock heading)
            {
                if (isProgram && !live.Contains(heading.GetAttributes().Id!))
                {
                    document.Insert(end, LanguageTabs.Raw($"<p class=\"still\">Not live: {Reason(code)}.</p>"));
                }

                (end, code, isProgram) = (i, "", false);
            }
            else
            {
                code += " " + SitePage.Code(document[i]);
                isProgram |= document[i] is FencedCodeBlock { Info: "csharp" };
            }
        }
    }
}
