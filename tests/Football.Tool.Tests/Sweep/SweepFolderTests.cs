using System.Buffers;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep;
using FootballPhysics.Tool.Sweep.Output;
using FootballPhysics.Tool.Sweep.Rows;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tool.Tests.Sweep;

/// <summary>football sweep --out: files, shards, interruptions.</summary>
public sealed class SweepFolderTests : IDisposable
{
    private const string Wind = "air.wind[0]={\"list\":[-3,3]}";

    private readonly string _folder = Directory.CreateTempSubdirectory("football-sweep-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Numpy_files_have_the_numbers_of_the_lines()
    {
        Write("npy", "rows", 300);
        JsonElement schema = JsonDocument.Parse(File.ReadAllBytes(At("rows", "schema.json"))).RootElement;
        IReadOnlyList<JsonElement> lines = FootballCommand.Run("", "sweep", "--count", "300", "--range", Wind).Lines;
        foreach (JsonElement column in schema.GetProperty("columns").EnumerateArray())
        {
            byte[] file = File.ReadAllBytes(At("rows", column.GetProperty("file").GetString()!));
            string header = Header(file, out int start);
            string shape = column.TryGetProperty("axes", out _) ? "(300, 3)" : "(300,)";
            Assert.Equal($"{{'descr': '{column.GetProperty("type").GetString()}', 'fortran_order': False, 'shape': {shape}, }}", header.TrimEnd());
            Assert.Equal(0, start % 64);
            string name = column.GetProperty("name").GetString()!;
            string[] values = column.GetProperty("type").GetString() switch
            {
                "<f8" => [.. MemoryMarshal.Cast<byte, double>(file.AsSpan(start)).ToArray().Select(x => x.ToString("R", CultureInfo.InvariantCulture))],
                "<i8" => [.. MemoryMarshal.Cast<byte, long>(file.AsSpan(start)).ToArray().Select(x => x.ToString(CultureInfo.InvariantCulture))],
                _ => [.. file.AsSpan(start).ToArray().Select(x => $"\"{column.GetProperty("words")[x].GetString()}\"")],
            };
            Assert.Equal(
                lines.SelectMany(line => line.GetProperty(name) is { ValueKind: JsonValueKind.Array } vector ? vector.EnumerateArray().Select(x => x.GetRawText()) : [line.GetProperty(name).GetRawText()]),
                values);
        }
    }

    [Fact]
    public void The_manifest_has_the_hash_of_every_file()
    {
        Write("npy", "rows", 300);
        JsonElement manifest = JsonDocument.Parse(File.ReadAllBytes(At("rows", "manifest.json"))).RootElement;
        string[] files = [.. manifest.GetProperty("files").EnumerateArray().Select(file =>
        {
            string name = file.GetProperty("name").GetString()!;
            byte[] bytes = File.ReadAllBytes(At("rows", name));
            Assert.Equal(file.GetProperty("sha256").GetString(), Convert.ToHexStringLower(SHA256.HashData(bytes)));
            Assert.Equal(file.GetProperty("bytes").GetInt64(), bytes.Length);
            return name;
        })];
        Assert.Equal(files.Append("manifest.json").Order(StringComparer.Ordinal), Directory.GetFiles(At("rows")).Select(Path.GetFileName).Order(StringComparer.Ordinal)!);
    }

    [Theory]
    [InlineData("ndjson", 7)]
    [InlineData("csv", 16)]
    [InlineData("npy", 1)]
    [InlineData("npy", 7)]
    [InlineData("npy", 16)]
    public void Shards_merge_to_the_bytes_of_one_process(string format, int shards)
    {
        Write(format, "one", 500, "--jobs", "1");
        for (int i = 1; i <= shards; i++)
        {
            Write(format, "parts", 500, "--shard", $"{i}/{shards}", "--jobs", $"{1 + (i % 2)}");
        }

        Assert.Equal(0, Merge().ExitCode);
        AssertSame("one", "parts");

        // Again, and nothing changes.
        Assert.Equal(0, Merge().ExitCode);
        AssertSame("one", "parts");
    }

    [Fact]
    public void The_lines_of_the_standard_output_are_those_of_the_file()
    {
        Write("csv", "rows", 50);
        Assert.Equal(File.ReadAllText(At("rows", "rows.csv")), FootballCommand.Run("", "sweep", "--count", "50", "--range", Wind, "--format", "csv").Output);
    }

    [Fact]
    public void Missing_doubled_unfinished_and_torn_shards_are_named()
    {
        for (int i = 1; i <= 6; i++)
        {
            Write("npy", "parts", 60, "--shard", $"{i}/6");
        }

        string Shard(int i) => At("parts", $"shard-{i}-of-6");
        Directory.Delete(Shard(1), recursive: true);
        Directory.CreateDirectory(At("parts", "copy"));
        foreach (string file in Directory.GetFiles(Shard(2)))
        {
            File.Copy(file, At("parts", "copy", Path.GetFileName(file)));
        }

        File.Move(Path.Combine(Shard(3), "manifest.json"), Path.Combine(Shard(3), "checkpoint.json"));
        using (var cut = new FileStream(Path.Combine(Shard(4), "time.npy"), FileMode.Open))
        {
            cut.SetLength(cut.Length - 1);
        }

        string other = Path.Combine(Shard(5), "manifest.json");
        File.WriteAllText(other, File.ReadAllText(other).Replace("\"seed\": 1", "\"seed\": 2"));
        string[] told = Merge().Error.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(
            [
                "football: shard-5-of-6 is of another sweep than copy: its seed is 2, not 1.",
                "football: shard 1 of 6 is missing.",
                "football: shard 2 of 6 exists twice: copy, shard-2-of-6.",
                "football: shard 3 of 6 is not finished: shard-3-of-6 has 10 of 10 rows.",
                "football: shard 4 of 6 is incomplete: shard-4-of-6/time.npy has 207 of 208 bytes.",
            ],
            told);
        Assert.False(File.Exists(At("parts", "manifest.json")));
    }

    [Fact]
    public void A_byte_that_has_changed_is_found()
    {
        for (int i = 1; i <= 2; i++)
        {
            Write("csv", "parts", 60, "--shard", $"{i}/2");
        }

        Flip(At("parts", "shard-2-of-2", "rows.csv"), 1000);
        FootballCommand done = Merge();
        Assert.Equal((1, "football: shard 2 of 2 is damaged: shard-2-of-2/rows.csv has other bytes than its manifest says."), (done.ExitCode, done.ErrorLine));
        Assert.Empty(Directory.GetFiles(At("parts")));
    }

    [Fact]
    public void A_merge_that_is_refused_leaves_the_one_before()
    {
        Write("csv", "one", 60);
        for (int i = 1; i <= 2; i++)
        {
            Write("csv", "parts", 60, "--shard", $"{i}/2");
        }

        Assert.Equal(0, Merge().ExitCode);
        Flip(At("parts", "shard-2-of-2", "rows.csv"), 1000);
        Assert.Equal(1, Merge().ExitCode);
        AssertSame("one", "parts");
        Assert.Equal(Directory.GetFiles(At("one")).Length, Directory.GetFiles(At("parts")).Length);
    }

    [Fact]
    public void A_merge_does_not_write_over_an_unfinished_sweep()
    {
        Interrupt("csv", "parts", 500);
        byte[] before = File.ReadAllBytes(At("parts", "rows.csv"));
        for (int i = 1; i <= 2; i++)
        {
            Write("csv", "parts", 500, "--shard", $"{i}/2");
        }

        FootballCommand done = Merge();
        Assert.Equal(1, done.ExitCode);
        Assert.Matches("^football: DIR \".*parts\" contains an unfinished sweep next to its shards. Pass a folder that contains only shards.$", done.ErrorLine);
        Assert.Equal(before, File.ReadAllBytes(At("parts", "rows.csv")));
    }

    [Theory]
    [InlineData("ndjson")]
    [InlineData("csv")]
    [InlineData("npy")]
    public void An_interrupted_run_goes_on_without_a_row_lost_or_doubled(string format)
    {
        Write(format, "one", 500);
        Interrupt(format, "rows", 500);
        Assert.True(File.Exists(At("rows", "checkpoint.json")));
        Assert.False(File.Exists(At("rows", "manifest.json")));
        FootballCommand done = Write(format, "rows", 500);
        Assert.Contains(" 500 rows, 390 of them now in ", done.Error);
        AssertSame("one", "rows");

        // Once it is done, nothing is done again.
        Assert.Contains("all there before", Write(format, "rows", 500).Error);
        AssertSame("one", "rows");
    }

    [Fact]
    public void What_was_written_before_an_interruption_must_still_be_there()
    {
        Interrupt("csv", "rows", 500);
        Flip(At("rows", "rows.csv"), 1000);
        FootballCommand done = Command("csv", "rows", 500);
        Assert.Equal(1, done.ExitCode);
        Assert.Matches("^football: \".*rows.csv\" is damaged: its first [0-9]+ bytes differ from those that were written. ", done.ErrorLine);
    }

    [Fact]
    public void A_folder_of_something_else_is_left_alone()
    {
        Write("csv", "rows", 50);
        FootballCommand other = Command("csv", "rows", 51);
        Assert.Equal(1, other.ExitCode);
        Assert.Matches("^football: --out \".*rows\" contains another sweep \\(its count is 50, not 51\\). ", other.ErrorLine);
        Directory.CreateDirectory(At("mine"));
        File.WriteAllText(At("mine", "rows.csv"), new string('x', 4000));
        Assert.Contains("contains a file of another origin, \"rows.csv\".", Command("csv", "mine", 50).ErrorLine);
    }

    [Fact]
    public void Room_that_is_not_there_is_missed_before_the_first_row()
    {
        FootballCommand done = Command("npy", "rows", 1_000_000_000_000_000);
        Assert.Equal(1, done.ExitCode);
        Assert.Matches("^football: --out is \".*rows\" with [0-9]+ bytes free; allowed: at least the [0-9]+ bytes of these rows.$", done.ErrorLine);
    }

    [Fact]
    public void A_disk_that_becomes_full_is_told_at_once()
    {
        Directory.CreateDirectory(At("rows"));
        File.CreateSymbolicLink(At("rows", "rows.ndjson"), "/dev/full");
        FootballCommand done = Command("ndjson", "rows", 1_000_000_000_000);
        Assert.Equal(1, done.ExitCode);
        Assert.Contains("No space left", done.ErrorLine);
    }

    [Fact]
    public async Task With_registers_of_any_width_the_bytes_are_the_same()
    {
        Shell done = await Shell.RunAsync(
            "football sweep --count 3000 > wide; export DOTNET_EnableAVX512=0 DOTNET_EnableAVX512F=0; football sweep --count 3000 > narrow; DOTNET_EnableAVX=0 football sweep --count 3000 > least; sum=$(sha256sum < wide); [[ $sum == $(sha256sum < narrow) && $sum == $(sha256sum < least) ]] && wc -l < least");
        Assert.Equal(("", "3000\n"), (done.Error, done.Output));
    }

    /// <summary>Writes 110 rows that are certain and 90 that are not, and ends as if it were killed.</summary>
    private void Interrupt(string format, string folder, long count)
    {
        InputCase input = InputCase.Read(new InputLine(Encoding.UTF8.GetBytes("{}"), false), [FieldOverride.ParseRange(Wind)!]);
        SweepPlan plan = SweepInput.Read(input.Scenario!, 1);
        var run = new SweepRun(plan, format, 1);
        Write(format, "program", 1);
        Identity identity = Manifest.Read(At("program"), Manifest.Done)!.Identity with { Count = count };
        using FolderSink sink = FolderSink.Open(At(folder), identity, new Shard(1, 1, count), run.Format, Schema.Text(run.Columns, run.Format), run.NoRows, new StillTime());
        RowMaker maker = RowMaker.Create(plan, 110);
        foreach ((int first, int rows) in (ReadOnlySpan<(int, int)>)[(0, 110), (110, 90)])
        {
            ArrayBufferWriter<byte>[] files = [.. run.Format.Files.Select(_ => new ArrayBufferWriter<byte>())];
            maker.Make(first, rows);
            run.Format.Write(maker.Columns, rows, files);
            sink.Add(files, rows, maker.Counts);
            if (first == 0)
            {
                sink.Checkpoint();
            }
        }
    }

    private FootballCommand Write(string format, string folder, long count, params string[] more)
    {
        FootballCommand done = Command(format, folder, count, more);
        Assert.True(done.ExitCode == 0, done.Error);
        return done;
    }

    private FootballCommand Command(string format, string folder, long count, params string[] more) => FootballCommand.Run(
        "", ["sweep", "--count", count.ToString(CultureInfo.InvariantCulture), "--range", Wind, "--format", format, "--out", At(folder), .. more]);

    private FootballCommand Merge() => FootballCommand.Run("", "sweep", "merge", At("parts"));

    private string At(params string[] path) => Path.Combine([_folder, .. path]);

    private void AssertSame(string one, string other)
    {
        foreach (string file in Directory.GetFiles(At(one)))
        {
            Assert.Equal(File.ReadAllBytes(file), File.ReadAllBytes(At(other, Path.GetFileName(file))));
        }
    }

    private static void Flip(string file, int at)
    {
        byte[] bytes = File.ReadAllBytes(file);
        bytes[at] ^= 1;
        File.WriteAllBytes(file, bytes);
    }

    private static string Header(byte[] file, out int start)
    {
        Assert.Equal("\u0093NUMPY\u0001\0", Encoding.Latin1.GetString(file, 0, 8));
        start = 10 + file[8] + (file[9] << 8);
        return Encoding.Latin1.GetString(file, 10, start - 10);
    }
}
