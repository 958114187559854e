using System.Collections;
using System.Reflection;
using System.Runtime.Loader;

namespace FootballPhysics.Benchmarks;

/// <summary>A build of these benchmarks in a folder, loaded next to other builds together with its own library.</summary>
internal sealed class Build : AssemblyLoadContext
{
    private const string MainAssembly = "Football.Physics.Benchmarks";

    private readonly AssemblyDependencyResolver _resolver;

    private Build(string main)
        : base(main) => _resolver = new AssemblyDependencyResolver(main);

    /// <summary>Returns the kicks of a build by name: those of <see cref="KickTable"/>, in the default scene and in the published one.</summary>
    /// <exception cref="InvalidOperationException">The folder has no build, or one with an incompatible table.</exception>
    public static IReadOnlyDictionary<string, Workload> Kicks(string folder)
    {
        string main = Path.Combine(Path.GetFullPath(folder), MainAssembly + ".dll");
        if (!File.Exists(main))
        {
            throw new InvalidOperationException($"--against: {folder} has no {MainAssembly}.dll. Build the benchmarks of that version.");
        }

        var build = new Build(main);
        Assembly benchmarks = build.LoadFromAssemblyPath(main);
        Type scene = build.LoadFromAssemblyName(new AssemblyName("Football.Physics")).GetType("FootballPhysics.Scene", throwOnError: true)!;
        (string Name, object Scene)[] scenes = [("default", Activator.CreateInstance(scene)!), ("published", scene.GetProperty(nameof(Scene.Published))!.GetValue(null)!)];
        object table = benchmarks.GetType(typeof(KickTable).FullName!)?.GetProperty(nameof(KickTable.Rows))?.GetValue(null)
            ?? throw new InvalidOperationException($"--against: the build in {folder} has no {nameof(KickTable)}.{nameof(KickTable.Rows)}. Choose a later commit.");
        return ((IEnumerable)table).Cast<object>()
            .SelectMany(row => scenes.Select(of => ($"{Get<string>(row, nameof(KickRow.Name))}; {of.Name}", Subject(row, of.Scene))))
            .ToDictionary();
    }

    protected override Assembly? Load(AssemblyName assemblyName) =>
        _resolver.ResolveAssemblyToPath(assemblyName) is { } path ? LoadFromAssemblyPath(path) : null;

    private static Workload Subject(object row, object scene)
    {
        object workload = Get<Delegate>(row, nameof(KickRow.Subject)).DynamicInvoke(scene)!;
        return new Workload(Get<Func<double>>(workload, nameof(Workload.Run)), Get<int>(workload, nameof(Workload.Operations)));
    }

    private static T Get<T>(object of, string property) => (T)of.GetType().GetProperty(property)!.GetValue(of)!;
}
