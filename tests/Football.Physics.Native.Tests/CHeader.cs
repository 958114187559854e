using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace FootballPhysics.Native.Tests;

/// <summary>Makes football_physics.h of the exports, their types and their documentation: C99, and C++.</summary>
internal sealed partial class CHeader
{
    private const int Width = 140;

    /// <summary>The enumerations of the library whose members C sees as numbers, and what theirs are called there.</summary>
    private static readonly (Type Type, string Name, string Prefix)[] s_numbers =
    [
        (typeof(MotionState), "fp_motion", "FP_MOTION_"),
        (typeof(BallEventKind), "fp_event_kind", "FP_EVENT_"),
        (typeof(StopAt), "fp_stop", "FP_STOP_"),
        (typeof(AimStatus), "fp_aim_status", "FP_AIM_"),
        (typeof(GoalChanceMethod), "fp_chance_method", "FP_CHANCE_"),
        (typeof(TrackVerdict), "fp_fit_verdict", "FP_FIT_"),
        (typeof(MatchPieceKind), "fp_piece_kind", "FP_PIECE_"),
        (typeof(NativeFitParameter), "fp_fit_parameter", "FP_PARAMETER_"),
        (typeof(MatchAnswers), "fp_match_answers", "FP_GOOD_FOR_"),
        (typeof(TrackSuspicions), "fp_track_suspicions", "FP_SUSPICION_"),
    ];

    private static readonly Type[] s_structs =
    [
        typeof(NativeBall), typeof(NativeEvent), typeof(NativeDerivatives), typeof(NativeBody), typeof(NativeMatchEvent), typeof(NativePlayer), typeof(NativeInterception), typeof(NativeWindow),
        typeof(NativeGoalChanceResult), typeof(NativeFitResult), typeof(NativePiece), typeof(NativeFitMatchResult), typeof(NativeImpactResult),
        typeof(NativeFilterSettings), typeof(NativeEstimate), typeof(NativeWatch), typeof(NativeForcesResult), typeof(NativeContactForce),
    ];

    private readonly StringBuilder _text = new();
    private readonly Dictionary<string, XElement> _documentation;

    private CHeader()
    {
        Assembly[] assemblies = [typeof(Exports).Assembly, typeof(Scene).Assembly, typeof(TrackFit).Assembly];
        _documentation = assemblies
            .SelectMany(assembly => XDocument.Load(Path.ChangeExtension(assembly.Location, ".xml")).Descendants("member"))
            .ToDictionary(member => member.Attribute("name")!.Value);
    }

    /// <summary>The exports, in the order of the source.</summary>
    public static IReadOnlyList<MethodInfo> Functions { get; } =
        [.. typeof(Exports).GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.DeclaredOnly).Where(method => NameOf(method) is not null).OrderBy(method => method.MetadataToken)];

    /// <summary>The name that C knows a method by; null where it does not.</summary>
    public static string? NameOf(MethodInfo method) => method.GetCustomAttribute<UnmanagedCallersOnlyAttribute>()?.EntryPoint;

    /// <summary>The whole header.</summary>
    public static string Make() => new CHeader().Write();

    private string Write()
    {
        Line("/* Football.Physics: the flight, bounce and roll of a football. Made of the exports by tests/regenerate.sh; not to be edited. */");
        Line("#ifndef FOOTBALL_PHYSICS_H");
        Line("#define FOOTBALL_PHYSICS_H");
        Line();
        Line("#include <stdint.h>");
        Line();
        Line("#if defined(_WIN32)");
        Line("#define FOOTBALL_API __declspec(dllimport)");
        Line("#else");
        Line("#define FOOTBALL_API");
        Line("#endif");
        Line();
        Line("#ifdef __cplusplus");
        Line("extern \"C\" {");
        Line("#endif");
        Line();
        Line($"#define FOOTBALL_ABI_VERSION {Exports.AbiVersion}");
        Line($"#define FOOTBALL_STATE_BYTES {NativeState.Size}");
        Line($"#define FOOTBALL_SNAPSHOT_BYTES {Snapshot.Size}");
        Line();
        Enumeration(typeof(NativeStatus), "fp_status", "FP_");
        foreach ((Type type, string name, string prefix) in s_numbers)
        {
            Enumeration(type, name, prefix);
        }

        Comment(Summary("T:" + typeof(NativeScene).FullName));
        Line("typedef struct fp_scene fp_scene;");
        Line();
        Comment(Summary("T:" + typeof(NativeMatch).FullName));
        Line("typedef struct fp_match fp_match;");
        Line();
        Comment(Summary("T:" + typeof(NativeFilter).FullName));
        Line("typedef struct fp_filter fp_filter;");
        Line();
        Comment(Summary("T:" + typeof(NativeState).FullName));
        Line("typedef struct { unsigned char bytes[FOOTBALL_STATE_BYTES]; } fp_state;");
        Line();
        foreach (Type type in s_structs)
        {
            Structure(type);
        }

        foreach (MethodInfo method in Functions)
        {
            Function(method);
        }

        // One line: readers without a preprocessor remove it as a whole.
        string[] structs = ["body", "match_event", "player", "interception", "window", "goal_chance_result", "fit_result", "piece", "fit_match_result", "impact_result", "filter_settings", "estimate", "forces_result", "contact_force"];
        Line("/** Checks that this header matches the library. Other languages call fp_check_sizes. */");
        Line("#define FOOTBALL_CHECK_ABI() (fp_check_abi(FOOTBALL_ABI_VERSION, (int32_t)sizeof(fp_state), (int32_t)sizeof(fp_ball), (int32_t)sizeof(fp_event)) != FP_OK ? (fp_status)FP_ABI : "
            + $"fp_check_structs({string.Join(", ", structs.Select(name => $"(int32_t)sizeof(fp_{name})"))}))");
        Line();
        Line("/* The former names of these macros, for one more version. <math.h> also begins names with FP_. */");
        Line("#define FP_ABI_VERSION FOOTBALL_ABI_VERSION");
        Line("#define FP_SNAPSHOT_BYTES FOOTBALL_SNAPSHOT_BYTES");
        Line("#define FP_CHECK_ABI() FOOTBALL_CHECK_ABI()");
        Line();
        Line("#ifdef __cplusplus");
        Line("}");
        Line("#endif");
        Line();
        Line("#endif");
        return _text.ToString();
    }

    /// <summary>C keeps the names of members that C# has renamed.</summary>
    private static string NameInC(Type type, string member) => (type.Name, member) switch
    {
        (nameof(BallEventKind), nameof(BallEventKind.ContactEnd)) => "Leave",
        (_, "Pinned") => "Squeezed",
        (nameof(MotionState), nameof(MotionState.Rest)) => "Stopped",
        (_, "WaypointMissed") => "TargetOnly",
        _ => member,
    };

    private void Enumeration(Type type, string name, string prefix)
    {
        // The negative member makes the type of the constants int in every language: int32_t, as that of the members and arguments that hold them.
        Comment(Summary("T:" + type.FullName));
        Line($"typedef int32_t {name};");
        Line("enum {");
        string[] members = Enum.GetNames(type);
        for (int i = 0; i < members.Length; i++)
        {
            Comment(Summary($"F:{type.FullName}.{members[i]}"), "    ");
            int value = Convert.ToInt32(Enum.Parse(type, members[i]), CultureInfo.InvariantCulture);
            Line($"    {prefix}{Snake(NameInC(type, members[i])).ToUpperInvariant()} = {value},");
        }

        Comment("Not used. It gives the constants the type int.", "    ");
        Line($"    {name.ToUpperInvariant()}_INT = -1");
        Line("};");
        Line();
    }

    private void Structure(Type type)
    {
        Comment(Summary("T:" + type.FullName));
        Line("typedef struct {");
        foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public).OrderBy(field => field.MetadataToken))
        {
            Comment(Summary($"F:{type.FullName}.{field.Name}"), "    ");
            FixedBufferAttribute? buffer = field.GetCustomAttribute<FixedBufferAttribute>();
            Line($"    {Scalar(buffer?.ElementType ?? field.FieldType)} {Snake(field.Name)}{(buffer is null ? "" : $"[{buffer.Length}]")};");
        }

        Line($"}} {Scalar(type)};");
        Line();
    }

    private void Function(MethodInfo method)
    {
        XElement documentation = _documentation.First(entry => entry.Key.StartsWith($"M:{typeof(Exports).FullName}.{method.Name}", StringComparison.Ordinal)
            && entry.Key[$"M:{typeof(Exports).FullName}.{method.Name}".Length..] is "" or ['(', ..]).Value;
        var lines = new List<string>(Wrap(Text(documentation.Element("summary")!), Width - 4));
        foreach (ParameterInfo parameter in method.GetParameters())
        {
            XElement? about = documentation.Elements("param").FirstOrDefault(element => element.Attribute("name")!.Value == parameter.Name);
            lines.AddRange(Wrap($"{Snake(parameter.Name!)}: {Text(about ?? throw new InvalidOperationException($"{method.Name}: {parameter.Name} is not documented."))}", Width - 6)
                .Select((line, i) => (i == 0 ? "" : "  ") + line));
        }

        lines.AddRange(Wrap("Returns " + Text(documentation.Element("returns")!), Width - 4));
        Comment(lines);
        string parameters = string.Join(", ", method.GetParameters().Select(Parameter));
        string returns = method.ReturnType == typeof(byte*) ? "const char*" : TypeName(method.ReturnType, isArray: false);
        Line($"FOOTBALL_API {returns} {NameOf(method)}({(parameters.Length > 0 ? parameters : "void")});");
        Line();
    }

    private static string Parameter(ParameterInfo parameter)
    {
        CArrayAttribute? array = parameter.GetCustomAttribute<CArrayAttribute>();
        string constant = parameter.IsDefined(typeof(InAttribute)) ? "const " : "";
        string name = Snake(parameter.Name!);
        return array is null
            ? $"{constant}{TypeName(parameter.ParameterType, isArray: false)} {name}"
            : $"{constant}{TypeName(parameter.ParameterType.GetElementType()!, isArray: true)} {name}[{(array.Length == Snapshot.Size ? "FOOTBALL_SNAPSHOT_BYTES" : array.Length.ToString(CultureInfo.InvariantCulture))}]";
    }

    private static string TypeName(Type type, bool isArray) => type.IsPointer
        ? TypeName(type.GetElementType()!, isArray) + "*"
        : type == typeof(byte) ? (isArray ? "unsigned char" : "char") : Scalar(type);

    private static string Scalar(Type type) => type switch
    {
        _ when type == typeof(double) => "double",
        _ when type == typeof(int) => "int32_t",
        _ when type == typeof(long) => "int64_t",
        _ when type == typeof(ulong) => "uint64_t",
        _ when type == typeof(CByte) => "unsigned char",
        _ when type.Name.StartsWith("Native", StringComparison.Ordinal) => "fp_" + Snake(type.Name["Native".Length..]),
        _ => throw new InvalidOperationException($"{type} has no name in C."),
    };

    private static string Snake(string name) => CapitalInside().Replace(name, "_$0").ToLowerInvariant();

    private string Summary(string member) => Text(_documentation[member].Element("summary")!);

    /// <summary>The text of a comment in ASCII, on one line.</summary>
    private static string Text(XElement element)
    {
        string text = string.Concat(element.Nodes().Select(node => node is XElement see
            ? see.Attribute("cref") is { } reference ? reference.Value.Split('(')[0].Split('.', ':')[^1] : see.Value
            : ((XText)node).Value));
        text = White().Replace(text, " ").Trim().Replace("…", "...").Replace("−", "-").Replace("²", "^2").Replace("±", "+-").Replace("χ", "chi");
        return text.All(char.IsAscii) ? text : throw new InvalidOperationException($"\"{text}\" is not ASCII.");
    }

    private static List<string> Wrap(string text, int width)
    {
        var lines = new List<string> { "" };
        foreach (string word in text.Split(' '))
        {
            if (lines[^1].Length > 0 && lines[^1].Length + 1 + word.Length > width)
            {
                lines.Add("");
            }

            lines[^1] += (lines[^1].Length > 0 ? " " : "") + word;
        }

        return lines;
    }

    private void Comment(string text, string indent = "") => Comment(Wrap(text, Width - 4 - indent.Length), indent);

    private void Comment(IReadOnlyList<string> lines, string indent = "")
    {
        for (int i = 0; i < lines.Count; i++)
        {
            Line($"{indent}{(i == 0 ? "/**" : "   ")} {lines[i]}{(i == lines.Count - 1 ? " */" : "")}");
        }
    }

    private void Line(string line = "") => _text.Append(line).Append('\n');

    [GeneratedRegex("(?<=.)[A-Z]")]
    private static partial Regex CapitalInside();

    [GeneratedRegex(@"\s+")]
    private static partial Regex White();
}
