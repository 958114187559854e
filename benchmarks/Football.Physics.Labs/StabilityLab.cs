using System.CommandLine;
using FootballPhysics.Labs.Stability;
using FootballPhysics.Labs.Stability.Things;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Labs;

/// <summary>football lab stability: random scenes, and the invariants that must hold in them.</summary>
internal static class StabilityLab
{
    private const long MostScenes = 1_000_000_000_000;

    public static Lab Create()
    {
        SceneSet ordinary = new StressSet(1, Profile.Measured);
        SceneSet strange = new HostileSet(1);
        var lab = new Lab(
            "stability",
            "Invariants (finite, bounded energy, no penetration) in random and adversarial scenes, with every integrator.",
            ["football lab stability --scenes 100", "football lab stability --scene 7", "football lab stability --profile published --scenes 60", "football lab stability --hostile --scenes 100", "football lab stability --things --scenes 100"],
            isDrawn: true);
        Option<long> scenes = lab.Whole("--scenes", $"Number of scenes; {strange.ByDefault} by default if hostile.", 1, MostScenes, ordinary.ByDefault);
        Option<bool> full = lab.Flag("--full", $"Simulate {ordinary.Full} scenes, or {strange.Full} hostile ones.");
        Option<long> jobs = lab.Jobs("Threads; default: one per processor.");
        Option<long?> scene = lab.Add(new Option<long?>("--scene") { HelpName = "I", Description = "Simulate one scene by its number and print it as a scenario." });
        Option<bool> hostile = lab.Flag("--hostile", "Scenes far outside football, with a generator and checks of their own.");
        Option<bool> things = lab.Flag("--things", "Scenes with obstacles, bodies, nets and slopes, with checks of their own.");
        Option<Profile> profile = lab.Add(new Option<Profile>("--profile")
        {
            HelpName = "measured|published",
            Description = "Profile of laws and ground; hostile scenes have their own.",
            DefaultValueFactory = _ => Profile.Measured,
        });
        return lab.Plays(run =>
        {
            SceneSet set = run.Get(things) ? new ThingsSet(run.Seed) : run.Get(hostile) ? new HostileSet(run.Seed) : new StressSet(run.Seed, run.Get(profile));
            run.Name = set.Name;
            if (run.Get(scene) is { } number)
            {
                StressOutcome one = set.Play(number);
                set.Show(number, one, run);
                run.Failed = one.Failure is not null;
                return;
            }

            long count = run.Get(full) ? set.Full : run.Has(scenes) ? run.Get(scenes) : set.ByDefault;
            var results = new StressResults();
            results.Play(set, count, run.Int(jobs), run);
            set.Show(results, count, run);
            run.Failed = results.Findings.Kinds > 0;
        });
    }
}
