using System.CommandLine;

namespace FootballPhysics.Labs.Groups;

/// <summary>football lab groups: random groups of balls of all materials, in empty space and on the ground.</summary>
internal static class GroupsLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "groups",
            "Random groups of 2 to 9 balls with contacts of all materials: every state is a number, empty space keeps momentum, and contacts add no energy.",
            ["football lab groups", "football lab groups --count 200 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Groups.", 1, 10_000_000, 10_000);
        Option<long?> group = lab.WholeOrNone("--group", "One group by its number.", long.MaxValue);
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Plays(run =>
        {
            long first = run.Get(group) ?? 0;
            Run(run, first, run.Get(group) is null ? run.Get(count) : 1, run.Int(jobs));
        });
    }

    private static void Run(LabRun run, long first, long count, int jobs)
    {
        var outcomes = new GroupOutcome[count];
        run.Parallel(first, count, jobs, "group", index => outcomes[index - first] = GroupDraw.Play(run.Seed, index));
        LabTable table = run.Table("Random groups of balls", "place", "groups", "contacts of balls", "not a number", "worst momentum", "worst energy", "verdict");
        foreach (IGrouping<GroupPlace, GroupOutcome> place in outcomes.GroupBy(outcome => outcome.Place).OrderBy(place => place.Key))
        {
            table.Judge(
                place.All(outcome => outcome.Holds),
                place.Key, place.Count(), place.Sum(outcome => outcome.Contacts), place.Count(outcome => !outcome.IsNumber),
                place.Max(outcome => outcome.Momentum), place.Max(outcome => outcome.Energy));
        }

        if (Array.Find(outcomes, outcome => !outcome.Holds) is { } failed)
        {
            run.Notes.Add(FormattableString.Invariant($"First failure: --group {Array.IndexOf(outcomes, failed) + first} --seed {run.Seed}: {failed}."));
        }

        run.Notes.Add("Momentum and energy are relative to the sum of the balls' own, at their largest. Gravity adds the height to the energy.");
    }
}
