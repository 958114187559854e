using System.Globalization;
using System.Runtime.InteropServices;
using System.Buffers;
using DuckDB.NET.Data;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep;
using FootballPhysics.Tool.Sweep.Formats;
using FootballPhysics.Tool.Sweep.Output;
using FootballPhysics.Tool.Sweep.Rows;

namespace FootballPhysics.Tool.Tests.Sweep;

/// <summary>football sweep --format parquet, read by a database; and what a folder, a cell and an output are held to.</summary>
public sealed class ParquetTests : IDisposable
{
    /// <summary>Two row groups, and a part of one.</summary>
    private const int Rows = (2 * ParquetFormat.GroupRows) + 1003;

    private readonly string _folder = Directory.CreateTempSubdirectory("football-parquet-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void A_database_reads_the_numbers_and_the_words_of_the_other_formats()
    {
        Write("parquet", "rows", Rows);
        Write("npy", "npy", Rows);
        using DuckDBConnection database = Open();
        List<object[]> read = Query(database, $"select index, speed, \"position.z\", \"velocityAfter.y\", apex, \"end\" from '{At("rows", "rows.parquet")}'");
        Assert.Equal(Rows, read.Count);
        Assert.Equal(Enumerable.Range(0, Rows), read.Select(row => (int)(long)row[0]));
        Assert.Equal(Numbers("speed"), read.Select(row => (double)row[1]));
        Assert.Equal(Numbers("apex"), read.Select(row => (double)row[4]));
        Assert.Equal(Numbers("position").Where((_, i) => i % 3 == 2), read.Select(row => (double)row[2]));
        Assert.Equal(Numbers("velocityAfter").Where((_, i) => i % 3 == 1), read.Select(row => (double)row[3]));
        Assert.Equal("impact", Assert.Single(read.Select(row => (string)row[5]).Distinct()));
        Assert.Equal(File.ReadAllText(At("rows", "schema.json")), (string)Assert.Single(Query(database, $"select decode(value) from parquet_kv_metadata('{At("rows", "rows.parquet")}') where decode(key) = 'schema'"))[0]);
        Assert.Equal((3L, Rows), ((long)Query(database, $"select count(distinct row_group_id) from parquet_metadata('{At("rows", "rows.parquet")}')")[0][0], (int)(long)Query(database, $"select num_rows from parquet_file_metadata('{At("rows", "rows.parquet")}')")[0][0]));
    }

    [Fact]
    public void An_interrupted_run_has_the_same_bytes_whatever_had_been_written()
    {
        Write("parquet", "one", Rows);
        Write("parquet", "program", 1);
        SweepPlan plan = SweepInput.Read(InputCase.Read(new InputLine("{}"u8.ToArray(), false), []).Scenario!, 1);
        var run = new SweepRun(plan, "parquet", 1);
        Identity identity = Manifest.Read(At("program"), Manifest.Done)!.Identity with { Count = Rows };
        using (FolderSink sink = FolderSink.Open(At("cut"), identity, new Shard(1, 1, Rows), run.Format, Schema.Text(run.Columns, run.Format), run.NoRows, TimeProvider.System))
        {
            var maker = RowMaker.Create(plan, ParquetFormat.GroupRows);
            maker.Make(0, ParquetFormat.GroupRows);
            ArrayBufferWriter<byte>[] files = [new()];
            run.Format.Write(maker.Columns, ParquetFormat.GroupRows, files);
            sink.Add(files, ParquetFormat.GroupRows, maker.Counts);
            sink.Checkpoint();
        }

        // Bytes after the checkpoint are given up.
        File.AppendAllText(At("cut", "rows.parquet"), "torn");
        Assert.Contains($"{Rows - ParquetFormat.GroupRows} of them now", Write("parquet", "cut", Rows).Error);
        Assert.Equal(File.ReadAllBytes(At("one", "rows.parquet")), File.ReadAllBytes(At("cut", "rows.parquet")));
        Assert.Equal(File.ReadAllBytes(At("one", "manifest.json")), File.ReadAllBytes(At("cut", "manifest.json")));
    }

    [Fact]
    public void Shards_put_together_have_the_rows_of_the_whole()
    {
        Write("parquet", "one", 1000);
        for (int i = 1; i <= 3; i++)
        {
            Write("parquet", "parts", 1000, "--shard", $"{i}/3");
        }

        FootballCommand merged = FootballCommand.Run("", "sweep", "merge", At("parts"));
        Assert.True(merged.ExitCode == 0, merged.Error);
        using DuckDBConnection database = Open();
        Assert.Equal(
            Query(database, $"select * from '{At("one", "rows.parquet")}'").Select(row => string.Join('|', row)),
            Query(database, $"select * from '{At("parts", "rows.parquet")}'").Select(row => string.Join('|', row)));
        Assert.Contains("all there before", Write("parquet", "parts", 1000, "--verify").Error);
    }

    [Fact]
    public void A_missing_word_is_null_for_a_database_and_255_for_NumPy()
    {
        // Without friction, a ball along the goal line bounces between two boards for ever; a ball towards the goal scores.
        const string Board = "\"shape\": \"box\", \"halfSize\": [0.1, 20, 30], \"surface\": {\"normalRestitution\": 1, \"slidingFriction\": 0}";
        const string Scene = "{\"goals\": [{\"center\": [0, 0, -12], \"facing\": [0, 0, 1]}], \"air\": {\"density\": 0}, \"ground\": {\"slidingFriction\": 0, \"rollingFriction\": 0, \"spinDamping\": 0}, "
            + $"\"obstacles\": [{{\"center\": [-9, 20, 0], {Board}}}, {{\"center\": [9, 20, 0], {Board}}}], "
            + "\"launch\": {\"position\": [0, 0.11, 0], \"speed\": 12, \"elevation\": 0, \"azimuth\": {\"list\": [90, 0, -3]}}, \"row\": {\"columns\": [\"index\", \"azimuth\", \"outcome\", \"end\"]}}";
        string Outcome(object azimuth) => (double)azimuth == 90 ? "" : "goal";
        foreach (string format in (string[])["parquet", "npy"])
        {
            FootballCommand done = FootballCommand.Run(Scene, "sweep", "-", "--count", "101", "--format", format, "--out", At(format));
            Assert.True(done.ExitCode == 0, done.Error);
            Assert.Matches(@"The outcome of \d+ of 101 rows is unknown \(\d+: the ball still moves", done.Error);
        }

        using DuckDBConnection database = Open();
        List<object[]> rows = Query(database, $"select azimuth, outcome, \"end\" from '{At("parquet", "rows.parquet")}' order by index");
        Assert.Equal(rows.Select(row => Outcome(row[0])), rows.Select(row => row[1] as string ?? ""));
        Assert.All(rows, row => Assert.Contains((string)row[2], (string[])["impact", "time"]));
        int missing = rows.Count(row => Outcome(row[0]).Length == 0);
        Assert.InRange(missing, 1, 100);
        Assert.Equal(missing, (int)(long)Query(database, $"select count(*) from '{At("parquet", "rows.parquet")}' where outcome is null")[0][0]);
        byte[] codes = File.ReadAllBytes(At("npy", "outcome.npy"))[^101..];
        Assert.Equal(rows.Select(row => Outcome(row[0])), codes.Select(code => code == 255 ? "" : "goal"));
        Assert.Contains("\"missing\": 255", File.ReadAllText(At("npy", "schema.json")));
        Assert.Contains($"\"stillMoving\": {missing}", File.ReadAllText(At("npy", "manifest.json")));
    }

    [Fact]
    public void A_footer_has_the_length_that_was_told_before()
    {
        Write("parquet", "rows", 5000);
        SweepPlan plan = SweepInput.Read(InputCase.Read(new InputLine("{}"u8.ToArray(), false), []).Scenario!, 1);
        Assert.Equal(new SweepRun(plan, "parquet", 1).Format.Bytes(5000), new FileInfo(At("rows", "rows.parquet")).Length);
    }

    [Theory]
    [InlineData("npy", "speed.npy")]
    [InlineData("csv", "rows.csv")]
    [InlineData("ndjson", "rows.ndjson")]
    [InlineData("parquet", "rows.parquet")]
    [InlineData("parquet", "schema.json")]
    public void A_finished_folder_that_lost_or_changed_a_file_is_not_all_there(string format, string file)
    {
        Write(format, "rows", 200);
        string path = At("rows", file);
        byte[] bytes = File.ReadAllBytes(path);
        bytes[^9] ^= 1;
        File.WriteAllBytes(path, bytes);
        Refused(format, "\" was changed after it was written. ", "--verify");
        File.WriteAllBytes(path, bytes[..^1]);
        Refused(format, $"\" is incomplete: it has {bytes.Length - 1} of {bytes.Length} bytes. ");
        File.Delete(path);
        Refused(format, "\" is missing. Remove the folder to start again.");
    }

    [Fact]
    public void No_cell_of_a_table_is_a_formula()
    {
        string scene = "{\"obstacles\": [{\"name\": \"=cmd|' /C calc'!A0\", \"shape\": \"box\", \"center\": [0, 5, -5], \"halfSize\": [20, 5, 0.1]}], \"row\": {\"events\": 1, \"hits\": [\"=cmd|' /C calc'!A0\"]}, \"stop\": {\"at\": \"rest\"}}";
        FootballCommand done = FootballCommand.Run(scene, "sweep", "-", "--count", "5", "--format", "csv");
        Assert.True(done.ExitCode == 0, done.Error);
        Assert.Contains("'=cmd|", done.Output);
        Assert.DoesNotMatch("(^|[,\n\"])=", done.Output);
    }

    [Fact]
    public void No_output_goes_over_an_input_or_another_output()
    {
        string own = At("own.json");
        const string Scenario = "{\"launch\": {\"position\": [0, 0.11, 0], \"velocity\": [1, 5, -20]}}";
        File.WriteAllText(own, Scenario);
        File.CreateSymbolicLink(At("link.json"), own);
        foreach (string output in (string[])[own, At("link.json"), Path.Combine(_folder, ".", "own.json")])
        {
            FootballCommand done = FootballCommand.Run("", "replay", own, "-o", output);
            Assert.Equal(1, done.ExitCode);
            Assert.Matches("^football: --output \".*\" is also the file of the input. ", done.ErrorLine);
            Assert.Equal(Scenario, File.ReadAllText(own));
        }

        FootballCommand twice = FootballCommand.Run("", "replay", own, "-o", At("x"), "--svg", At("x"));
        Assert.Matches("^football: --svg \".*x\" is also the file of --output. ", twice.ErrorLine);
        Assert.False(File.Exists(At("x")));
    }

    private static DuckDBConnection Open()
    {
        var database = new DuckDBConnection("DataSource=:memory:");
        database.Open();
        return database;
    }

    private static List<object[]> Query(DuckDBConnection database, string text)
    {
        using DuckDBCommand command = database.CreateCommand();
        command.CommandText = text;
        using System.Data.Common.DbDataReader reader = command.ExecuteReader();
        var rows = new List<object[]>();
        while (reader.Read())
        {
            object[] row = new object[reader.FieldCount];
            reader.GetValues(row);
            rows.Add(row);
        }

        return rows;
    }

    private IEnumerable<double> Numbers(string column)
    {
        byte[] file = File.ReadAllBytes(At("npy", column + ".npy"));
        return MemoryMarshal.Cast<byte, double>(file.AsSpan(10 + file[8] + (file[9] << 8))).ToArray();
    }

    private void Refused(string format, string sentence, params string[] more)
    {
        FootballCommand done = Command(format, "rows", 200, more);
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(sentence, done.ErrorLine);
    }

    private FootballCommand Write(string format, string folder, long count, params string[] more)
    {
        FootballCommand done = Command(format, folder, count, more);
        Assert.True(done.ExitCode == 0, done.Error);
        return done;
    }

    private FootballCommand Command(string format, string folder, long count, params string[] more) => FootballCommand.Run(
        "", ["sweep", "--count", count.ToString(CultureInfo.InvariantCulture), "--format", format, "--out", At(folder), .. more]);

    private string At(params string[] path) => Path.Combine([_folder, .. path]);
}
