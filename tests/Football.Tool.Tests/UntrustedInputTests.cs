using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using FootballPhysics.Netcode;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tests.Support;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Tests;

/// <summary>Files that another person made: docs/internals/threats.md lists the limits.</summary>
public sealed class UntrustedInputTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("football-untrusted-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    /// <summary>Without the check, the merge would write a file next to the folder of the shards.</summary>
    [Theory]
    [InlineData("../escaped.csv")]
    [InlineData("..")]
    [InlineData("a/b.csv")]
    [InlineData("..\\\\escaped.csv")]
    [InlineData("C:escaped.csv")]
    [InlineData("/tmp/escaped.csv")]
    [InlineData("")]
    public void A_manifest_whose_file_is_outside_its_folder_is_refused(string name)
    {
        string manifest = Shard(1, 1);
        string outside = Path.Combine(_folder, "parts", "escaped.csv");
        File.Copy(Path.Combine(Path.GetDirectoryName(manifest)!, "rows.csv"), outside);
        Replace(manifest, "\"rows.csv\"", $"\"{name}\"");
        FootballCommand done = Merge();
        Assert.Equal(1, done.ExitCode);
        Assert.StartsWith("football: files[0].name in ", done.ErrorLine);
        Assert.EndsWith("allowed: the name of a file, without a folder.", done.ErrorLine);
        Assert.Equal([outside], Directory.GetFiles(_folder, "*escaped*", SearchOption.AllDirectories));
    }

    [Fact]
    public void A_column_does_not_lead_out_of_the_folder()
    {
        FootballCommand done = FootballCommand.Run("", "sweep", "--count", "2", "--format", "npy", "--out", Path.Combine(_folder, "rows"), "--range", "air./../../../escaped=[1,2]");
        Assert.NotEqual(0, done.ExitCode);
        Assert.Empty(Directory.GetFiles(_folder, "*", SearchOption.AllDirectories));
    }

    [Theory]
    [InlineData("\"of\": 1", "\"of\": 2147483647", "shard.of in ", "is 2147483647; allowed: 1 … 1000000.")]
    [InlineData("\"index\": 1", "\"index\": 2", "shard.index in ", "is 2; allowed: 1.")]
    [InlineData("\"first\": 0", "\"first\": 7", "shard.first in ", "is 7; allowed: 0.")]
    [InlineData("\"rows\": 20", "\"rows\": 1000000000", "rows in ", "is 1000000000; allowed: 0 … 20.")]
    [InlineData("\"count\": 20", "\"count\": 9223372036854775807", "count in ", "is 9223372036854775807; allowed: 1 … 1000000000000000.")]
    [InlineData("\"header\": ", "\"header\": 9", "files[0].header in ", ".")]
    [InlineData("\"bytes\": ", "\"bytes\": -", "files[0].bytes in ", " … 9223372036854775807.")]
    public void A_manifest_with_a_number_out_of_range_is_refused(string from, string to, string begins, string ends)
    {
        Replace(Shard(1, 1), from, to);
        FootballCommand done = Merge();
        Assert.Equal(1, done.ExitCode);
        Assert.StartsWith($"football: {begins}", done.ErrorLine);
        Assert.EndsWith(ends, done.ErrorLine);
    }

    [Fact]
    public void A_manifest_with_other_files_than_the_first_or_without_end_is_refused()
    {
        Shard(1, 2);
        string second = Shard(2, 2);
        Replace(second, "\"schema.json\"", "\"rows.csv\"");
        Assert.Contains("shard-2-of-2 has other files than shard-1-of-2.", Merge().Error);

        using (FileStream file = File.OpenWrite(second))
        {
            file.SetLength((1L << 26) + 1);
        }

        Assert.EndsWith("is 67108865 bytes; allowed: at most 67108864 bytes.", Merge().ErrorLine);
    }

    [Fact]
    public void A_track_without_end_is_refused_after_its_limit()
    {
        using var endless = new EndlessStream();
        var refusal = Assert.Throws<RefusedException>(() => TrackText.Read(endless, 1 << 20));
        Assert.Equal("TRACK is more than 1048576 bytes; allowed: at most 1048576 bytes.", refusal.Message);
        Assert.InRange(endless.Given, 1 << 20, (1 << 20) + (1 << 16));
    }

    /// <summary>Each moment has a member of its own: a table of them would have a billion cells.</summary>
    [Fact]
    public void A_JSON_track_of_ever_new_members_is_refused()
    {
        string track = "[" + string.Join(',', Enumerable.Range(0, 30_000).Select(i => FormattableString.Invariant($"{{\"t{i}\":1}}"))) + "]";
        long before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Equal("football: TRACK is JSON with more than 1000 different members; allowed: at most 1000.", Fit(track));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 27);
    }

    [Theory]
    [InlineData("[{\"t\":\"\\ud800\"}]", "football: TRACK is not valid JSON (")]
    [InlineData("[{\"\\ud800\":1}]", "football: TRACK is not valid JSON (")]
    [InlineData("<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/hostname\">]><FrameSet TeamId=\"BALL\"><Frame T=\"&e;\"/></FrameSet>", "football: TRACK is not valid XML (")]
    public void A_track_with_half_a_character_or_an_entity_of_XML_is_refused(string track, string begins) => Assert.StartsWith(begins, Fit(track));

    [Fact]
    public void A_track_nested_without_end_is_refused() => Assert.StartsWith("football: TRACK is not valid JSON (", Fit("[{\"t\":" + new string('[', 100_000)));

    /// <summary>A record of ZIP64 may name another list of files than the one that was checked.</summary>
    [Theory]
    [InlineData(4)]
    [InlineData(10)]
    public void A_bundle_in_the_format_ZIP64_is_refused(int field)
    {
        byte[] bundle = new FixedStepRunner().Record().ToBundle(new Simulator());
        BinaryPrimitives.WriteUInt16LittleEndian(bundle.AsSpan(bundle.Length - 22 + field), ushort.MaxValue);
        string file = Path.Combine(_folder, "match.zip");
        File.WriteAllBytes(file, bundle);
        Assert.Equal("football: FILE is a ZIP64 file. Pass a bundle that Recording.ToBundle wrote.", FootballCommand.Run("", "bundle", file).ErrorLine);
    }

    /// <summary>The names of a scenario appear as text: not as elements, and not as marks of the page's parts.</summary>
    [Theory]
    [InlineData("<script>alert(1)</script>")]
    [InlineData("\\\"><img src=x onerror=alert(1)>")]
    [InlineData("{{script}}")]
    [InlineData("{{data}}")]
    [InlineData("a\\u0001b")]
    public void A_name_of_a_scenario_is_text_in_every_output(string name)
    {
        string page = Path.Combine(_folder, "replay.html");
        string drawing = Path.Combine(_folder, "replay.svg");
        string scenario = """{"name":"NAME","scenario":{"launch":{"position":[0,0.11,0],"velocity":[1,6,-20]},"obstacles":[{"name":"NAME","shape":"box","center":[0,1,-9],"halfSize":[1,1,0.1]}]}}"""
            .Replace("NAME", name, StringComparison.Ordinal);
        FootballCommand done = FootballCommand.Run(scenario, "replay", "-", "-o", page, "--svg", drawing, "--gltf", Path.Combine(_folder, "replay.gltf"));
        Assert.True(done.ExitCode == 0, done.Error);
        string html = File.ReadAllText(page);
        string svg = File.ReadAllText(drawing);
        foreach (string text in (string[])[html, svg])
        {
            Assert.DoesNotContain("<script>alert", text);
            Assert.DoesNotContain("<img", text);
        }

        string plain = System.Text.Json.JsonSerializer.Deserialize<string>($"\"{name}\"")!;
        Assert.Contains($"<title>{System.Net.WebUtility.HtmlEncode(plain)}</title>", html);
        Assert.Equal(plain.Replace('\u0001', '\uFFFD'), System.Xml.Linq.XDocument.Parse(svg).Root!.Attribute("aria-label")!.Value);
    }

    [Theory]
    [InlineData("simulate")]
    [InlineData("sweep")]
    public void A_run_that_takes_days_is_refused(string command)
    {
        string launch = command == "simulate" ? "\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0]}," : "";
        FootballCommand done = FootballCommand.Run($"{{{launch}\"solver\":{{\"timeStep\":1e-6}},\"stop\":{{\"at\":\"time\",\"time\":2000}}}}", command, "-");
        Assert.Equal("football: stop.time / solver.timeStep × balls is 2000000000 steps; allowed: at most 1000000000 steps.", done.ErrorLine);
    }

    /// <summary>Every test that the page names exists.</summary>
    [Fact]
    public void The_page_of_threats_names_tests_that_exist()
    {
        string[] named = [.. System.Text.RegularExpressions.Regex.Matches(RepositoryFiles.Text("docs/internals/threats.md"), @"`(\w+Tests\.\w+)`").Select(match => match.Groups[1].Value)];
        Assert.InRange(named.Length, 25, 100);
        string[] files = Directory.GetFiles(Path.Combine(RepositoryFiles.Root, "tests"), "*Tests.cs", SearchOption.AllDirectories);
        Assert.All(named, name =>
        {
            string[] parts = name.Split('.');
            Assert.Contains(files.Where(file => Path.GetFileNameWithoutExtension(file) == parts[0]), file => File.ReadAllText(file).Contains($" {parts[1]}(", StringComparison.Ordinal));
        });
    }

    private static string Fit(string track) => FootballCommand.Run(Encoding.UTF8.GetBytes(track), "fit", "--match", "-").ErrorLine;

    private static void Replace(string file, string from, string to)
    {
        string text = File.ReadAllText(file);
        int at = text.IndexOf(from, StringComparison.Ordinal);
        Assert.True(at >= 0, text);
        File.WriteAllText(file, string.Concat(text.AsSpan(0, at), to, text.AsSpan(at + from.Length)));
    }

    private FootballCommand Merge() => FootballCommand.Run("", "sweep", "merge", Path.Combine(_folder, "parts"));

    /// <summary>Makes a shard; returns its manifest.</summary>
    private string Shard(int index, int of)
    {
        string part = string.Create(CultureInfo.InvariantCulture, $"{index}/{of}");
        FootballCommand done = FootballCommand.Run("", "sweep", "--count", "20", "--format", "csv", "--out", Path.Combine(_folder, "parts"), "--shard", part);
        Assert.True(done.ExitCode == 0, done.Error);
        string folder = Path.Combine(_folder, "parts", string.Create(CultureInfo.InvariantCulture, $"shard-{index}-of-{of}"));
        return Path.Combine(folder, "manifest.json");
    }

    /// <summary>Letters without end, as standard input may give.</summary>
    private sealed class EndlessStream : Stream
    {
        public long Given { get; private set; }

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position { get => throw new NotSupportedException(); set => throw new NotSupportedException(); }

        public override int Read(byte[] buffer, int offset, int count)
        {
            buffer.AsSpan(offset, count).Fill((byte)'a');
            Given += count;
            return count;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    }
}
