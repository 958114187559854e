namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "What a scene contains": flight steps of scenes with fewer or simpler forces, other balls and other air.</summary>
internal static class MixtureTable
{
    /// <summary>The noise of a ratio within one run.</summary>
    private const double Noise = 0.03;

    public static IReadOnlyList<MixtureRow> Rows { get; } =
    [
        Laws("without drag", 1.00, forces => forces with { Drag = ForceLaw.None }),
        Laws("without Magnus force", 1.00, forces => forces with { Magnus = ForceLaw.None }),
        Laws("without spin decay", 1.00, forces => forces with { SpinDecay = ForceLaw.None }),
        Laws("drag only", 1.00, forces => forces with { Magnus = ForceLaw.None, SpinDecay = ForceLaw.None }),
        Laws("Magnus force only", 1.00, forces => forces with { Drag = ForceLaw.None, SpinDecay = ForceLaw.None }),
        Laws("constant drag", 1.00, forces => forces with { Drag = ForceLaw.Constant }),
        Laws("constant Magnus force", 1.00, forces => forces with { Magnus = ForceLaw.Constant }),
        Laws("constant spin decay", 1.00, forces => forces with { SpinDecay = ForceLaw.Constant }),
        Laws("constant drag, without Magnus force", 1.00, forces => forces with { Drag = ForceLaw.Constant, Magnus = ForceLaw.None }),
        Laws("all coefficients constant", 0.65, forces => forces with { Drag = ForceLaw.Constant, Magnus = ForceLaw.Constant, SpinDecay = ForceLaw.Constant }),
        Laws("no air", 0.13, forces => forces with { Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None }),
        .. BallProperties.Presets.Select(preset => Ball(preset.Key, preset.Value)),
        new("thin air, 0.9 kg/m³", 1.00, scene => scene with { Air = scene.Air with { Density = 0.9 } }),
        new("steady wind", 1.00, scene => scene with { Air = scene.Air with { Wind = new Vector3d(5, 0, 2) } }),
    ];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<MixtureRow> rows, double share)
    {
        print("");
        print("## What a scene contains");
        print("");
        print("Flight steps of 10 ms in the default and the published scene with a part left out, made constant or replaced, as a ratio to the complete scene; the two alternate in one process. 0.03 is noise.");
        print("");
        print("| | Euler | semi-implicit Euler | RK2 | RK4 | reach | | published: Euler | semi-implicit Euler | RK2 | RK4 | |");
        print("|---|--:|--:|--:|--:|--:|---|--:|--:|--:|--:|---|");
        Scene[] complete = [new Scene(), Scene.Published];
        foreach (MixtureRow row in rows)
        {
            var cells = new List<string> { row.Name };
            foreach (Scene scene in complete)
            {
                bool reached = true;
                foreach ((_, Integrator integrator) in MixtureRow.Methods)
                {
                    Workload subject = row.Flight(scene, integrator);
                    Workload yardstick = Workloads.Flight(scene, integrator, ShotSets.Fast);
                    Stopwatching.WarmUp([subject, yardstick]);
                    double ratio = Stopwatching.Measure(subject, yardstick, 0.1 * share).Ratio;
                    reached &= ratio <= row.Target + Noise;
                    cells.Add(Text.Number(ratio));
                }

                if (scene == complete[0])
                {
                    cells.Add($"≤ {Text.Number(row.Target)}");
                }

                cells.Add(reached ? "reached" : "**missed**");
            }

            print($"| {string.Join(" | ", cells)} |");
        }
    }

    private static MixtureRow Ball(string name, BallProperties ball) =>
        new("ball: " + name, 1.00, scene => scene with { Ball = ball });

    private static MixtureRow Laws(string name, double target, Func<ForceSet, ForceSet> change) =>
        new(name, target, scene => scene with { Forces = change(scene.Forces) });
}
