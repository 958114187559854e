using System.Globalization;
using System.Text.Json;
using FootballPhysics.Labs.Queries;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>Launches from pixels that are seen through camera matrices.</summary>
public sealed class CameraFitTests
{
    private static readonly TrackCamera s_camera = TrackCamera.LookingAt(new Vector3d(60, 25, 0), new Vector3d(0, 2, 0), 3000, 1920, 1080);
    private static readonly TrackCamera s_other = TrackCamera.LookingAt(new Vector3d(0, 25, 60), new Vector3d(0, 2, 0), 3000, 1920, 1080);

    /// <summary>football lab camera --flights 500 prints the same for five hundred flights. The fit is compared with a bound that it has no part in.</summary>
    [Theory]
    [InlineData(1, true, 0, 0.1)]
    [InlineData(1, false, 0.5, 0.1)]
    [InlineData(2, false, 0.5, 0.03)]
    public void Fits_of_pixels_are_as_accurate_as_the_page_says(int cameras, bool fromGround, double inPlay, double most)
    {
        CameraFlight[] all = Fly(new CameraCheck(cameras, fromGround, inPlay), 3, 8);
        CameraFlight[] given = [.. all.Where(flight => flight.IsGood)];
        Assert.InRange(given.Length, 6, 8);
        Assert.InRange(CameraFlight.Rms(given), 0, most);
        Assert.InRange(CameraFlight.Rms(given) / CameraFlight.Bound(given), 0.2, 1.5);
        Assert.InRange(all.Count(flight => flight.Spin <= 15), 7, 8);
        Assert.All(all, flight => Assert.InRange(flight.Excess, -100, 0.5));
        Assert.InRange(all.Sum(flight => flight.Wrong), 0, 1);
    }

    /// <summary>Two cameras reveal everything: the errors of many flights are those of the bound.</summary>
    [Fact]
    public void Two_cameras_reach_the_bound()
    {
        CameraFlight[] all = Fly(new CameraCheck(2, fromGround: false), 4, 12);
        Assert.InRange(CameraFlight.Rms(all) / CameraFlight.Bound(all), 0.7, 1.3);
        Assert.All(all, flight => Assert.True(flight.HasDepth));
    }

    /// <summary>Low volleys bounce up to 14 times within the pixels; searches from the first points alone ended at other bounces.</summary>
    [Theory]
    [InlineData(5, 11)]
    [InlineData(5, 118)]
    [InlineData(5, 157)]
    [InlineData(5, 192)]
    public void A_low_volley_is_found_through_its_bounces(long seed, int index)
    {
        CameraFlight flight = new CameraCheck(1, fromGround: false, 0.5).Run(new SeededRandom(SeededRandom.Mix(seed, index)));
        Assert.True(flight.Bounces);
        Assert.True(flight.IsGood);
        Assert.InRange(flight.Excess, -100, 0.5);
        Assert.InRange(CameraFlight.Rms([flight]), 0, 0.05);
    }

    /// <summary>The ball lands just after the last pixel: lower paths bounce before, higher ones do not, and all of these fit.</summary>
    [Theory]
    [InlineData(5, 178)]
    [InlineData(5, 216)]
    public void A_flight_that_nearly_lands_has_no_depth(long seed, int index)
    {
        CameraFlight flight = new CameraCheck(1, fromGround: false, 0.5).Run(new SeededRandom(SeededRandom.Mix(seed, index)));
        Assert.InRange(CameraFlight.Rms([flight]), 0.5, 10);
        Assert.Contains("position.depth", flight.Unidentified);
        Assert.Equal(0, flight.Wrong);
    }

    /// <summary>The launch is known to be on the ground, but not how strongly the ball curls towards the camera.</summary>
    [Fact]
    public void A_curl_towards_the_camera_is_reported()
    {
        CameraFlight flight = new CameraCheck(1, fromGround: true).Run(new SeededRandom(SeededRandom.Mix(2, 133)));
        Assert.False(flight.Bounces);
        Assert.InRange(CameraFlight.Bound([flight]), 0.5, 2);
        Assert.DoesNotContain("position.depth", flight.Unidentified);
        Assert.Contains("path.depth", flight.Unidentified);
    }

    [Fact]
    public void A_short_flight_seen_by_one_camera_has_no_depth()
    {
        CameraFlight[] all = Fly(new CameraCheck(1, fromGround: false, 0, 0.18), 3, 4);
        Assert.All(all, flight => Assert.Contains("position.depth", flight.Unidentified));
        Assert.InRange(all.Sum(flight => flight.Wrong), 0, 1);
    }

    /// <summary>Noise makes the first fit a poor one. With the camera turned round, the ten pixels fit no worse: that is no reason to refuse the camera.</summary>
    [Theory]
    [InlineData(330)]
    [InlineData(397)]
    public void Few_noisy_pixels_are_no_reason_to_refuse_a_camera(int index)
    {
        CameraFlight flight = new CameraCheck(1, fromGround: false, 0, 0.18).Run(new SeededRandom(SeededRandom.Mix(2, index)));
        Assert.Contains("position.depth", flight.Unidentified);
    }

    /// <summary>Half a second of a flight; then the same, known to start on the ground.</summary>
    [Fact]
    public void A_depth_that_pixels_do_not_reveal_is_said_in_words()
    {
        PixelPoint[] pixels = Pixels(s_camera)[..25];
        TrackFitResult free = new TrackFit().Find([s_camera], pixels);
        Assert.Contains("position.depth", free.Unidentified);
        Assert.Contains("path.depth", free.Unidentified);
        Assert.Contains("The pixels do not reveal the distance from the camera: ± ", free.Explanation, StringComparison.Ordinal);
        Assert.Contains("If the ball starts on the ground, set FromGround.", free.Explanation, StringComparison.Ordinal);
        Assert.InRange(free.PathDepthError!.Value, free.DepthError!.Value, 100);
        TrackFitResult ground = new TrackFit().Find([s_camera], pixels, new TrackFitRequest { FromGround = true });
        Assert.DoesNotContain("position.depth", ground.Unidentified);
        Assert.InRange(ground.DepthError!.Value, 0.001, 0.1);
        Assert.Null(new TrackFit().Find([.. Enumerable.Range(0, 6).Select(i => new TrackPoint(0.1 * i, new Vector3d(i, 1, 0)))]).PathDepthError);
    }

    /// <summary>A pinhole at (0, 10, 0) that looks along −z: u = 320 + 500 x/−z, v = 240 + 500 (10 − y)/−z.</summary>
    [Fact]
    public void A_camera_is_a_pinhole()
    {
        TrackCamera[] same =
        [
            TrackCamera.LookingAt(new Vector3d(0, 10, 0), new Vector3d(0, 10, -50), 500, 640, 480),
            new TrackCamera([5000, 0, -3200, 0, 0, -5000, -2400, 50_000, 0, 0, -10, 0]),
        ];
        var place = new Vector3d(3, 2, -20);
        foreach (TrackCamera camera in same)
        {
            Assert.True(camera.TryProject(in place, out double u, out double v));
            Assert.Equal(320 + (500 * 3.0 / 20), u, 1e-9);
            Assert.Equal(240 + (500 * 8.0 / 20), v, 1e-9);
            Assert.InRange(Vector3d.Distance(camera.Position, new Vector3d(0, 10, 0)), 0, 1e-9);
            Assert.InRange(Vector3d.Distance(camera.Forward, new Vector3d(0, 0, -1)), 0, 1e-12);
            Assert.False(camera.TryProject(new Vector3d(3, 2, 20), out _, out _));
        }
    }

    [Theory]
    [InlineData("1,0,0,0,0,1,0,0,0,0,1", "matrix is a list of 11; allowed: 3 rows of 4 finite numbers.")]
    [InlineData("1,0,0,0,0,NaN,0,0,0,0,1,0", "matrix[5] is NaN; allowed: a finite number.")]
    [InlineData("1,2,3,0,2,4,6,1,0,0,1,0", "matrix is of a rank below 3 in its left 3 × 3 part; allowed: rank 3.")]
    [InlineData("0,0,0,0,0,1,0,0,0,0,1,0", "matrix is of a rank below 3 in its left 3 × 3 part; allowed: rank 3.")]
    [InlineData("500,0,-320,0,0,500,-240,5000,0,0,-1,0", "matrix is one with a left determinant of -")]
    public void A_wrong_matrix_is_refused(string matrix, string message)
    {
        double[] numbers = [.. matrix.Split(',').Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
        Assert.StartsWith(message, Assert.ThrowsAny<ArgumentException>(() => new TrackCamera(numbers)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_ball_behind_a_camera_is_refused()
    {
        // The same pixels, said to be of a camera that looks the other way.
        TrackCamera away = TrackCamera.LookingAt(new Vector3d(60, 25, 0), new Vector3d(120, 48, 0), 3000, 1920, 1080);
        string message = Assert.Throws<ArgumentOutOfRangeException>(() => new TrackFit().Find([away, s_other], Pixels(s_camera, s_other))).Message;
        Assert.StartsWith("cameras[0].matrix is one with the ball behind the camera, at a depth of -", message, StringComparison.Ordinal);
        Assert.Contains("allowed: a matrix with the ball in front of the camera, at a depth above 0", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Pixels_without_noise_give_the_launch()
    {
        TrackFitResult found = new TrackFit().Find([s_camera, s_other], Pixels(s_camera, s_other));
        Assert.True(found.Converged);
        Assert.InRange(Vector3d.Distance(found.Velocity, new Vector3d(2, 7, -18)), 0, 0.02);
        Assert.InRange(Vector3d.Distance(found.Spin, new Vector3d(10, 30, 0)), 0, 1);
        Assert.Empty(found.Unidentified);
    }

    [Theory]
    [InlineData(0, "track[3].camera is 2; allowed: 0 … 1.")]
    [InlineData(1, "track[3].pixel[0] is NaN; allowed: -10000000 … 10000000.")]
    [InlineData(2, "track[3].noise is 0; allowed: a finite number above 0.")]
    [InlineData(3, "track[3].time is -1; allowed: 0.02 … 1000000000000.")]
    public void A_wrong_pixel_is_refused(int kind, string message)
    {
        PixelPoint[] pixels = Pixels(s_camera, s_other);
        PixelPoint old = pixels[3];
        pixels[3] = new PixelPoint(kind == 3 ? -1 : old.Time, kind == 0 ? 2 : old.Camera, kind == 1 ? double.NaN : old.U, old.V, kind == 2 ? 0 : 1);
        Assert.StartsWith(message, Assert.Throws<ArgumentOutOfRangeException>(() => new TrackFit().Find([s_camera, s_other], pixels)).Message, StringComparison.Ordinal);
    }

    /// <summary>The command reads JSON and CSV; a sweep writes the pixels.</summary>
    [Fact]
    public void The_command_fits_the_pixels_of_a_sweep()
    {
        const string Cameras = "\"cameras\": [{\"position\": [60, 25, 0], \"target\": [0, 2, 0], \"focalLength\": 3000}, {\"position\": [0, 25, 60], \"target\": [0, 2, 0], \"focalLength\": 3000}]";
        string times = string.Join(',', Enumerable.Range(0, 60).Select(i => (0.02 * i).ToString("R", CultureInfo.InvariantCulture)));
        JsonElement row = FootballCommand.Run(
            $$$"""{"launch": {"position": [0, 0.11, 0], "velocity": [2, 7, -18], "spin": [10, 30, 0]}, {{{Cameras}}}, "stop": {"at": "time", "time": 1.5}, "row": {"samples": [{{{times}}}]}}""",
            "sweep", "-", "--count", "1").Result;
        JsonElement[] pixels = [.. row.GetProperty("samples.pixel").EnumerateArray()];
        string track = string.Join(',', Enumerable.Range(0, 60).SelectMany(i => Enumerable.Range(0, 2), (i, camera) =>
            FormattableString.Invariant($"{{\"time\": {0.02 * i:R}, \"camera\": {camera}, \"pixel\": {pixels[camera][i].GetRawText()}}}")));
        JsonElement json = FootballCommand.Run("{" + Cameras + $", \"track\": [{track}]}}", "fit", "-").Result;
        Assert.Equal(-18, json.GetProperty("values").GetProperty("velocity.z").GetDouble(), 0.05);
        Assert.Equal(30, json.GetProperty("values").GetProperty("spin.y").GetDouble(), 1.0);
        Assert.InRange(json.GetProperty("deviations").GetProperty("position.depth").GetDouble(), 1e-4, 0.05);

        // Visible is what is within 1920 × 1080 pixels; the pixels are those of the matrices.
        JsonElement[] matrices = [.. row.GetProperty("cameras.matrix").EnumerateArray()];
        var camera0 = new TrackCamera([.. matrices[0].EnumerateArray().SelectMany(line => line.EnumerateArray()).Select(number => number.GetDouble())]);
        for (int i = 0; i < 60; i++)
        {
            double[] p = [.. row.GetProperty("samples.position")[i].EnumerateArray().Select(number => number.GetDouble())];
            Assert.True(camera0.TryProject(new Vector3d(p[0], p[1], p[2]), out double u, out double v));
            Assert.Equal(u, pixels[0][i][0].GetDouble(), 1e-6);
            Assert.Equal(v, pixels[0][i][1].GetDouble(), 1e-6);
            Assert.Equal(u is >= 0 and <= 1920 && v is >= 0 and <= 1080 ? "yes" : "no", row.GetProperty("samples.visible")[0][i].GetString());
        }

        string folder = Directory.CreateTempSubdirectory("football-cameras-").FullName;
        string cameraFile = Path.Combine(folder, "cameras.csv");
        string pixelFile = Path.Combine(folder, "pixels.csv");
        File.WriteAllLines(cameraFile, ["p11,p12,p13,p14,p21,p22,p23,p24,p31,p32,p33,p34", .. matrices.Select(matrix => string.Join(',', matrix.EnumerateArray().SelectMany(line => line.EnumerateArray()).Select(number => number.GetRawText())))]);
        File.WriteAllLines(pixelFile, ["time,camera,u,v", .. Enumerable.Range(0, 60).SelectMany(i => Enumerable.Range(0, 2), (i, camera) =>
            FormattableString.Invariant($"{0.02 * i:R},{camera},{pixels[camera][i][0].GetRawText()},{pixels[camera][i][1].GetRawText()}"))]);
        JsonElement csv = FootballCommand.Run("{}", "fit", "-", "--cameras", cameraFile, "--pixels", pixelFile).Result;
        Assert.Equal(json.GetProperty("values").GetProperty("velocity.z").GetDouble(), csv.GetProperty("values").GetProperty("velocity.z").GetDouble(), 1e-3);
        Directory.Delete(folder, recursive: true);
    }

    [Theory]
    [InlineData("""{"cameras": [{"matrix": [[1, 2, 3, 0], [2, 4, 6, 1], [0, 0, 1, 0]]}], "track": []}""", "cameras[0].matrix is ")]
    [InlineData("""{"cameras": [{"matrix": [[1, 2, 3], [2, 4, 6], [0, 0, 1]]}], "track": []}""", "cameras[0].matrix is ")]
    [InlineData("""{"cameras": [{"position": [0, 9, 0], "target": [0, 9, 0], "focalLength": 500}], "track": []}""", "cameras[0].target is [0, 9, 0]; allowed: a point that is not straight above or below the camera, or in it.")]
    [InlineData("""{"cameras": [{"position": [0, 9, 0], "target": [0, 9, 9], "focalLength": 0}], "track": []}""", "cameras[0].focalLength is 0; allowed: a finite number above 0.")]
    [InlineData("""{"cameras": [{"position": [0, 9, 0], "target": [0, 9, 9], "focalLength": 500}], "track": []}""", "track's points is 0; allowed: a finite number, 5 or more.")]
    public void The_command_refuses_wrong_cameras(string scenario, string message)
    {
        FootballCommand done = FootballCommand.Run(scenario, "fit", "-");
        Assert.Equal(1, done.ExitCode);
        Assert.StartsWith("football: " + message, done.ErrorLine, StringComparison.Ordinal);
    }

    /// <summary>A person reads the same words as a program.</summary>
    [Fact]
    public void The_command_says_what_one_camera_does_not_reveal()
    {
        string track = string.Join(',', Pixels(s_camera)[..25].Select(point => FormattableString.Invariant($"{{\"time\": {point.Time:R}, \"pixel\": [{point.U:R}, {point.V:R}]}}")));
        string scenario = $"{{\"cameras\": [{{\"position\": [60, 25, 0], \"target\": [0, 2, 0], \"focalLength\": 3000}}], \"track\": [{track}]}}";
        FootballCommand done = FootballCommand.Run(scenario, "fit", "-");
        string[] unidentified = [.. done.Result.GetProperty("unidentified").EnumerateArray().Select(name => name.GetString()!)];
        Assert.Contains("position.depth", unidentified);
        Assert.Contains("path.depth", unidentified);
        Assert.InRange(done.Result.GetProperty("deviations").GetProperty("path.depth").GetDouble(), 0.5, 100);
        Assert.Contains("The pixels do not reveal the distance from the camera", done.Result.GetProperty("explanation").GetString(), StringComparison.Ordinal);
    }

    private static CameraFlight[] Fly(CameraCheck check, long seed, int flights) => [.. Enumerable.Range(0, flights).Select(i => check.Run(new SeededRandom(SeededRandom.Mix(seed, i))))];

    private static PixelPoint[] Pixels(params TrackCamera[] cameras)
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 7, -18), new Vector3d(10, 30, 0));
        List<PixelPoint> pixels = [];
        for (int i = 0; i < 60; i++)
        {
            for (int camera = 0; camera < cameras.Length; camera++)
            {
                cameras[camera].TryProject(ball.Position, out double u, out double v);
                pixels.Add(new PixelPoint(0.02 * i, camera, u, v));
            }

            simulator.Run(ref ball, 0.02, 0.02, StopAt.Time, new StepLog());
        }

        return [.. pixels];
    }
}
