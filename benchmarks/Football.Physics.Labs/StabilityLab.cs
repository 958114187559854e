using System.CommandLine;
using FootballPhysics.Labs.Stability;
using FootballPhysics.Labs.Stability.Things;
using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs;

/// <summary>football lab stability: random scenes, and the invariants that must hold in them.</summary>
internal static class StabilityLab
{
    private const long MostScenes = 1_000_000_000_000;

    public static Command Create(Terminal terminal)
    {
        SceneSet ordinary = new StressSet(1, Profile.Measured);
        SceneSet strange = new HostileSet(1);
        Option<long> scenes = Arguments.Whole("--scenes", $"Number of scenes; {strange.ByDefault} by default if hostile.", 1, MostScenes, ordinary.ByDefault);
        var full = new Option<bool>("--full") { Description = $"Simulate {ordinary.Full} scenes, or {strange.Full} hostile ones." };
        Option<long> jobs = Arguments.Jobs("Threads; default: one per processor.");
        var scene = new Option<long?>("--scene") { HelpName = "I", Description = "Simulate one scene by its number and print it as a scenario." };
        var hostile = new Option<bool>("--hostile") { Description = "Scenes far outside football, with a generator and checks of their own." };
        var things = new Option<bool>("--things") { Description = "Scenes with obstacles, bodies, nets and slopes, with checks of their own." };
        Option<Profile> profile = new("--profile") { HelpName = "measured|published", Description = "Profile of laws and ground; hostile scenes have their own.", DefaultValueFactory = _ => Profile.Measured };
        return LabOptions.CreateDrawn(
            "stability",
            "Invariants (finite, bounded energy, no penetration) in random and adversarial scenes, with every integrator.",
            ["football lab stability --scenes 100", "football lab stability --scene 7", "football lab stability --profile published --scenes 60", "football lab stability --hostile --scenes 100", "football lab stability --things --scenes 100"],
            terminal,
            (parsed, seed, progress) =>
            {
                SceneSet set = parsed.GetValue(things) ? new ThingsSet(seed) : parsed.GetValue(hostile) ? new HostileSet(seed) : new StressSet(seed, parsed.GetValue(profile));
                var report = new LabReport { Name = set.Name, Seed = seed };
                if (parsed.GetValue(scene) is { } number)
                {
                    StressOutcome one = set.Play(number);
                    set.Show(number, one, terminal, report);
                    report.Failed = one.Failure is not null;
                    return report;
                }

                bool counted = parsed.GetResult(scenes) is { Implicit: false };
                long count = parsed.GetValue(full) ? set.Full : counted ? parsed.GetValue(scenes) : set.ByDefault;
                var results = new StressResults();
                results.Play(set.Play, set.First, count, (int)parsed.GetValue(jobs), terminal, progress);
                set.Show(results, count, report);
                report.Failed = results.Findings.Kinds > 0;
                return report;
            },
            scenes,
            full,
            jobs,
            scene,
            hostile,
            things,
            profile);
    }
}
