using System.Reflection;
using System.Runtime.Loader;

namespace FootballPhysics.Benchmarks;

/// <summary>The benchmarks of a folder and their library, loaded next to other copies.</summary>
internal sealed class Build : AssemblyLoadContext
{
    private readonly AssemblyDependencyResolver _resolver;
    private readonly Func<string, (string Name, Func<(Func<double> Run, int Operations)>[] Make)[]> _rows;

    /// <summary>Loads the benchmarks of a folder.</summary>
    public Build(string folder)
    {
        string main = PathOf(folder);
        _resolver = new AssemblyDependencyResolver(main);
        MethodInfo rows = LoadFromAssemblyPath(main).GetType(typeof(Build).FullName!, throwOnError: true)!.GetMethod(nameof(Share))!;
        _rows = rows.CreateDelegate<Func<string, (string, Func<(Func<double>, int)>[])[]>>();
    }

    /// <summary>Returns true if a folder contains the benchmarks.</summary>
    public static bool Exists(string folder) => File.Exists(PathOf(folder));

    /// <summary>Returns the workloads of a table's rows by name. Each has a second workload if a flight step is its unit.</summary>
    public Dictionary<string, Func<Workload>[]> Rows(string table) =>
        _rows(table).ToDictionary(row => row.Name, row => row.Make.Select(make => new Func<Workload>(() =>
        {
            (Func<double> run, int operations) = make();
            return new Workload(run, operations);
        })).ToArray());

    /// <summary>Returns the rows in types of the runtime, which all copies of the benchmarks share.</summary>
    public static (string Name, Func<(Func<double> Run, int Operations)>[] Make)[] Share(string table) =>
    [
        .. from row in Table.All.Single(one => one.Name == table).Rows()
           from subject in row.Subjects
           let flight = row.FlightUnit is { } method ? new[] { Shared(() => Workloads.Flight(new Scene(), method, ShotSets.Fast)) } : []
           select ($"{table}: {row.Name}{(subject.Name.Length > 0 ? "; " : "")}{subject.Name}", flight.Prepend(Shared(subject.Make)).ToArray()),
    ];

    protected override Assembly? Load(AssemblyName assemblyName) =>
        _resolver.ResolveAssemblyToPath(assemblyName) is { } path ? LoadFromAssemblyPath(path) : null;

    private static string PathOf(string folder) => Path.GetFullPath(Path.Combine(folder, typeof(Build).Assembly.GetName().Name + ".dll"));

    private static Func<(Func<double> Run, int Operations)> Shared(Func<Workload> make) => () =>
    {
        Workload workload = make();
        return (workload.Run, workload.Operations);
    };
}
