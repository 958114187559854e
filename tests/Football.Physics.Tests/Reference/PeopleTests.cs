using System.Text.Json;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tests.Reference;

/// <summary>What people have met with balls in games, as scenarios, each with the value that is right: seams, discs, slow bounces, piles, and balls placed in the ground.</summary>
public sealed class PeopleTests
{
    private static readonly IReadOnlyDictionary<string, JsonElement> s_cases =
        ReferenceCase.Lines("people.ndjson").ToDictionary(line => line.GetProperty("name").GetString()!, StringComparer.Ordinal);

    /// <summary>Lines that expect something; one line is there for another to be compared with.</summary>
    public static TheoryData<string> Names => [.. s_cases.Where(item => item.Value.GetProperty("expected").GetArrayLength() > 0).Select(item => item.Key)];

    [Fact]
    public void All_cases_are_there() => Assert.Equal((36, 35), (s_cases.Count, Names.Count));

    [Theory]
    [MemberData(nameof(Names))]
    public void Every_value_is_as_expected(string name)
    {
        Scenario scenario = Read(name);
        Outcome outcome = ScenarioRun.Play(scenario);
        List<string> wrong = [];
        foreach (JsonElement item in s_cases[name].GetProperty("expected").EnumerateArray())
        {
            string path = item.GetProperty("path").GetString()!;
            double[] found = Look(scenario, outcome, path);
            if (!item.TryGetProperty("tolerance", out JsonElement tolerance))
            {
                double least = item.TryGetProperty("least", out JsonElement low) ? low.GetDouble() : double.NegativeInfinity;
                double most = item.TryGetProperty("most", out JsonElement high) ? high.GetDouble() : double.PositiveInfinity;
                Note(wrong, found[0] >= least && found[0] <= most, $"{path} is {found[0]:R}; allowed: {least:R} … {most:R}");
                continue;
            }

            double[] expected = item.TryGetProperty("as", out JsonElement other) ? LookAt(other.GetString()!, path) : Numbers(item.GetProperty("value"));
            bool near = expected.Length == found.Length
                && expected.Zip(found).All(pair => Math.Abs(pair.First - pair.Second) <= tolerance.GetDouble() * Math.Max(1, Math.Abs(pair.First)));
            Note(wrong, near, $"{path} is ({string.Join(", ", found)}), expected ({string.Join(", ", expected)})");
        }

        Assert.True(wrong.Count == 0, $"{name}: {string.Join("; ", wrong)}");
    }

    private static void Note(List<string> wrong, bool holds, FormattableString what)
    {
        if (!holds)
        {
            wrong.Add(FormattableString.Invariant(what));
        }
    }

    private static Scenario Read(string name) => Scenario.Read(new InputFields(s_cases[name].GetProperty("scenario")));

    private static double[] LookAt(string name, string path)
    {
        Scenario scenario = Read(name);
        return Look(scenario, ScenarioRun.Play(scenario), path);
    }

    private static double[] Numbers(JsonElement value) =>
        value.ValueKind == JsonValueKind.Array ? [.. value.EnumerateArray().Select(item => item.GetDouble())] : [value.GetDouble()];

    /// <summary>What a path names: a member of the end, or a count or measure of the whole run.</summary>
    private static double[] Look(Scenario scenario, Outcome outcome, string path) => path.Split('.') switch
    {
        ["events"] => [outcome.Events.Count + outcome.Missed],
        ["impacts"] => [outcome.Events.Count(item => item.Kind == BallEventKind.Impact)],
        ["evaluations"] => [outcome.Evaluations],
        ["resting"] => [(outcome.Balls.Count > 0 ? outcome.Balls : [outcome.Final]).Count(ball => ball.State == MotionState.Rest)],
        ["speed"] => [outcome.Final.Velocity.Length],
        ["start"] => Components(outcome.Samples![0].Position),
        ["depth"] => [Depth(scenario, outcome)],
        ["overlap"] => [Overlap(scenario, outcome)],
        ["final", var member] => Components(Member(outcome, member)),
        ["final", var member, var axis] => [Components(Member(outcome, member))["012".IndexOf(axis, StringComparison.Ordinal)]],
        _ => throw new ArgumentException($"{path} names nothing", nameof(path)),
    };

    private static Vector3d Member(Outcome outcome, string member) => member switch
    {
        "position" => outcome.Final.Position,
        "velocity" => outcome.Final.Velocity,
        "spin" => outcome.Final.Spin,
        _ => throw new ArgumentException($"{member} names nothing", nameof(member)),
    };

    private static double[] Components(Vector3d of) => [of.X, of.Y, of.Z];

    /// <summary>The most that a ball is in the level ground or in a plane, at any sample, m.</summary>
    private static double Depth(Scenario scenario, Outcome outcome)
    {
        IShape[] planes = [.. scenario.Scene.Obstacles.Select(item => item.Shape).OfType<PlaneShape>(), new PlaneShape(Vector3d.Zero, Vector3d.Up)];
        return Paths(outcome).Max(path => path.Max(place => planes.Max(plane => scenario.Scene.Ball.Radius - plane.At(place).Distance)));
    }

    /// <summary>The most that two balls are in each other, at any sample, m.</summary>
    private static double Overlap(Scenario scenario, Outcome outcome)
    {
        Vector3d[][] paths = Paths(outcome);
        double most = 0;
        for (int i = 1; i < paths.Length; i++)
        {
            for (int j = 0; j < i; j++)
            {
                most = Math.Max(most, paths[i].Zip(paths[j]).Max(pair => (2 * scenario.Scene.Ball.Radius) - Vector3d.Distance(pair.First, pair.Second)));
            }
        }

        return most;
    }

    private static Vector3d[][] Paths(Outcome outcome) => outcome.Balls.Count == 0
        ? [[.. outcome.Samples!.Select(sample => sample.Position)]]
        : [.. outcome.BallSamples.Select(path => path.Select(sample => sample.Position).ToArray())];
}
