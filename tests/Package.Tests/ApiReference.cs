using System.Globalization;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace FootballPhysics.Package.Tests;

/// <summary>Writes the public surface of assemblies and their XML documentation as one Markdown page.</summary>
internal sealed partial class ApiReference
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    private static readonly NullabilityInfoContext s_nullability = new();

    private readonly Dictionary<string, XElement> _documents;
    private readonly StringBuilder _page = new();

    /// <summary>The anchor of each type, by its key.</summary>
    private readonly Dictionary<string, string> _anchors = [];

    private ApiReference(Dictionary<string, XElement> documents) => _documents = documents;

    public static string Make(IReadOnlyList<Assembly> assemblies)
    {
        var documents = assemblies.SelectMany(assembly => XDocument.Load(Path.ChangeExtension(assembly.Location, ".xml")).Descendants("member"))
            .ToDictionary(member => member.Attribute("name")!.Value);
        var reference = new ApiReference(documents);
        reference.Write(assemblies);
        return reference._page.ToString();
    }

    private void Write(IReadOnlyList<Assembly> assemblies)
    {
        Type[] types = [.. assemblies.SelectMany(assembly => assembly.GetExportedTypes()).Where(type => type.Namespace!.StartsWith("Football", StringComparison.Ordinal)).OrderBy(Name, StringComparer.Ordinal)];
        (string Title, Type[] Types)[] groups = [.. ApiGroups.Titles.Select(title => (title, types.Where(type => ApiGroups.Of(type) == title).ToArray())).Where(group => group.Item2.Length > 0)];
        _page.Append("# API reference\n\nAll public types, by task. `tests/regenerate.sh` generates this page from the comments in the code; a test checks that it is up to date.\n");
        var anchors = new Dictionary<string, int>();
        foreach (Type type in groups.SelectMany(group => group.Types))
        {
            string anchor = Anchor(Name(type));
            int before = anchors.GetValueOrDefault(anchor);
            anchors[anchor] = before + 1;
            _anchors[Key(type)] = anchor + (before > 0 ? $"-{before}" : "");
        }

        foreach ((string title, Type[] members) in groups)
        {
            _page.Append(CultureInfo.InvariantCulture, $"\n**{title}**\n\n");
            foreach (Type type in members)
            {
                _page.Append(CultureInfo.InvariantCulture, $"- [{Name(type)}](#{_anchors[Key(type)]}): {Text(Document(type)?.Element("summary"))}\n");
            }
        }

        foreach (Type type in groups.SelectMany(group => group.Types))
        {
            Write(type);
        }
    }

    private void Write(Type type)
    {
        XElement? document = Document(type);
        _page.Append(CultureInfo.InvariantCulture, $"\n## {Name(type)}\n\n{Kind(type)} in `{type.Namespace}`. {Text(document?.Element("summary"))}\n");
        if (document?.Element("remarks") is { } remarks)
        {
            _page.Append(CultureInfo.InvariantCulture, $"\n{Text(remarks)}\n");
        }

        if (type.BaseType == typeof(MulticastDelegate))
        {
            _page.Append(CultureInfo.InvariantCulture, $"\n`{Signature(type.GetMethod("Invoke")!, Name(type))}`\n");
            Parameters(document);
            return;
        }

        var lines = new List<string>();
        if (type.IsEnum)
        {
            foreach (FieldInfo member in type.GetFields(BindingFlags.Public | BindingFlags.Static))
            {
                lines.Add($"- `{member.Name}` = {Convert.ToInt64(member.GetRawConstantValue(), CultureInfo.InvariantCulture)}: {Text(Find($"F:{Key(type)}.{member.Name}")?.Element("summary"))} {Text(Find($"F:{Key(type)}.{member.Name}")?.Element("remarks"))}".TrimEnd());
            }
        }
        else
        {
            foreach (MemberInfo member in type.GetMembers(Declared).OrderBy(Rank).ThenBy(member => member.Name, StringComparer.Ordinal).ThenBy(Key, StringComparer.Ordinal))
            {
                if (Line(member) is { } line)
                {
                    lines.Add(line);
                }
            }
        }

        if (lines.Count > 0)
        {
            _page.Append('\n').AppendJoin('\n', lines).Append('\n');
        }
    }

    private string? Line(MemberInfo member)
    {
        string? signature = member switch
        {
            ConstructorInfo constructor => Signature(constructor, "new " + Name(constructor.DeclaringType!)),
            PropertyInfo { Name: "EqualityContract" } => null,
            PropertyInfo property => Signature(property),
            FieldInfo field => $"{(field.IsLiteral ? "const " : field.IsStatic ? "static " : "")}{Name(field.FieldType)} {field.Name}{(field.IsLiteral ? " = " + Value(field.FieldType, field.GetRawConstantValue()) : "")}",
            EventInfo happening => $"event {Name(happening.EventHandlerType!)} {happening.Name}",
            MethodInfo method when !method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal) => Signature(method, MethodName(method)),
            _ => null,
        };
        XElement? document = Find(Key(member));
        if (signature is null || (document is null && member is not ConstructorInfo { DeclaringType.IsValueType: false }))
        {
            return null;
        }

        if (document is null || document.Element("inheritdoc") is { } inherited && inherited.Attribute("cref") is null && document.Element("summary") is null)
        {
            return null;
        }

        var line = new StringBuilder($"- `{signature}`: {Text(document.Element("summary"))}");
        XElement source = document.Element("inheritdoc")?.Attribute("cref") is { } cref ? Find(cref.Value) ?? document : document;
        foreach (XElement part in source.Elements("param").Concat(source.Elements("returns")).Concat(source.Elements("exception")).Concat(document.Elements("remarks")))
        {
            string name = part.Name.LocalName switch
            {
                "param" => $"`{part.Attribute("name")!.Value}`: ",
                "returns" => "Returns: ",
                "exception" => $"Throws `{Short(part.Attribute("cref")!.Value)}`: ",
                _ => "",
            };
            if (part.Name != "param" || (member as MethodBase)?.GetParameters().Any(p => p.Name == part.Attribute("name")!.Value) is true or null)
            {
                line.Append(CultureInfo.InvariantCulture, $"\n  - {name}{Text(part)}");
            }
        }

        return line.ToString();
    }

    private void Parameters(XElement? document)
    {
        _page.Append('\n');
        foreach (XElement part in document?.Elements().Where(part => part.Name == "param" || part.Name == "returns") ?? [])
        {
            _page.Append(CultureInfo.InvariantCulture, $"- {(part.Name == "param" ? $"`{part.Attribute("name")!.Value}`" : "Returns")}: {Text(part)}\n");
        }
    }

    private XElement? Document(Type type) => Find($"T:{Key(type)}");

    private XElement? Find(string key) => _documents.GetValueOrDefault(key);

    private static string Kind(Type type) =>
        type.IsEnum ? "Enumeration"
        : type.BaseType == typeof(MulticastDelegate) ? "Delegate"
        : type.IsInterface ? "Interface"
        : type.IsValueType ? (type.IsDefined(typeof(System.Runtime.CompilerServices.IsReadOnlyAttribute)) ? "Readonly struct" : "Struct")
        : type.IsAbstract && type.IsSealed ? "Static class"
        : type.GetMethod("<Clone>$") is not null ? "Immutable record"
        : "Class";

    private static int Rank(MemberInfo member) => member switch
    {
        ConstructorInfo => 0,
        FieldInfo => 1,
        PropertyInfo => 2,
        EventInfo => 3,
        _ => member.Name.StartsWith("op_", StringComparison.Ordinal) ? 5 : 4,
    };

    private static string Signature(MethodBase method, string name)
    {
        string result = method is MethodInfo info ? Name(info.ReturnType) + " " : "";
        string parameters = string.Join(", ", method.GetParameters().Select(Parameter));
        return $"{(method is MethodInfo && method.IsStatic ? "static " : "")}{result}{name}({parameters})";
    }

    private static string Signature(PropertyInfo property)
    {
        bool init = property.SetMethod?.ReturnParameter.GetRequiredCustomModifiers().Any(modifier => modifier.Name == "IsExternalInit") == true;
        string access = property.SetMethod is not { IsPublic: true } ? "get" : init ? "get; init" : "get; set";
        string name = property.GetIndexParameters() is { Length: > 0 } indexes ? $"this[{string.Join(", ", indexes.Select(Parameter))}]" : property.Name;
        string nullable = !property.PropertyType.IsValueType && s_nullability.Create(property).ReadState == NullabilityState.Nullable ? "?" : "";
        return $"{((property.GetMethod ?? property.SetMethod)!.IsStatic ? "static " : "")}{Name(property.PropertyType)}{nullable} {name} {{ {access}; }}";
    }

    private static string Parameter(ParameterInfo parameter)
    {
        string by = !parameter.ParameterType.IsByRef ? "" : parameter.IsOut ? "out " : parameter.IsIn ? "in " : "ref ";
        Type type = parameter.ParameterType.IsByRef ? parameter.ParameterType.GetElementType()! : parameter.ParameterType;
        string nullable = !type.IsValueType && s_nullability.Create(parameter).ReadState == NullabilityState.Nullable ? "?" : "";
        return $"{by}{Name(type)}{nullable} {parameter.Name}{(parameter.HasDefaultValue ? " = " + Value(type, parameter.DefaultValue) : "")}";
    }

    private static string MethodName(MethodInfo method) =>
        method.Name.StartsWith("op_", StringComparison.Ordinal) ? "operator " + method.Name[3..]
        : method.IsGenericMethod ? $"{method.Name}<{string.Join(", ", method.GetGenericArguments().Select(Name))}>"
        : method.Name;

    private static string Value(Type type, object? value) => value switch
    {
        // Reflection has null for the default of a struct, which is not C#.
        null => type.IsValueType && Nullable.GetUnderlyingType(type) is null ? "default" : "null",
        double number => number.ToString("R", CultureInfo.InvariantCulture),
        bool truth => truth ? "true" : "false",
        _ => Convert.ToString(value, CultureInfo.InvariantCulture)!,
    };

    private static string Name(Type type)
    {
        if (type.IsByRef)
        {
            return "ref " + Name(type.GetElementType()!);
        }

        if (Nullable.GetUnderlyingType(type) is { } value)
        {
            return Name(value) + "?";
        }

        if (type.IsArray)
        {
            return $"{Name(type.GetElementType()!)}[{new string(',', type.GetArrayRank() - 1)}]";
        }

        string simple = Type.GetTypeCode(type) switch
        {
            TypeCode.Boolean when !type.IsEnum => "bool",
            TypeCode.Byte when !type.IsEnum => "byte",
            TypeCode.Int32 when !type.IsEnum => "int",
            TypeCode.Int64 when !type.IsEnum => "long",
            TypeCode.UInt64 when !type.IsEnum => "ulong",
            TypeCode.Single when !type.IsEnum => "float",
            TypeCode.Double when !type.IsEnum => "double",
            TypeCode.String when !type.IsEnum => "string",
            _ => type == typeof(void) ? "void" : type == typeof(object) ? "object" : type.Name.Split('`')[0],
        };
        string owner = type is { IsNested: true, IsGenericParameter: false } ? Name(type.DeclaringType!) + "." : "";
        Type[] arguments = type.GetGenericArguments();
        return owner + simple + (arguments.Length > 0 && type.Name.Contains('`', StringComparison.Ordinal) ? $"<{string.Join(", ", arguments.Select(Name))}>" : "");
    }

    private static string Anchor(string name) => AnchorNoise().Replace(name.ToLowerInvariant(), "");

    /// <summary>The name of a member in the XML file.</summary>
    private static string Key(MemberInfo member) => member switch
    {
        ConstructorInfo constructor => $"M:{Key(constructor.DeclaringType!)}.#ctor{Keys(constructor)}",
        MethodInfo method => $"M:{Key(method.DeclaringType!)}.{method.Name}{(method.IsGenericMethod ? "``" + method.GetGenericArguments().Length : "")}{Keys(method)}"
            + (method.Name is "op_Implicit" or "op_Explicit" ? "~" + Key(method.ReturnType) : ""),
        PropertyInfo property => $"P:{Key(property.DeclaringType!)}.{property.Name}" + (property.GetIndexParameters() is { Length: > 0 } indexes ? $"({string.Join(',', indexes.Select(index => Key(index.ParameterType)))})" : ""),
        FieldInfo field => $"F:{Key(field.DeclaringType!)}.{field.Name}",
        EventInfo happening => $"E:{Key(happening.DeclaringType!)}.{happening.Name}",
        _ => "?:" + member.Name,
    };

    private static string Keys(MethodBase method) =>
        method.GetParameters() is { Length: > 0 } parameters ? $"({string.Join(',', parameters.Select(parameter => Key(parameter.ParameterType)))})" : "";

    private static string Key(Type type)
    {
        if (type.IsByRef)
        {
            return Key(type.GetElementType()!) + "@";
        }

        if (type.IsArray)
        {
            // The name of an array with several dimensions has the lower bound of each: [0:,0:].
            int rank = type.GetArrayRank();
            return $"{Key(type.GetElementType()!)}[{(rank > 1 ? string.Join(',', Enumerable.Repeat("0:", rank)) : "")}]";
        }

        if (type.IsGenericParameter)
        {
            return (type.DeclaringMethod is null ? "`" : "``") + type.GenericParameterPosition;
        }

        string name = (type.IsGenericType ? type.GetGenericTypeDefinition() : type).FullName!.Replace('+', '.');
        return type is { IsGenericType: true, IsGenericTypeDefinition: false }
            ? $"{name.Split('`')[0]}{{{string.Join(',', type.GetGenericArguments().Select(Key))}}}"
            : name;
    }

    /// <summary>The name of a type or member, with a link if its type has a section.</summary>
    private string Link(string cref)
    {
        string name = cref[(cref.IndexOf(':', StringComparison.Ordinal) + 1)..].Split('(')[0];
        string type = cref[0] == 'T' ? name : name[..Math.Max(0, name.LastIndexOf('.'))];
        return _anchors.TryGetValue(type, out string? anchor) ? $"[`{Short(cref)}`](#{anchor})" : $"`{Short(cref)}`";
    }

    private static string Short(string cref)
    {
        string name = cref[(cref.IndexOf(':', StringComparison.Ordinal) + 1)..].Split('(')[0];
        string[] parts = name.Split('.');
        bool member = cref[0] != 'T' && parts.Length > 1;
        string last = parts[^1] == "#ctor" ? parts[^2] : parts[^1];
        return (member && parts[^1] != "#ctor" ? parts[^2] + "." + last : last).Split('`')[0];
    }

    private string Text(XElement? element)
    {
        if (element is null)
        {
            return "";
        }

        var text = new StringBuilder();
        foreach (XNode node in element.Nodes())
        {
            text.Append(node switch
            {
                XText words => words.Value,
                XElement { Name.LocalName: "see" or "seealso" } see => see.Attribute("cref") is { } cref ? Link(cref.Value) : $"`{see.Attribute("langword")?.Value}`",
                XElement { Name.LocalName: "paramref" or "typeparamref" } named => $"`{named.Attribute("name")!.Value}`",
                XElement { Name.LocalName: "c" } code => $"`{code.Value}`",
                XElement { Name.LocalName: "inheritdoc" } => "",
                XElement other => $" {Text(other)} ",
                _ => "",
            });
        }

        return Space().Replace(text.ToString(), " ").Trim();
    }

    [GeneratedRegex(@"\s+")]
    private static partial Regex Space();

    [GeneratedRegex("[^a-z0-9_-]")]
    private static partial Regex AnchorNoise();
}
