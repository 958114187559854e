using FootballPhysics.Mutants;
using FootballPhysics.Passes;
using FootballPhysics.Tests.Architecture;

// Counts the code of the library that runs in a step: files, methods, working lines of these methods, calls, and changes of file and folder.
//   dotnet run -c Release --project tests/Passes [-- --list|--methods|--sizes|--reach [PLAYS]|--removed [NAMES]]
// --list prints the files of a step. --methods prints its methods, each with its working lines and its calls.
// --sizes prints the working lines of each folder and the counts that tests/ceilings.tsv limits; nothing else runs.
// --reach plays twelve long plays and prints the bodies that none reaches, by folder, each with its working lines. PLAYS: the only plays, separated by commas.
// --removed removes each of these bodies, runs the tests that reach it, and prints whether one fails. NAMES: only bodies with one of these texts in their name.
// Build the tests first: dotnet build -c Release tests/Football.Physics.Tests.
// Each method of the sources is compiled with a mark. Numerics and State do not count as folders.
if (args.Contains("--sizes"))
{
    Console.WriteLine(CodeSize.Of(Path.Combine(LibrarySources.Root, "src")));
    return 0;
}

if (!MarkedLibrary.IsUsed)
{
    return MarkedLibrary.Run(args);
}

if (args.FirstOrDefault() == "--reach")
{
    Reach.Print(args.Length > 1 ? args[1].Split(',') : null);
    return 0;
}

if (args.FirstOrDefault() == "--removed")
{
    return Removal.Print(Reach.Print(null), args.Length > 1 ? args[1].Split(',') : null) ? 0 : 1;
}

new StepTable(args.FirstOrDefault()).Print();
return 0;
