using System.Reflection;
using System.Runtime.CompilerServices;

namespace Football.Physics.Tests.Api;

/// <summary>The public surface of the library as sorted lines of text.</summary>
internal static class PublicApi
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    public static IEnumerable<string> Lines(Assembly assembly) =>
        assembly.GetExportedTypes().SelectMany(type => Members(type).Prepend(Header(type))).Order(StringComparer.Ordinal);

    private static string Header(Type type)
    {
        string kind = type.IsEnum ? "enum"
            : type.IsInterface ? "interface"
            : typeof(Delegate).IsAssignableFrom(type) ? "delegate"
            : type.IsValueType ? (type.IsDefined(typeof(IsReadOnlyAttribute)) ? "readonly struct" : "struct")
            : type.IsAbstract && type.IsSealed ? "static class"
            : type.IsSealed ? "sealed class" : type.IsAbstract ? "abstract class" : "class";
        IEnumerable<Type> bases = type.GetInterfaces().Where(_ => !type.IsEnum && !typeof(Delegate).IsAssignableFrom(type));
        string inherits = string.Join(", ", bases.Select(Name).Order(StringComparer.Ordinal));
        return $"{Name(type)}: {kind}{(inherits.Length > 0 ? " is " + inherits : string.Empty)}";
    }

    private static IEnumerable<string> Members(Type type)
    {
        if (type.IsEnum)
        {
            return Enum.GetNames(type).Select(name => $"{Name(type)}.{name} = {Convert.ToInt64(Enum.Parse(type, name))}");
        }

        if (typeof(Delegate).IsAssignableFrom(type))
        {
            return [Method(type, type.GetMethod("Invoke")!)];
        }

        return type.GetMembers(Declared).Where(Written).Select(member => member switch
        {
            FieldInfo field => $"{Name(type)}.{field.Name}: {(field.IsLiteral ? "const " : field.IsStatic ? "static " : string.Empty)}{(field.IsInitOnly ? "readonly " : string.Empty)}{Name(field.FieldType)}",
            PropertyInfo property => Property(type, property),
            ConstructorInfo constructor => $"{Name(type)}.new({Parameters(constructor)})",
            MethodInfo method => Method(type, method),
            _ => $"{Name(type)}.{member.Name}",
        });
    }

    /// <summary>Whether the outside sees a member that somebody wrote: no accessors, nothing the compiler made for a record.</summary>
    private static bool Written(MemberInfo member) => member switch
    {
        FieldInfo field => field.IsPublic || field.IsFamily,
        PropertyInfo property => property.GetAccessors(true).Any(Seen) && !Made(property),
        ConstructorInfo constructor => Seen(constructor) && !Made(constructor),
        MethodInfo method => Seen(method) && !Made(method) && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal)),
        EventInfo => true,
        _ => false,
    };

    private static bool Seen(MethodBase method) => method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly;

    private static bool Made(MemberInfo member) => member.IsDefined(typeof(CompilerGeneratedAttribute)) || member.Name.Contains('<', StringComparison.Ordinal);

    private static string Property(Type type, PropertyInfo property)
    {
        MethodInfo? setter = property.SetMethod is { } set && Seen(set) ? set : null;
        bool init = setter?.ReturnParameter.GetRequiredCustomModifiers().Contains(typeof(IsExternalInit)) ?? false;
        string accessors = (property.GetMethod is { } get && Seen(get) ? "get; " : string.Empty) + (setter is null ? string.Empty : init ? "init; " : "set; ");
        bool isStatic = property.GetAccessors(true)[0].IsStatic;
        string index = property.GetIndexParameters() is { Length: > 0 } indices ? $"[{string.Join(", ", indices.Select(p => Name(p.ParameterType)))}]" : string.Empty;
        return $"{Name(type)}.{property.Name}{index}: {(isStatic ? "static " : string.Empty)}{Name(property.PropertyType)} {{ {accessors}}}";
    }

    private static string Method(Type type, MethodInfo method)
    {
        string generic = method.IsGenericMethod ? $"<{string.Join(", ", method.GetGenericArguments().Select(Name))}>" : string.Empty;
        return $"{Name(type)}.{method.Name}{generic}({Parameters(method)}): {(method.IsStatic ? "static " : string.Empty)}{Name(method.ReturnType)}";
    }

    private static string Parameters(MethodBase method) => string.Join(", ", method.GetParameters().Select(parameter =>
    {
        string pass = parameter.IsOut ? "out " : parameter.IsIn ? "in " : parameter.ParameterType.IsByRef ? "ref " : string.Empty;
        string value = parameter.HasDefaultValue ? " = " + Convert.ToString(parameter.DefaultValue ?? "null", System.Globalization.CultureInfo.InvariantCulture) : string.Empty;
        Type bare = parameter.ParameterType.IsByRef ? parameter.ParameterType.GetElementType()! : parameter.ParameterType;
        return $"{pass}{Name(bare)} {parameter.Name}{value}";
    }));

    private static string Name(Type type)
    {
        if (type.IsByRef)
        {
            return "ref " + Name(type.GetElementType()!);
        }

        if (type.IsArray)
        {
            return Name(type.GetElementType()!) + "[]";
        }

        if (type.IsGenericParameter)
        {
            return type.Name;
        }

        string name = type.IsNested ? $"{Name(type.DeclaringType!)}.{type.Name}" : $"{type.Namespace}.{type.Name}";
        if (type.IsGenericType)
        {
            int tick = name.LastIndexOf('`');
            name = $"{(tick < 0 ? name : name[..tick])}<{string.Join(", ", type.GetGenericArguments().Select(Name))}>";
        }

        return name switch
        {
            "System.Void" => "void",
            "System.Double" => "double",
            "System.Single" => "float",
            "System.Int32" => "int",
            "System.Int64" => "long",
            "System.Boolean" => "bool",
            "System.String" => "string",
            "System.Object" => "object",
            _ => name.Replace("Football.Physics.", string.Empty, StringComparison.Ordinal),
        };
    }
}
