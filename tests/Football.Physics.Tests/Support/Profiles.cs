namespace FootballPhysics.Tests.Support;

/// <summary>What every claim about any ball is tried with: what a game gets that says nothing, and the thesis' laws.</summary>
public enum Profile
{
    Default,
    Published,
}

/// <summary>The scenes of the profiles.</summary>
internal static class Profiles
{
    /// <summary>The ball of the wind tunnels on dry turf, by the measured laws: what cases with fixed numbers were made for.</summary>
    public static Scene Tunnel { get; } = new() { Ball = BallProperties.Tunnel, Ground = FootballPhysics.Ground.Of(SurfaceMaterial.DryTurf) };

    public static Profile[] All { get; } = Enum.GetValues<Profile>();

    public static Scene Scene(this Profile profile) => profile == Profile.Default ? new Scene() : FootballPhysics.Scene.Published;

    public static ForceSet Forces(this Profile profile) => profile.Scene().Forces;

    /// <summary>The forces of the profile, or what is smooth of them: the thesis' drag jumps, which no order survives.</summary>
    public static ForceSet SmoothForces(this Profile profile) => profile == Profile.Default ? profile.Forces() : ForceSet.Regularized;

    public static Ground Ground(this Profile profile) => profile.Scene().Ground;
}
