namespace FootballPhysics.Labs.Scenes;

/// <summary>The result of the library in one scene, compared with an independent reference.</summary>
/// <param name="Group">The group of scenes that are counted together.</param>
/// <param name="Agrees">True if the library gives the same yes or no: hits, climbs, rests.</param>
/// <param name="Error">The error of a number; 0 if only a yes or no is compared.</param>
/// <param name="Limit">The largest allowed error.</param>
/// <param name="Detail">Numbers for finding the fault.</param>
internal readonly record struct SceneOutcome(string Group, bool Agrees, double Error, double Limit, string Detail)
{
    /// <summary>True if the library is right.</summary>
    public bool Holds => Agrees && Error <= Limit;
}
