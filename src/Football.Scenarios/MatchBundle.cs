using System.Buffers.Binary;
using System.Globalization;
using System.IO.Compression;
using System.Text.Json;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>A recorded match in a zip file, as <see cref="Recording.ToBundle"/> writes it for an issue.</summary>
public sealed class MatchBundle
{
    /// <summary>The maximum size of a bundle, in bytes.</summary>
    public const int LargestFile = 1 << 26;

    /// <summary>The maximum size of the unpacked text, in bytes. A scene with a fine ground takes some megabytes.</summary>
    private const int LargestAbout = 1 << 23;

    /// <summary>The maximum size of the unpacked match, in bytes: hours of one ball, or of players who move in every tick.</summary>
    private const int LargestSegment = 1 << 26;

    /// <summary>The maximum number of files in a bundle. It may contain other files than the two of a match.</summary>
    private const int MostEntries = 64;

    /// <summary>The maximum size of the list of these files, in bytes.</summary>
    private const int LongestDirectory = 1 << 16;

    /// <summary>The size of the last record of a zip file without its comment, in bytes.</summary>
    private const int EndRecord = 22;

    /// <summary>The maximum length of a text that describes the origin, in characters.</summary>
    private const int LongestText = 200;

    private readonly JsonElement _about;

    private MatchBundle(JsonElement about, Recording segment)
    {
        _about = about;
        Segment = segment;
        InputObject root = new InputFields(about).Root;
        Library = OriginText(root, "library");
        Runtime = OriginText(root, "runtime");
        System = OriginText(root, "system");
    }

    /// <summary>The version of the library that recorded the match.</summary>
    public string Library { get; }

    /// <summary>The runtime during the recording.</summary>
    public string Runtime { get; }

    /// <summary>The operating system and the processor architecture during the recording.</summary>
    public string System { get; }

    /// <summary>The recorded match.</summary>
    public Recording Segment { get; }

    /// <summary>Reads a bundle.</summary>
    /// <param name="file">The zip file; must support seeking.</param>
    /// <exception cref="RefusedException">The file is not a bundle; the message gives the reason.</exception>
    public static MatchBundle Read(Stream file)
    {
        try
        {
            if (file.Length > LargestFile)
            {
                throw new RefusedException("FILE", FormattableString.Invariant($"{file.Length} bytes"), FormattableString.Invariant($"at most {LargestFile} bytes"));
            }

            CheckDirectory(file);
            using var zip = new ZipArchive(file, ZipArchiveMode.Read);
            if (zip.Entries.Count > MostEntries)
            {
                throw new RefusedException("FILE", FormattableString.Invariant($"a zip file of {zip.Entries.Count} files"), FormattableString.Invariant($"at most {MostEntries}"));
            }

            byte[] about = Entry(zip, "match.json", LargestAbout);
            if (JsonText.Parse(about, out JsonElement root) is { } fault)
            {
                throw new RefusedException("match.json", fault.Value, fault.Expected);
            }

            var match = Recording.FromBytes(Entry(zip, "match.segment", LargestSegment));
            return !match.HasMovingColliders
                ? new MatchBundle(root, match)
                : throw new RefusedException("match.segment is a match with moving colliders of an engine. Pass a bundle that Recording.ToBundle wrote.");
        }
        catch (InvalidDataException)
        {
            throw new RefusedException("FILE is not a zip file. Pass a bundle that Recording.ToBundle wrote.");
        }
        catch (FormatException broken)
        {
            throw new RefusedException($"match.segment: {broken.Message}");
        }
    }

    /// <summary>Creates the scene of the match with its own bodies. Create one for each replay.</summary>
    /// <exception cref="RefusedException">The scene is invalid or differs from the recorded one, or no ball of the scene can have the recorded states; the message names the field.</exception>
    public Simulator NewSimulator()
    {
        var fields = new InputFields(_about);
        InputObject root = fields.Root;
        foreach (string name in (string[])["library", "runtime", "system", "sceneHash"])
        {
            root.Text(name, "");
        }

        Simulator simulator;
        try
        {
            SolverSettings settings = SceneInput.Solver(root, out _);
            Scene scene = SceneInput.Scene(root.Object("scene")) with { Bodies = WorldInput.Bodies(root) };
            fields.Check();
            simulator = new Simulator(scene, settings);
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, fields, "scene") is { } translated)
        {
            throw translated;
        }

        if (simulator.SceneHash != Segment.SceneHash)
        {
            throw new RefusedException(
                "sceneHash",
                simulator.SceneHash.ToString("x16", CultureInfo.InvariantCulture),
                $"{Segment.SceneHash.ToString("x16", CultureInfo.InvariantCulture)}, that of the match: its scene is not all in match.json, or is another one in this version of the library");
        }

        try
        {
            // The bytes may have the hash of a scene that did not produce them.
            Segment.Replay(simulator);
        }
        catch (ArgumentException refusal)
        {
            throw new RefusedException($"match.segment: {LibraryRefusal.Sentence(refusal)}");
        }

        return simulator;
    }

    /// <summary>Returns a text about the origin of the bundle, on one line.</summary>
    private static string OriginText(InputObject root, string name) => Quote.Short(root.Text(name, ""), LongestText);

    /// <summary>Rejects a zip file whose list of files is too long before the list is read. A file of 64 MB can list a million files.</summary>
    private static void CheckDirectory(Stream file)
    {
        // The last record of a zip file contains the offset of the list at byte 16; a comment of at most 65 535 bytes follows the record.
        byte[] end = new byte[Math.Min(file.Length, EndRecord + ushort.MaxValue)];
        file.Position = file.Length - end.Length;
        file.ReadExactly(end);
        int at = end.AsSpan().LastIndexOf("PK\u0005\u0006"u8);
        file.Position = 0;
        if (at < 0 || end.Length - at < EndRecord)
        {
            throw new InvalidDataException();
        }

        // If the disk number or the file count has all bits set, a ZIP64 record specifies another list.
        if (BinaryPrimitives.ReadUInt16LittleEndian(end.AsSpan(at + 4)) == ushort.MaxValue || BinaryPrimitives.ReadUInt16LittleEndian(end.AsSpan(at + 10)) == ushort.MaxValue)
        {
            throw new RefusedException("FILE is a ZIP64 file. Pass a bundle that Recording.ToBundle wrote.");
        }

        long list = BinaryPrimitives.ReadUInt32LittleEndian(end.AsSpan(at + 16));
        long length = file.Length - (end.Length - at) - list;
        if (length is < 0 or > LongestDirectory)
        {
            throw new RefusedException("FILE", FormattableString.Invariant($"a zip file with {length} bytes before the end of its list of files"), FormattableString.Invariant($"at most {LongestDirectory}"));
        }
    }

    private static byte[] Entry(ZipArchive zip, string name, int largest)
    {
        ZipArchiveEntry entry = zip.GetEntry(name) ?? throw new RefusedException($"FILE is a zip file without {name}. Pass a bundle that Recording.ToBundle wrote.");
        if (entry.Length > largest)
        {
            throw new RefusedException(name, FormattableString.Invariant($"{entry.Length} bytes"), FormattableString.Invariant($"at most {largest} bytes"));
        }

        // Read until the data ends or exceeds the stated length, because the zip file may state any length.
        using Stream from = entry.Open();
        using var bytes = new MemoryStream();
        var part = new byte[64 * 1024];
        for (int read = from.Read(part); read > 0 && bytes.Length <= entry.Length; read = from.Read(part))
        {
            bytes.Write(part, 0, read);
        }

        return bytes.Length == entry.Length ? bytes.ToArray() : throw new RefusedException(name, $"{bytes.Length} bytes", $"{entry.Length}, as the zip file says");
    }
}
