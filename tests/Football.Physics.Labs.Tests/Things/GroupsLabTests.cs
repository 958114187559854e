using FootballPhysics.Labs.Groups;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>The laboratory of random groups, small: balls of all sizes, with contacts of all materials.</summary>
public sealed class GroupsLabTests
{
    [Fact]
    public void Every_state_is_a_number_and_contacts_keep_momentum_and_add_no_energy()
    {
        GroupOutcome[] outcomes = [.. Enumerable.Range(0, 200).Select(i => GroupDraw.Play(71, i))];
        Assert.All(outcomes, outcome => Assert.True(outcome.Holds, $"{outcome}"));
        Assert.All(Enum.GetValues<GroupPlace>(), place => Assert.True(outcomes.Where(outcome => outcome.Place == place).Sum(outcome => outcome.Contacts) > 50));
    }

    /// <summary>In these two, a part is not solved well, and is scaled: that keeps the momentum.</summary>
    [Theory]
    [InlineData(1, 1574)]
    [InlineData(77, 472)]
    public void A_part_that_is_scaled_keeps_the_momentum(long seed, long group)
    {
        GroupOutcome outcome = GroupDraw.Play(seed, group);
        Assert.Equal(GroupPlace.EmptySpace, outcome.Place);
        Assert.True(outcome.Holds, $"{outcome}");
    }

    [Fact]
    public void The_command_judges_each_place()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "groups", "--count", "20", "--seed", "7");
        Assert.Equal(4, done.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
        Assert.Equal(0, done.ExitCode);
    }

    /// <summary>What the laboratory must find, it finds.</summary>
    [Theory]
    [InlineData(false, 0.0, 0.0)]
    [InlineData(true, 1e-9, 0.0)]
    [InlineData(true, 0.0, 1e-6)]
    [InlineData(true, double.NaN, 0.0)]
    public void A_group_that_fails_is_judged_so(bool isNumber, double momentum, double energy) =>
        Assert.False(new GroupOutcome(GroupPlace.EmptySpace, isNumber, 1, momentum, energy).Holds);
}
