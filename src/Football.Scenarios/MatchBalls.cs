using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>The balls of a match, and the material of contacts between them.</summary>
/// <param name="Kinds">The balls; empty if all are the ball of the scene.</param>
/// <param name="Contact">The material.</param>
public sealed record MatchBalls(IReadOnlyList<BallProperties> Kinds, SurfaceMaterial Contact)
{
    /// <summary>Reads the members "balls", whose items have a ball, and "ballContact".</summary>
    /// <param name="root">The input.</param>
    /// <param name="common">The ball of items without one.</param>
    public static MatchBalls Of(InputObject root, BallProperties common)
    {
        Profile profile = root.Choice("profile", Profile.Measured);
        IReadOnlyList<InputObject> items = root.Objects("balls");
        root.Demand("balls", !root.Has("balls") || items.Count > 0, "one ball or more");
        return new MatchBalls(
            [.. items.Select(item => item.Has("ball") ? Own(item, profile) ?? common : common)],
            WorldInput.Material(root.Object("ballContact"), SurfaceMaterial.Ball));
    }

    private static BallProperties? Own(InputObject item, Profile profile)
    {
        BallProperties ball = SceneInput.Ball(item.Object("ball"), profile);
        return item.Make(() =>
        {
            ball.Validate();
            return ball;
        });
    }

    /// <summary>Creates a group of the balls.</summary>
    /// <param name="scene">The scene of the balls.</param>
    /// <param name="settings">The solver.</param>
    /// <param name="count">The number of balls.</param>
    /// <exception cref="RefusedException">The number of balls differs from the given number.</exception>
    public BallGroup Group(Scene scene, SolverSettings settings, int count)
    {
        if (Kinds.Count > 0 && Kinds.Count != count)
        {
            throw new RefusedException("balls", FormattableString.Invariant($"{Kinds.Count} balls"), FormattableString.Invariant($"{count}, the number of balls of the match; or leave it out"));
        }

        return Kinds.Count > 0 ? new BallGroup(scene, Kinds, settings, Contact) : new BallGroup(new Simulator(scene, settings), count, Contact);
    }
}
