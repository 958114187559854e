using System.Diagnostics;
using System.Globalization;
using System.Text;
using System.Text.Json;
using FootballPhysics.Aiming;
using FootballPhysics.Engines;
using FootballPhysics.Netcode;
using FootballPhysics.Prediction;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Web.Tests;

/// <summary>The npm package, in Node.</summary>
public sealed class NpmTests(ITestOutputHelper told)
{
    private const double TimeStep = 1.0 / 64;

    private static readonly string s_tests = Path.Combine(Browser.Repository, "tests", "Npm");

    /// <summary>Kicks, paths ahead, goals, bodies that move, saved states and an aim, in scenes with wind, walls and goals.</summary>
    [Fact]
    public async Task Every_number_is_bit_identical_to_csharp()
    {
        string[] expected = [.. Lines()];
        string[] printed = await Node(Path.Combine(s_tests, "bits.mjs"), Path.Combine(Browser.Repository, "src", "Football.Physics.Web", "bin", "package"));
        Assert.Equal(expected, printed);
        foreach (string what in (string[])["goal goal goal ", "off the post impact right post ", "bodies impact wall ", "bodies impact leg ", "goal net back net ", "open play path ", "bodies outputs ", "goal sound 2000 ", "goal squash "])
        {
            Assert.Contains(expected, line => line.StartsWith(what, StringComparison.Ordinal));
        }

        told.WriteLine($"{expected.Length} lines, {expected.Sum(line => line.Length)} characters: equal");
    }

    /// <summary>Events and hashes of the three.js sample, which its page compares with golden.txt.</summary>
    [Fact]
    public void The_golden_lines_of_the_three_js_sample_are_those_of_csharp()
    {
        const double Tick = 1.0 / 120;
        string sample = Path.Combine(Browser.Repository, "samples", "Three");
        using var file = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(sample, "scene.json")));
        var fields = new InputFields(file.RootElement.GetProperty("scene"));
        Scene scene = SceneInput.Scene(fields.Root) with { Bodies = WorldInput.Bodies(fields.Root) };
        var ball = new Ball(scene);
        var lines = new List<string>();
        foreach (JsonElement kick in file.RootElement.GetProperty("kicks").EnumerateArray())
        {
            double Of(string name) => kick.GetProperty(name).GetDouble();
            ball.Place(new Vector3d(0, scene.Ball.Radius, 0));
            ball.Kick(Of("speed"), Of("elevation"), Of("azimuth"), Of("topSpin"), Of("sideSpin"));
            for (int tick = 0; tick < 360; tick++)
            {
                double time = ball.Time;
                for (int i = 0; i < scene.Bodies!.Count; i++)
                {
                    bool jumps = time < 0.6;
                    scene.Bodies[i].MoveTo(
                        new Vector3d(0.3 + (0.55 * i), 0.9 + (jumps ? time * (3 - (5 * time)) : 0), -9.15), new Vector3d(0, jumps ? 3 - (10 * time) : 0, 0), time);
                }

                ball.Step(Tick);
                foreach (BallEvent e in ball.Events)
                {
                    string name = ball.NameOf(e) ?? "";
                    if (e.Kind != BallEventKind.Impact || name != "ground")
                    {
                        lines.Add($"{JsonNamingPolicy.CamelCase.ConvertName(e.Kind.ToString())} {name}");
                    }
                }
            }

            lines.Add($"hash {Hash(ball)}");
        }

        Assert.Contains("impact wall 1", lines);
        Assert.Contains("goal goal", lines);
        Assert.Equal(lines, File.ReadAllLines(Path.Combine(sample, "golden.txt")));
    }

    private static IEnumerable<string> Lines()
    {
        using var cases = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(s_tests, "cases.json")));
        foreach (JsonElement item in cases.RootElement.EnumerateArray())
        {
            string name = item.GetProperty("name").GetString()!;
            var fields = new InputFields(item.GetProperty("scene"));
            Scene scene = SceneInput.Scene(fields.Root) with { Bodies = WorldInput.Bodies(fields.Root) };
            var ball = new Ball(scene);
            ball.Kick(Vector(item, "velocity"), Vector(item, "spin"));
            var squash = new BallSquash(ball.Simulator);
            var path = new Trajectory();
            ball.LookAhead(new LookAheadRequest { Duration = 2, TimeStep = TimeStep }, path);
            for (int i = 0; i < 21; i++)
            {
                double time = Math.Min(2.0 * i / 20, path.EndTime);
                Vector3d at = path.PositionAt(time);
                yield return $"{name} path {Words(time, at.X, at.Y, at.Z)}";
            }

            for (int tick = 0; tick < item.GetProperty("ticks").GetInt32(); tick++)
            {
                Move(scene.Bodies, tick, ball.Time);
                ball.Step(TimeStep);
                foreach (BallEvent e in ball.Events.Span.ToArray())
                {
                    yield return $"{name} {JsonNamingPolicy.CamelCase.ConvertName(e.Kind.ToString())} {ball.NameOf(e)} "
                        + Words([e.Time, .. Parts(e.Position), .. Parts(e.VelocityBefore), .. Parts(e.Velocity), .. Parts(e.SpinBefore), .. Parts(e.Spin), .. Parts(e.Normal)]);
                }

                foreach (BallEvent e in ball.Events.Span.ToArray())
                {
                    squash.Follow(in e);
                    if (e.Kind == BallEventKind.Impact)
                    {
                        Impact o = ball.Simulator.ImpactOf(in e);
                        yield return $"{name} outputs "
                            + Words(o.NormalImpulse, o.TangentialImpulse, o.SlipBefore, o.SlipAfter, o.ContactTime, o.Compression, o.PeakForce, o.EnergyLost) + (o.Grips ? " true" : " false");
                        var sound = new ImpactSound(in o);
                        float[] samples = new float[ImpactSound.SamplesAt(8000)];
                        sound.Write(samples, 8000);
                        yield return $"{name} sound {samples.Length} " + Words(sound.Loudness, sound.Brightness, sound.Brush, samples[40], samples[400]);
                    }
                }

                BallStretch stretch = squash.At(ball.Time);
                if (stretch.Along < 1)
                {
                    yield return $"{name} squash " + Words([stretch.Along, stretch.Across, .. Parts(stretch.Axis)]);
                }

                if (tick % 10 == 0)
                {
                    Quaterniond q = ball.Orientation;
                    yield return $"{name} {JsonNamingPolicy.CamelCase.ConvertName(ball.Motion.ToString())} "
                        + Words([ball.Time, .. Parts(ball.Position), .. Parts(ball.Velocity), .. Parts(ball.Spin), q.X, q.Y, q.Z, q.W]) + " " + Hash(ball);
                }

                if (tick % 10 == 5)
                {
                    BallForces? f = ball.GetForces(TimeStep);
                    string forces = f is null ? "none"
                        : Words([.. Parts(f.Weight), .. Parts(f.Drag), .. Parts(f.Magnus), .. Parts(f.Load), .. Parts(f.Friction), .. Parts(f.Sum), .. Parts(f.Acceleration)]);
                    yield return $"{name} forces {forces} {string.Join(',', (f?.Contacts ?? []).Select(contact => ball.Simulator.NameOf(contact.ColliderIndex)))}";
                }
            }

            ball.Kick(speed: 20, elevationDegrees: 15, azimuthDegrees: -10, topSpin: 5, sideSpin: 30);
            ball.Step(TimeStep);
            yield return $"{name} kicked again {Hash(ball)}";
            BallState state = ball.State;
            new PlaceInput(0, 0, 0, new Vector3d(1, 2, 3), new Vector3d(-4, 3, 1), new Vector3d(0, 6, 0), new Quaterniond(0, 2, 0, 2)).Apply(ball.Simulator, ref state);
            ball.State = state;
            ball.Step(TimeStep);
            yield return $"{name} restarted {Hash(ball)}";
            yield return $"{name} restored true";
        }

        AimResult aim = new Aimer(new Simulator(new Scene())).Find(new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(20, 1.5, 3),
            Speed = 25,
            TopSpin = 20,
            SideSpin = 10,
        });
        yield return $"aim {JsonNamingPolicy.CamelCase.ConvertName(aim.Status.ToString())} " + Words([.. Parts(aim.Velocity), .. Parts(aim.Spin), aim.Miss, aim.Time]);
    }

    private static void Move(KinematicBodies? bodies, int tick, double time)
    {
        if (bodies is null)
        {
            return;
        }

        double t = tick / 64.0;
        bodies[0].MoveTo(new Vector3d(0.25 + (0.5 * t), 0.95 + (t * (1 - t)), -9), new Vector3d(0.5, 1 - (2 * t), 0), time);
        bodies[1].MoveTo(new Vector3d(0, 0.3, -7), new Quaterniond(0, 0.6, 0, 0.8), Vector3d.Zero, new Vector3d(0, 3, 0), time);
    }

    private static string Hash(Ball ball) => Snapshot.Hash(ball.State).ToString("x16", CultureInfo.InvariantCulture);

    private static string Words(params double[] numbers) =>
        string.Join(' ', numbers.Select(number => BitConverter.DoubleToInt64Bits(number).ToString("x16", CultureInfo.InvariantCulture)));

    private static double[] Parts(Vector3d v) => [v.X, v.Y, v.Z];

    private static Vector3d Vector(JsonElement item, string name)
    {
        JsonElement v = item.GetProperty("kick").GetProperty(name);
        return new Vector3d(v[0].GetDouble(), v[1].GetDouble(), v[2].GetDouble());
    }

    /// <summary>Runs a program in Node, and returns the lines that it prints.</summary>
    private static async Task<string[]> Node(params string[] arguments)
    {
        NeededPrograms.Need("apt-get install nodejs", "node");
        var start = new ProcessStartInfo("node", arguments) { RedirectStandardOutput = true, RedirectStandardError = true, StandardOutputEncoding = Encoding.UTF8 };
        using Process node = Process.Start(start)!;
        Task<string> error = node.StandardError.ReadToEndAsync();
        string output = await node.StandardOutput.ReadToEndAsync();
        await node.WaitForExitAsync();
        Assert.True(node.ExitCode == 0, await error);
        return output.TrimEnd('\n').Split('\n');
    }
}
