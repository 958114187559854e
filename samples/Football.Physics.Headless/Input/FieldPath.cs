namespace Football.Physics.Headless.Input;

/// <summary>The way to a field: launch.velocity, launch.velocity[0], launch.velocity.0.</summary>
internal static class FieldPath
{
    /// <summary>Its parts, outermost first.</summary>
    public static string[] Split(string path) => path.Replace("]", "").Split('.', '[');
}
