using System.Globalization;
using FootballPhysics.Mutants;

// Estimates the mutation score of folders of the library from random samples.
//
//   dotnet run -c Release --project tests/Mutants -- ROOMS [COUNT] [SEEDS] [CLASSES]
//
// ROOMS: folders or files in src/Football.Physics, separated by commas, such as Contacts,Laws/DragJump.cs.
// COUNT: mutants per room and seed; default: 40. SEEDS: separated by commas; default: 1.
// CLASSES: test classes, separated by commas, such as DragJumpTests. With them, the program runs only these classes,
// and only on the mutants that the last run with the same rooms, count and seeds left alive.
// The results are in artifacts/mutants. A run that was stopped goes on where it ended; delete its file to start again.
//
// Build the tests first: dotnet build -c Release tests/Football.Physics.Tests, and the same for tests/Football.Physics.Labs.Tests and tests/Package.Tests.
// The program compiles all mutants of the sample into one library, each behind a switch. It runs each test class once to find the mutants that the class reaches.
// Each mutant then meets only the classes that reach it, up to the first failure. The golden hashes run only on mutants that pass all of these classes.
// Golden hashes detect any change and not only errors, so the summary counts them separately.
// equivalents.tsv lists the mutants that no test can kill, with reasons. The exit code is 1 if tests of behaviour kill less than 85 % of the others.
if (args.Length is 0 or > 4)
{
    Console.Error.WriteLine("Usage: Mutants ROOMS [COUNT, 40] [SEEDS, 1] [CLASSES]");
    return 2;
}

string[] rooms = args[0].Split(',');
int count = args.Length > 1 ? int.Parse(args[1], CultureInfo.InvariantCulture) : 40;
int[] seeds = [.. (args.Length > 2 ? args[2] : "1").Split(',').Select(text => int.Parse(text, CultureInfo.InvariantCulture))];
if (rooms.FirstOrDefault(name => !Directory.Exists(Path.Combine(LibrarySources.Folder, name)) && !File.Exists(Path.Combine(LibrarySources.Folder, name))) is { } unknown)
{
    Console.Error.WriteLine($"{LibrarySources.Folder} has no folder and no file {unknown}.");
    return 2;
}

string name = string.Join('+', rooms).Replace('/', '-');
string folder = Path.Combine(LibrarySources.Root, "artifacts/mutants", $"{name}-{count}-{string.Join('+', seeds)}");
string log = folder + ".txt";
Equivalents equivalents = Equivalents.Read();
Sample sample = Sample.Draw(rooms, count, seeds, equivalents);
var ends = new string?[sample.Mutants.Count];
if (File.Exists(log))
{
    Dictionary<string, string> last = File.ReadAllLines(log).ToDictionary(line => line[12..], line => line[..11].Trim());
    for (int i = 0; i < ends.Length; i++)
    {
        ends[i] = last.GetValueOrDefault(sample.Mutants[i].Name) is { Length: > 0 } end ? end : null;
    }
}

using (var play = new Play(folder, sample))
{
    bool slow = args.Length < 4;
    if (!play.Prepare(slow ? null : args[3].Split(',')))
    {
        Console.Error.WriteLine("Tests fail without any mutant.");
        return 2;
    }

    for (int i = 0; i < ends.Length; i++)
    {
        if (slow ? ends[i] is null : ends[i] is not null and not "killed")
        {
            string end = play.End(i, out string? by);
            Note(i, end == "killed" ? end : ends[i] ?? end, by);
        }
    }

    if (slow && !play.PrepareSlow())
    {
        Console.Error.WriteLine("Slow tests fail without any mutant.");
        return 2;
    }

    for (int i = 0; slow && i < ends.Length; i++)
    {
        if (ends[i] is not "killed" && play.KilledBySlow(i, out string? by))
        {
            Note(i, "killed", by);
        }
    }
}

void Note(int i, string? end, string? by)
{
    ends[i] = end;
    File.WriteAllLines(log, ends.Select((known, at) => $"{known,-11} {sample.Mutants[at].Name}"));
    Console.WriteLine(Line(i) + (by is null ? "" : "  by " + by));
}

bool enough = true;
foreach (string room in rooms)
{
    int[] those = [.. Enumerable.Range(0, ends.Length).Where(i => sample.Mutants[i].Room == room && ends[i] is not null)];
    ILookup<bool, int> alive = those.Where(i => ends[i] != "killed").OrderBy(i => ends[i], StringComparer.Ordinal).ThenBy(Line, StringComparer.Ordinal).ToLookup(i => Reason(i) is not null);
    Console.WriteLine();
    foreach (int i in alive[true])
    {
        Console.WriteLine($"EQUIVALENT  {Line(i)[12..]}  since {Reason(i)}");
    }

    foreach (int i in alive[false])
    {
        Console.WriteLine(Line(i));
    }

    foreach (int i in those.Where(i => ends[i] == "killed" && Reason(i) is not null))
    {
        Console.WriteLine("listed as equivalent, but a test kills it: " + Line(i)[12..]);
        enough = false;
    }

    int same = alive[true].Count();
    int killed = those.Count(i => ends[i] == "killed");
    int golden = alive[false].Count(i => ends[i] == "GOLDEN");
    enough &= killed >= 0.85 * (those.Length - same);
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{room}, seeds {string.Join(" and ", seeds)}: {those.Length} of {sample.Mutants.Count(at => at.Room == room)} mutants, {killed} killed by tests of behaviour, {same} equivalent, {golden} change only golden hashes, {those.Length - same - killed - golden} alive; killed of all: {Score(killed, those.Length)}; killed of those that are not equivalent: {Score(killed, those.Length - same)}"));
}

return enough ? 0 : 1;

string? Reason(int i) => equivalents.ReasonOf(sample.Mutants[i].Name);

string Line(int i) => $"{ends[i],-11} {sample.Mutants[i].Mutant.Place}  {sample.Mutants[i].Mutant.What}";

// The share, and Wilson's interval.
static string Score(int many, double n)
{
    double share = many / n;
    const double Z = 1.96;
    double middle = (share + (Z * Z / (2 * n))) / (1 + (Z * Z / n));
    double half = Z / (1 + (Z * Z / n)) * Math.Sqrt((share * (1 - share) / n) + (Z * Z / (4 * n * n)));
    return string.Create(CultureInfo.InvariantCulture, $"{100 * share:0} % ({100 * (middle - half):0} to {100 * (middle + half):0} % with 95 % confidence)");
}
