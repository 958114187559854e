namespace FootballPhysics.Labs.Scenes;

/// <summary>How the library did in one scene, against an independent answer.</summary>
/// <param name="Group">Scenes that are counted together.</param>
/// <param name="Agrees">True if the library gives the same yes or no: hits, climbs, rests.</param>
/// <param name="Error">The error of a number; 0 if only a yes or no is compared.</param>
/// <param name="Limit">The largest error that holds.</param>
/// <param name="Detail">Numbers to find the fault with.</param>
internal readonly record struct SceneOutcome(string Group, bool Agrees, double Error, double Limit, string Detail)
{
    /// <summary>True if the library is right.</summary>
    public bool Holds => Agrees && Error <= Limit;
}
