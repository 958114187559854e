using System.Text.Json;

namespace FootballPhysics.Tool.Replay;

/// <summary>Writes shapes and goals for the scripts of pages.</summary>
internal static class SceneShapeJson
{
    /// <summary>Writes "shapes" and "goals" of a picture.</summary>
    public static void Write(Utf8JsonWriter json, IEnumerable<SceneShape> shapes, IEnumerable<Goal> goals)
    {
        json.WriteStartArray("shapes");
        foreach (SceneShape shape in shapes)
        {
            json.WriteStartObject();
            json.WriteString("name", shape.Name);
            json.WriteString("kind", shape.People is null ? KindOf(shape.Kind) : "people");
            json.WriteNumber("radius", shape.Radius);
            WriteNumbers(json, "velocity", Parts(shape.Velocity));
            WriteAll(json, "lines", shape.People ?? (shape.Corners is null ? shape.Lines : []));
            WriteAll(json, "faces", shape.Corners is { } corners ? [[.. corners]] : shape.People is null ? shape.Faces : []);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("goals");
        foreach (Goal goal in goals)
        {
            json.WriteStartObject();
            WriteNumbers(json, "center", Parts(goal.Center));
            WriteNumbers(json, "facing", Parts(goal.Facing));
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <summary>Writes an array of numbers, rounded to a hundredth of a millimetre and without negative zeros.</summary>
    public static void WriteNumbers(Utf8JsonWriter json, string name, IEnumerable<double> numbers)
    {
        json.WritePropertyName(name);
        WriteNumbers(json, numbers);
    }

    private static void WriteAll(Utf8JsonWriter json, string name, IReadOnlyList<Vector3d[]> lines)
    {
        json.WriteStartArray(name);
        foreach (Vector3d[] line in lines)
        {
            WriteNumbers(json, line.SelectMany(Parts));
        }

        json.WriteEndArray();
    }

    private static void WriteNumbers(Utf8JsonWriter json, IEnumerable<double> numbers)
    {
        json.WriteStartArray();
        foreach (double number in numbers)
        {
            json.WriteNumberValue(Rounded(number));
        }

        json.WriteEndArray();
    }

    /// <summary>Returns the coordinates of a vector.</summary>
    public static double[] Parts(Vector3d v) => [v.X, v.Y, v.Z];

    /// <summary>Rounds to a hundredth of a millimetre, and removes the sign of zero.</summary>
    public static double Rounded(double value) => Math.Round(value, 5) + 0.0;

    private static string KindOf(SceneShapeKind kind) => kind switch
    {
        SceneShapeKind.Frame => "frame",
        SceneShapeKind.Net => "net",
        SceneShapeKind.Obstacle => "obstacle",
        SceneShapeKind.Marking => "marking",
        SceneShapeKind.Guide => "guide",
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, null),
    };
}
