using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace FootballPhysics.Tests.Architecture;

/// <summary>IntelliSense shows a summary by itself: it says what a member is, and does not go on from the one before it in the file.</summary>
public sealed partial class SummaryRuleTests
{
    private const int Most = 5;

    [Fact]
    public void Few_summaries_of_public_members_begin_as_an_answer_or_a_continuation()
    {
        Type[] parts = [typeof(Simulator), typeof(ThesisAimer), typeof(TrackFit)];
        string[] summaries =
        [
            .. from part in parts
               from summary in XDocument.Load(Path.ChangeExtension(part.Assembly.Location, ".xml")).Descendants("summary")
               select summary.Value.Trim(),
        ];
        Assert.InRange(summaries.Length, 500, 10_000);
        string[] found = [.. summaries.Where(summary => Opening().IsMatch(summary))];
        Assert.True(found.Length <= Most, string.Join("\n", found));
        Assert.DoesNotContain(found, summary => summary.StartsWith("And ", StringComparison.Ordinal));
    }

    [GeneratedRegex(@"^(What|Whether|And|The same)\b")]
    private static partial Regex Opening();
}
