using FootballPhysics.Fuzz;
using FootballPhysics.Yardsticks;
using SharpFuzz;

// Inputs of one kind, for tests/fuzz.sh:
//
//   football-fuzz list                     the kinds
//   football-fuzz seeds KIND FOLDER COUNT  writes inputs to start from
//   football-fuzz try KIND FILE...         tries each file; exit code 1 if one leads to what must not be
//   football-fuzz afl KIND                 tries the inputs of afl-fuzz, in instrumented assemblies
switch (args)
{
    case ["list"]:
        Array.ForEach([.. Inputs.All], kind => Console.WriteLine(kind.Name));
        return 0;

    case ["seeds", string name, string folder, string count]:
        Directory.CreateDirectory(folder);
        for (int i = 0; i < int.Parse(count); i++)
        {
            File.WriteAllBytes(Path.Combine(folder, $"{name}-{i:000}"), Inputs.Of(name).Seed(new SeededRandom(i), i % 4));
        }

        return 0;

    case ["try", string name, .. string[] files]:
        int refused = 0;
        int found = 0;
        foreach (string file in files)
        {
            try
            {
                refused += Inputs.Of(name).Try(File.ReadAllBytes(file)) ? 1 : 0;
            }
            catch (Exception e)
            {
                found++;
                Console.WriteLine($"{file}: {e}");
            }
        }

        Console.WriteLine($"{files.Length} inputs, {refused} refused, {found} found");
        return found > 0 ? 1 : 0;

    case ["afl", string name]:
        // In a process of its own, so that afl-fuzz goes on after a hang. SharpFuzz ignores the path of the first call, which creates the static objects.
        Inputs? input = null;
        Fuzzer.OutOfProcess.Run(stream =>
        {
            if (input is null)
            {
                input = Inputs.Of(name);
                input.Try(input.Seed(new SeededRandom(0), 0));
            }

            using var bytes = new MemoryStream();
            stream.CopyTo(bytes);
            input.Try(bytes.ToArray());
        });
        return 0;

    default:
        Console.Error.WriteLine("Usage: football-fuzz list | seeds KIND FOLDER COUNT | try KIND FILE... | afl KIND");
        return 2;
}
