namespace FootballPhysics.Scenarios.Input;

/// <summary>The way to a field: launch.velocity, launch.velocity[0], launch.velocity.0.</summary>
public static class FieldPath
{
    /// <summary>Its parts, outermost first.</summary>
    public static string[] Split(string path) => path.Replace("]", "").Split('.', '[');

    /// <summary>The same field is always written the same: launch.velocity.0.</summary>
    public static string Plain(string path) => string.Join('.', Split(path));
}
