using System.Buffers;
using System.Reflection;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Replay;

/// <summary>An animated page of shots that needs no other file.</summary>
internal static partial class ReplayPage
{
    /// <summary>The scripts of the page, in the order of their dependencies.</summary>
    private static readonly string[] Scripts = ["vectors.js", "track.js", "camera.js", "ball.js", "figures.js", "stadium.js", "stage.js", "player.js"];

    /// <summary>Returns the page.</summary>
    public static string Html(string title, IReadOnlyList<ReplayPicture> pictures)
    {
        // Replace all marks in one pass, because a name may contain the mark of another part.
        return Mark().Replace(Part("page.html"), mark => mark.Groups[1].Value switch
        {
            "title" => System.Net.WebUtility.HtmlEncode(title),
            "style" => Part("style.css"),
            "figures" => Part("figures.json"),
            "script" => string.Concat(Scripts.Select(Part)),
            _ => Encoding.UTF8.GetString(Data(title, pictures)),
        });
    }

    [GeneratedRegex("\\{\\{(title|style|figures|script|data)\\}\\}", RegexOptions.CultureInvariant)]
    private static partial Regex Mark();

    private static string Part(string name)
    {
        using Stream part = Assembly.GetExecutingAssembly().GetManifestResourceStream("Replay.Page." + name)!;
        return new StreamReader(part).ReadToEnd();
    }

    /// <summary>Returns the pictures as JSON for the script of the page.</summary>
    private static ReadOnlySpan<byte> Data(string title, IReadOnlyList<ReplayPicture> pictures)
    {
        var buffer = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            json.WriteString("title", title);
            json.WriteStartArray("pictures");
            foreach (ReplayPicture picture in pictures)
            {
                Write(json, picture);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        return buffer.WrittenSpan;
    }

    private static void Write(Utf8JsonWriter json, ReplayPicture picture)
    {
        json.WriteStartObject();
        json.WriteString("id", picture.Id);
        json.WriteString("name", picture.Name);
        json.WriteString("about", picture.About);
        if (picture.Ground is { } ground)
        {
            json.WriteStartObject("ground");
            json.WriteNumber("x", ground.X);
            json.WriteNumber("z", ground.Z);
            json.WriteNumber("cell", ground.Cell);
            json.WriteNumber("columns", ground.Columns);
            json.WriteNumber("rows", ground.Rows);
            SceneShapeJson.WriteNumbers(json, "heights", ground.Heights);
            json.WriteEndObject();
        }

        SceneShapeJson.Write(json, picture.Shapes, picture.Goals);
        WriteAll(json, "shots", picture.Shots, Write);
        SceneShapeJson.WriteNumbers(json, "keeper", picture.Keeper.SelectMany(pose => (double[])[pose.Time, .. pose.Skeleton.Take(3).SelectMany(SceneShapeJson.Parts)]));
        SceneShapeJson.WriteNumbers(json, "targets", picture.Targets.SelectMany(SceneShapeJson.Parts));
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, ReplayShot shot)
    {
        json.WriteStartObject();
        json.WriteString("name", shot.Name);
        json.WriteString("kick", shot.Kick);
        json.WriteBoolean("compares", shot.Compares);
        json.WriteNumber("radius", shot.Track.Radius);
        SceneShapeJson.WriteNumbers(json, "keys", shot.Track.Keys.SelectMany(Parts));
        SceneShapeJson.WriteNumbers(json, "nets", shot.Nets.SelectMany(move => (double[])[move.Time, move.Net, move.Bulge.Depth, .. SceneShapeJson.Parts(move.Bulge.Position), .. SceneShapeJson.Parts(move.Bulge.Direction)]));
        WriteAll(json, "events", shot.Track.Events, (to, item) =>
        {
            to.WriteStartObject();
            to.WriteString("kind", Words.Of(item.Kind));
            to.WriteString("surface", shot.Track.SurfaceOf(item));
            to.WriteNumber("time", SceneShapeJson.Rounded(item.Time));
            SceneShapeJson.WriteNumbers(to, "position", SceneShapeJson.Parts(item.Position));
            to.WriteNumber("before", SceneShapeJson.Rounded(item.VelocityBefore.Length));
            to.WriteNumber("after", SceneShapeJson.Rounded(item.Velocity.Length));
            to.WriteNumber("spin", SceneShapeJson.Rounded(item.Spin.Length));
            to.WriteEndObject();
        });
        json.WriteEndObject();
    }

    private static void WriteAll<T>(Utf8JsonWriter json, string name, IReadOnlyList<T> items, Action<Utf8JsonWriter, T> write)
    {
        json.WriteStartArray(name);
        foreach (T item in items)
        {
            write(json, item);
        }

        json.WriteEndArray();
    }

    private static IEnumerable<double> Parts(TrackKey key) =>
    [
        key.Time, .. SceneShapeJson.Parts(key.Position), .. SceneShapeJson.Parts(key.VelocityBefore), .. SceneShapeJson.Parts(key.Velocity), .. SceneShapeJson.Parts(key.Spin),
        key.Orientation.X, key.Orientation.Y, key.Orientation.Z, key.Orientation.W, (int)key.Motion,
    ];
}
