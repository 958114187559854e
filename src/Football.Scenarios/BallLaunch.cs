using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>One of several balls, and its launch.</summary>
/// <param name="Ball">The ball.</param>
/// <param name="Position">The position at the start, in m.</param>
/// <param name="Velocity">The velocity, in m/s.</param>
/// <param name="Spin">The spin, in rad/s.</param>
/// <param name="Orientation">The orientation; null for that of a launch without one.</param>
public sealed record BallLaunch(BallProperties Ball, Vector3d Position, Vector3d Velocity, Vector3d Spin, Quaterniond? Orientation)
{
    /// <summary>Reads the launches of all balls.</summary>
    /// <param name="root">The scenario.</param>
    /// <param name="common">The ball of launches that do not give one.</param>
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
