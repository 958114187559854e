using System.Text.RegularExpressions;
using Markdig;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace FootballPhysics.Package.Tests;

/// <summary>A type or a member that a page names in back quotes exists.</summary>
public sealed partial class NameTests
{
    private static readonly MarkdownPipeline s_pipeline = new MarkdownPipelineBuilder().UsePipeTables().Build();

    /// <summary>Names of other libraries, engines and programs.</summary>
    private static readonly HashSet<string> s_foreign =
    [
        // .NET and its tools
        "CopyDocumentationFilesFromPackages", "IlcInstructionSet", "DOTNET_JitDisasmSummary", "VersionPrefix", "ProjectUrl", "PackageValidationBaselineVersion",
        // Unreal, Rust, Python, JavaScript
        "ThirdParty", "PublicIncludePaths", "PublicDelayLoadDLLs", "football_physics.dll", "FPlatformProcess", "PublicAdditionalLibraries", "RuntimeDependencies", "Sync", "ValueError", "PhysicsError",
        // kloppy
        "TrackingDataset",
        // Netcode, Quantum, netfox
        "FastBufferWriter", "WriteValueSafe", "WriteBytesSafe", "SendNamedMessageToAll", "NetworkManager", "DeterministicCommand", "RollbackSynchronizer",
        // the Reynolds number
        "Re",
    ];

    private static readonly Dictionary<string, Type> s_runtime = typeof(object).Assembly.GetExportedTypes()
        .Where(type => type.Namespace == "System" && !type.IsNested && !type.IsGenericType).ToDictionary(type => type.Name);

    public static TheoryData<string> Pages => [.. Repository.Pages.Except(["docs/api.md"])];

    [Theory]
    [MemberData(nameof(Pages))]
    public void Every_name_in_back_quotes_exists(string page)
    {
        MarkdownDocument document = Markdown.Parse(Repository.Text(page), s_pipeline);
        HashSet<string> programs = [.. document.Descendants<CodeBlock>().SelectMany(block => Word().Matches(block.Lines.ToString()).Select(word => word.Value))];
        string[] unknown = [.. document.Descendants<CodeInline>().Select(code => code.Content).Where(code => !programs.Contains(code) && !Exists(code)).Distinct()];
        Assert.True(unknown.Length == 0, $"{page} names members that do not exist: {string.Join(", ", unknown)}");
    }

    [Theory]
    [InlineData("Ball.Step", true)]
    [InlineData("Ball.Step(0.01)", true)]
    [InlineData("FlightStepper<TAir, TIntegrator>.Step", true)]
    [InlineData("BallEventKind.Pinned", true)]
    [InlineData("KinematicBody", true)]
    [InlineData("dotnet run", true)]
    [InlineData("air.wind", true)]
    [InlineData("Math.Pow", true)]
    [InlineData("Math.Power", false)]
    [InlineData("EventBuffer.Missed", false)]
    [InlineData("IFusedKernel", false)]
    [InlineData("SpunAir", false)]
    [InlineData("Simulator.Stepp(0.01)", false)]
    public void A_wrong_name_is_found(string code, bool exists) => Assert.Equal(exists, Exists(code));

    /// <summary>True also for text that is not the name of a type or of a member.</summary>
    private static bool Exists(string code)
    {
        Match match = Name().Match(Generic().Replace(code, ""));
        string[] parts = match.Groups[1].Value.Split('.');
        if (!match.Success || s_foreign.Contains(parts[0]) || parts[0] is "Football" or "FootballPhysics")
        {
            return true;
        }

        if (s_runtime.TryGetValue(parts[0], out Type? type))
        {
            return parts.Length == 1 || type.GetMember(parts[1]).Length > 0;
        }

        DeclaredNames names = DeclaredNames.OfRepository;
        return parts.Length == 1 || !names.IsType(parts[0]) ? parts.All(names.IsDeclared) : names.HasMember(parts[0], parts[1]);
    }

    /// <summary>Words that begin with a capital and have a small letter, joined by dots, with or without a call.</summary>
    [GeneratedRegex(@"^((?=[A-Z]\w*[a-z])[A-Z]\w+(?:\.[A-Z]\w+)*)(?:\(.*\))?$")]
    private static partial Regex Name();

    [GeneratedRegex(@"\w+")]
    private static partial Regex Word();

    [GeneratedRegex("<[^<>]*>")]
    private static partial Regex Generic();
}
