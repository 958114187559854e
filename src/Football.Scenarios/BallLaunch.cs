using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>One of several balls, and its launch.</summary>
/// <param name="Ball">The ball.</param>
/// <param name="Position">The position of the ball at the start, m.</param>
/// <param name="Velocity">Velocity, m/s.</param>
/// <param name="Spin">Spin, rad/s.</param>
/// <param name="Orientation">How it is turned.</param>
public sealed record BallLaunch(BallProperties Ball, Vector3d Position, Vector3d Velocity, Vector3d Spin, Quaterniond Orientation)
{
    /// <summary>All that an input has.</summary>
    /// <param name="root">The input.</param>
    /// <param name="common">The ball of those that say nothing of theirs.</param>
    public static IReadOnlyList<BallLaunch> All(InputObject root, BallProperties common)
    {
        Profile profile = root.Choice("profile", Profile.Measured);
        root.Exclude("launch", "balls");
        IReadOnlyList<InputObject> items = root.Objects("balls");
        root.Demand("balls", items.Count > 0, "one ball or more");
        return [.. items.Select(item => One(item, profile, common))];
    }

    private static BallLaunch One(InputObject item, Profile profile, BallProperties common)
    {
        BallProperties ball = item.Has("ball") ? SceneInput.Ball(item.Object("ball"), profile) : common;
        InputObject launch = item.Object("launch");
        return new BallLaunch(
            ball, launch.Vector("position"), launch.Vector("velocity"), launch.Vector("spin", Vector3d.Zero), Scenario.OrientationOf(launch));
    }
}
