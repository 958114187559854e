namespace FootballPhysics.Scenarios.Input;

/// <summary>The path of a field, such as launch.velocity, launch.velocity[0] or launch.velocity.0.</summary>
public static class FieldPath
{
    /// <summary>Splits a path into its parts, outermost first.</summary>
    public static string[] Split(string path) => path.Replace("]", "").Split('.', '[');

    /// <summary>Returns the canonical form of a path, such as launch.velocity.0.</summary>
    public static string Plain(string path) => string.Join('.', Split(path));
}
