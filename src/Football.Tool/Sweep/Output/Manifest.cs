using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>The content of a folder: the sweep, the shard, the number of rows and the files.</summary>
/// <param name="Identity">The sweep.</param>
/// <param name="Shard">The part of the sweep.</param>
/// <param name="Rows">The number of rows written; in a finished folder, that of the part.</param>
/// <param name="Counts">The counts of these rows.</param>
/// <param name="Files">The files.</param>
internal sealed record Manifest(Identity Identity, Shard Shard, long Rows, RowCounts Counts, IReadOnlyList<FileRecord> Files)
{
    /// <summary>The name of the file in a finished folder.</summary>
    public const string Done = "manifest.json";

    /// <summary>The name of the file in an unfinished folder.</summary>
    public const string Unfinished = "checkpoint.json";

    /// <summary>The suffix of a file name while the file is written.</summary>
    public const string New = ".new";

    /// <summary>The maximum number of rows of a sweep: up to it, every index is exact.</summary>
    public const long MostRows = 1_000_000_000_000_000;

    /// <summary>The maximum number of shards of a sweep.</summary>
    public const int MostShards = 1_000_000;

    /// <summary>The maximum length of the file, in bytes.</summary>
    private const long LongestFile = 1 << 26;

    private static readonly JsonWriterOptions s_options = new() { Indented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>Reads the file; null if it does not exist.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="name">The name of the file.</param>
    /// <exception cref="RefusedException">The file is not a manifest.</exception>
    public static Manifest? Read(string folder, string name)
    {
        string path = Path.Combine(folder, name);
        if (!File.Exists(path))
        {
            return null;
        }

        long length = new FileInfo(path).Length;
        if (length > LongestFile)
        {
            throw new RefusedException(Quote.File(path), FormattableString.Invariant($"{length} bytes"), FormattableString.Invariant($"at most {LongestFile} bytes"));
        }

        try
        {
            using var document = JsonDocument.Parse(File.ReadAllBytes(path));
            JsonElement root = document.RootElement;
            JsonElement shard = root.GetProperty("shard");
            var identity = Identity.Read(root);
            var part = new Shard(shard.GetProperty("index").GetInt32(), shard.GetProperty("of").GetInt32(), identity.Count);
            Check(path, "count", identity.Count, 1, MostRows);
            Check(path, "shard.of", part.Of, 1, MostShards);
            Check(path, "shard.index", part.Index, 1, part.Of);
            Check(path, "shard.first", shard.GetProperty("first").GetInt64(), part.First, part.First);
            FileRecord[] files = [.. root.GetProperty("files").EnumerateArray().Select((file, i) => ReadFile(path, i, file))];
            long rows = root.GetProperty("rows").GetInt64();

            // A row has at least one byte in each data file. More rows than bytes would need a footer that fills the memory.
            Check(path, "rows", rows, 0, files.Where(file => file.Name != Schema.Name).Select(file => file.Bytes).Append(part.Rows).Min());
            return new Manifest(identity, part, rows, CountsOf(root), files);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException or KeyNotFoundException or FormatException)
        {
            throw new RefusedException($"{Quote.File(path)} is not the manifest of a sweep. Use one that football sweep wrote.");
        }
    }

    /// <summary>Writes the file atomically: a reader sees the new content or the old one.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="name">The name of the file.</param>
    /// <param name="toDisk">True to wait until the file is on the disk.</param>
    public void Write(string folder, string name, bool toDisk)
    {
        string path = Path.Combine(folder, name);
        string whole = path + New;
        File.Delete(whole);
        using (var file = new FileStream(whole, FileMode.CreateNew, FileAccess.Write))
        {
            file.Write(Text());
            file.Flush(toDisk);
        }

        File.Move(whole, path, overwrite: true);
    }

    private static RowCounts CountsOf(JsonElement root)
    {
        bool has = root.TryGetProperty("unknownOutcomes", out JsonElement unknown);
        long? Unknown(string name) => has ? unknown.GetProperty(name).GetInt64() : null;
        return new RowCounts(
            root.TryGetProperty("handedOn", out JsonElement handedOn) ? handedOn.GetInt64() : null, Unknown("stillMoving"), Unknown("tooManyEvents"), Unknown("overflowed"));
    }

    private static FileRecord ReadFile(string path, int index, JsonElement file)
    {
        // The file may come from another person: a name must not lead out of the folder, whatever separators the system uses.
        string name = file.GetProperty("name").GetString() ?? "";
        if (name.Length == 0 || name is "." or ".." || name.AsSpan().IndexOfAny("/\\:\0") >= 0)
        {
            throw new RefusedException(FormattableString.Invariant($"files[{index}].name in {Quote.File(path)}"), Quote.File(name), "the name of a file, without a folder");
        }

        long bytes = file.GetProperty("bytes").GetInt64();
        int header = file.GetProperty("header").GetInt32();
        Check(path, FormattableString.Invariant($"files[{index}].bytes"), bytes, 0, long.MaxValue);
        Check(path, FormattableString.Invariant($"files[{index}].header"), header, 0, bytes);
        return new FileRecord(name, bytes, header, file.GetProperty("sha256").GetString() ?? "");
    }

    private static void Check(string path, string field, long value, long low, long high)
    {
        if (value < low || value > high)
        {
            throw new RefusedException($"{field} in {Quote.File(path)}", FormattableString.Invariant($"{value}"), low == high ? FormattableString.Invariant($"{low}") : FormattableString.Invariant($"{low} … {high}"));
        }
    }

    private ReadOnlySpan<byte> Text()
    {
        var text = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(text, s_options))
        {
            json.WriteStartObject();
            Identity.WriteTo(json);
            json.WriteStartObject("shard");
            json.WriteNumber("index", Shard.Index);
            json.WriteNumber("of", Shard.Of);
            json.WriteNumber("first", Shard.First);
            json.WriteEndObject();
            json.WriteNumber("rows", Rows);
            if (Counts.HandedOn is { } handedOn)
            {
                json.WriteNumber("handedOn", handedOn);
            }

            if (Counts is { StillMoving: { } moving, TooManyEvents: { } events, Overflowed: { } overflowed })
            {
                json.WriteStartObject("unknownOutcomes");
                json.WriteNumber("stillMoving", moving);
                json.WriteNumber("tooManyEvents", events);
                json.WriteNumber("overflowed", overflowed);
                json.WriteEndObject();
            }

            json.WriteStartArray("files");
            foreach (FileRecord file in Files)
            {
                json.WriteStartObject();
                json.WriteString("name", file.Name);
                json.WriteNumber("bytes", file.Bytes);
                json.WriteNumber("header", file.Header);
                json.WriteString("sha256", file.Sha256);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        text.Write("\n"u8);
        return text.WrittenSpan;
    }
}
