using FootballPhysics;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Gallery;

namespace FootballPhysics.Web.Tests;

/// <summary>What the gallery gives to copy is what its pictures show.</summary>
public sealed class GalleryCodeTests(ITestOutputHelper told)
{
    public static TheoryData<string> Shots => [.. GalleryShots.All.Select(shot => shot.Id)];

    [Theory]
    [MemberData(nameof(Shots))]
    public void A_copied_program_and_a_copied_command_give_the_picture(string id)
    {
        GalleryShot shot = GalleryShots.All.Single(shot => shot.Id == id);
        Outcome drawn = ScenarioRun.Play(shot.Scenario);
        string[] seen = [.. drawn.Events.Select(e => FormattableString.Invariant($"{e.Time:F6} s: {e.Kind} {drawn.NameOf(e.ColliderIndex)} at {e.Position:F6}"))];
        Assert.Equal(seen, Programs.Run(shot.Code).TrimEnd().Split('\n'));

        if (shot.Command is null)
        {
            Assert.NotNull(shot.Keeper);
            told.WriteLine($"{id}: {seen.Length} events, the program agrees with the picture to the last of six digits");
            return;
        }

        // echo 'JSON' | football replay - -o PAGE --set …: what replay plays of it.
        string json = shot.Command.Split('\'')[1];
        FieldOverride[] sets = [.. shot.Command.Split(" --set ").Skip(1).Append("stop.at=rest").Select(field => FieldOverride.Parse(field)!)];
        Outcome played = ScenarioRun.Play(Scenario.Read(InputCase.Read(new InputLine(System.Text.Encoding.UTF8.GetBytes(json), IsCut: false), sets).Scenario!));
        Assert.Equal(seen, played.Events.Select(e => FormattableString.Invariant($"{e.Time:F6} s: {e.Kind} {played.NameOf(e.ColliderIndex)} at {e.Position:F6}")));
        told.WriteLine($"{id}: {seen.Length} events, program and command agree with the picture to the last of six digits");
    }
}
