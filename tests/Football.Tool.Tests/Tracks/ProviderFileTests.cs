using System.Globalization;
using System.Text;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>Files of providers are read to the numbers that were written, or refused with a sentence that names what is missing.</summary>
public sealed class ProviderFileTests(ITestOutputHelper output)
{
    /// <summary>A folder that receives the files, for a parser of the provider's layout; null for none.</summary>
    private static string? Folder => Environment.GetEnvironmentVariable("FOOTBALL_PROVIDER_FILES");

    [Fact]
    public void Forty_files_are_read_or_refused()
    {
        int read = 0;
        int refused = 0;
        List<string> wrong = [];
        foreach ((TrackWay way, string[]? refusal) in ProviderFiles.All)
        {
            foreach (OwnTrack track in OwnTrack.All)
            {
                Keep(way, track);
                string told = Told(way, track, refusal);
                read += told == "read" ? 1 : 0;
                refused += told == "refused" ? 1 : 0;
                wrong.AddRange(told is "read" or "refused" ? [] : [$"{way.Name}, {track.Name}: {told}"]);
            }
        }

        output.WriteLine($"{ProviderFiles.All.Count} files of {OwnTrack.All.Count} tracks: {read} read, {refused} refused, {wrong.Count} misread");
        Assert.Empty(wrong);
        Assert.True(ProviderFiles.All.Count >= 40);
    }

    [Theory]
    [InlineData("BG", false)]
    [InlineData("GB", false)]
    [InlineData("BGH", true)]
    public void Halves_of_the_DFL_are_where_their_time_stamps_say(string order, bool reversed)
    {
        string Frames(double start, bool ball) => string.Concat(OwnTrack.All[0].Points.Select(p => string.Create(
            CultureInfo.InvariantCulture, $"<Frame N=\"1\" T=\"{new DateTime(2022, 10, 15, 15, 0, 0, DateTimeKind.Utc).AddSeconds(start + p.T):yyyy-MM-ddTHH:mm:ss.fff}Z\" X=\"{p.X}\" Y=\"{p.Y}\"{(ball ? $" Z=\"{p.Z}\"" : "")}/>")));
        string Half(string section, double start) => string.Concat(order.Select(set => $"<FrameSet GameSection=\"{section}\" TeamId=\"{(set == 'B' ? "BALL" : "DFL-CLU-1")}\" PersonId=\"DFL-OBJ-{(set == 'B' ? "0000XT" : $"002{set}")}\">{Frames(start, set == 'B')}</FrameSet>"));
        string[] halves = [Half("firstHalf", 0), Half("secondHalf", 3900)];
        List<string> remarks = [];
        TrackPoint[] points = TrackReader.Read(new MemoryStream(Encoding.UTF8.GetBytes($"<PutDataRequest><Positions>{string.Concat(reversed ? halves.Reverse() : halves)}</Positions></PutDataRequest>")), remarks.Add);
        Assert.Equal(2 * OwnTrack.All[0].Points.Length, points.Length);
        Assert.Equal(3900, points[OwnTrack.All[0].Points.Length].Time - points[0].Time, 1e-3);
        Assert.DoesNotContain(remarks, remark => remark.Contains("begins again", StringComparison.Ordinal));
    }

    [Fact]
    public void A_list_names_the_parts_and_columns_of_a_file()
    {
        string path = Path.GetTempFileName();
        try
        {
            (TrackWay way, _) = ProviderFiles.All.First(file => file.Way.Name == "Hawk-Eye, samples of people");
            File.WriteAllBytes(path, way.Write(OwnTrack.All[0]));
            FootballCommand refused = FootballCommand.Run("", "fit", "--match", path, "--list");
            Assert.Equal(1, refused.ExitCode);
            FootballCommand listed = FootballCommand.Run("", "fit", "--match", path, "--list", "--records", "samples.people");
            Assert.Equal(0, listed.ExitCode);
            Assert.Contains("list samples.people: 225 objects", listed.Output);
            Assert.Contains("column 5: pos_x, 225 values, such as ", listed.Output);
            Assert.Contains("read as t, x, y, z: time, pos_x, pos_y, pos_z", listed.Output);
            File.WriteAllBytes(path, ProviderFiles.All.First(file => file.Way.Name == "TRACAB, a short first line").Way.Write(OwnTrack.All[0]));
            Assert.Contains("TRACAB: 225 frames with 2 to 27 objects besides the ball", FootballCommand.Run("", "fit", "--match", path, "--list").Output);
        }
        finally
        {
            File.Delete(path);
        }
    }

    private static string Told(TrackWay way, OwnTrack track, string[]? refusal)
    {
        TrackFormat? format = way.Format is { Rate: not null } rated ? rated with { Rate = track.Rate } : way.Format;
        try
        {
            TrackPoint[] points = TrackReader.Read(new MemoryStream(way.Write(track)), _ => { }, format);
            string? off = TrackWayTests.Off(points, track);
            return refusal is not null ? "read, but it had to be refused" : off is null ? "read" : "misread: " + off;
        }
        catch (RefusedException refused)
        {
            return refusal is not null && refusal.All(word => refused.Message.Contains(word, StringComparison.Ordinal)) ? "refused" : "refused: " + refused.Message;
        }
    }

    private static void Keep(TrackWay way, OwnTrack track)
    {
        if (Folder is { } folder && track == OwnTrack.All[0])
        {
            File.WriteAllBytes(Path.Combine(folder, way.Name.Replace(' ', '_').Replace('\'', '_')), way.Write(track));
        }
    }
}
