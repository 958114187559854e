using System.IO.Compression;
using System.Text.Json;
using FootballPhysics.Laws;
using FootballPhysics.Netcode;
using FootballPhysics.Shapes;

namespace FootballPhysics.Tool.Tests;

/// <summary>A match that a game attaches to an issue is played again by the command, in the scene that comes with it.</summary>
public sealed class BundleTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("football-bundle-").FullName;

    public static TheoryData<string> Scenes => [.. s_scenes.Keys];

    /// <summary>Scenes that use each part that JSON can describe.</summary>
    internal static readonly Dictionary<string, Func<Scene>> s_scenes = new()
    {
        ["default"] = () => Scene.Default,
        ["published"] = () => Scene.Published with { Forces = ForceSet.Regularized, Ground = Ground.Presets["publishedCourt"] },
        ["stadium"] = () => Pitch.Stadium.On(),
        ["cage, beach ball"] = () => Pitch.Cage.On(new Scene { Ball = BallProperties.BeachBall, Ground = Ground.Of(SurfaceMaterial.Indoor) }),
        ["storm"] = () => new Scene
        {
            Ball = BallProperties.Trionda,
            Air = Weather.AtAltitude(1200, 12, 0.8).ToAir() with { WindField = new WindByHeight(7, 1, -2, gusts: new Gusts { Seed = 11 }) },
            Forces = ForceSet.Measured with { KnuckleSeed = -5 },
        },
        ["no ground, wind by height"] = () => new Scene { Ground = Ground.None, Air = new Air { WindField = new WindByHeight(3, 1, 0) } },
        ["zones and layers"] = () => new Scene
        {
            Ball = BallProperties.Futsal with { Ignores = Layers.Of(2, 31) },
            Obstacles = [new Obstacle { Shape = new SphereShape(new Vector3d(0, 0.2, -3), 0.5), Layer = 31 }, new Obstacle { Shape = new SphereShape(new Vector3d(0, 0.2, -12), 0.5), Layer = 30 }],
            Zones =
            [
                new Zone { Name = "half \"A\"", Shape = new PlaneShape(new Vector3d(0, 0, -3), new Vector3d(0, 0, 1)), Of = ZonePart.Center },
                new Zone { Name = "spot", Shape = new SphereShape(new Vector3d(1, 0, -6), 2), Layer = 2 },
                new Zone { Name = "box", Shape = new BoxShape(new Vector3d(1, 0, -9), new Vector3d(3, 2, 1), new Quaterniond(0, 0.6, 0, 0.8)) },
            ],
        },
        ["heights at nodes"] = () => new Scene
        {
            Ground = new Ground { Heights = new HeightField(-10, -30, 10, new double[,] { { 0, 0.1, 0.2, 0.1 }, { 0.1, 0.5, 0.2, 0.3 }, { 0, 0.1, 0.3, 0 } }), Height = 0.3 },
        },
        ["hills and things"] = () => new Scene
        {
            Ground = new Ground { Material = SurfaceMaterial.WetTurf, Heights = HeightField.FromControlValues(-10, -10, 10, new double[,] { { 0, 0.1, 0.2 }, { 0.1, 0.5, 0.2 }, { 0, 0.1, 0.3 } }) },
            Obstacles =
            [
                new Obstacle { Name = "ramp \"A\"", Shape = new PlaneShape(new Vector3d(0, -3, 0), new Vector3d(0.1, 1, 0.3)) },
                new Obstacle { Shape = new SphereShape(new Vector3d(3, 1, -6), 0.4), Mass = 12, Surface = SurfaceMaterial.GoalFrame with { NormalRestitution = 2.5, MinimumExitSpeed = 3 } },
                new Obstacle { Shape = new BoxShape(new Vector3d(-4, 1, -9), new Vector3d(1, 1.1, 0.3), new Quaterniond(0.1, 0.7, 0.2, 0.5)), Surface = SurfaceMaterial.Wood },
                new Obstacle { Shape = new CapsuleShape(new Vector3d(5, 0.2, 1), new Vector3d(5, 1.9, 2), 0.3), Velocity = new Vector3d(-1, 0, 0) },
            ],
            Nets = [new Net { Center = new Vector3d(0, 1, -15), Normal = new Vector3d(0, 0, 1), Along = new Vector3d(1, 0, 0), HalfLength = 2, HalfWidth = 1 }],
        },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_match_in_any_scene_without_code_is_played_again_to_the_last_bit(string name)
    {
        string file = Save(Bundle(s_scenes[name](), out FixedStepRunner runner));
        var done = FootballCommand.Run("", "bundle", file);
        Assert.Equal("", done.Error.Contains("internal", StringComparison.Ordinal) ? done.Error : "");
        Assert.Equal(0, done.ExitCode);
        JsonElement told = done.Result;
        Assert.True(told.GetProperty("same").GetBoolean());
        Assert.Equal(200, told.GetProperty("to").GetInt64());
        Assert.Equal(runner.State.Position.X, told.GetProperty("ball").GetProperty("position")[0].GetDouble());
        Assert.Equal(runner.State.Velocity.Y, told.GetProperty("ball").GetProperty("velocity")[1].GetDouble());

        JsonElement there = FootballCommand.Run("", "bundle", file, "--tick", "70").Result;
        Assert.Equal(70, there.GetProperty("tick").GetInt64());
        Assert.Contains("The same match, to the last bit.", FootballCommand.InTerminal("", "bundle", file).Output);
    }

    /// <summary>The one machine had something that is not in its recording: what it recorded is not what comes out here.</summary>
    [Fact]
    public void A_match_that_another_machine_played_otherwise_is_told_by_tick_and_field_and_ends_with_1()
    {
        var runner = new FixedStepRunner(timeStep: 1.0 / 60);
        Recording recorded = runner.Record();
        runner.QueueKick(new Vector3d(1, 6, -20), new Vector3d(0, 30, 0));
        runner.Kicks.Add(new KickInput(40, new Vector3d(1, 2, -3), Vector3d.Zero));
        for (int i = 0; i < 200; i++)
        {
            runner.Step();
        }

        runner.Kicks.Remove(40);
        string file = Save(recorded.ToBundle(runner.Simulator));
        var done = FootballCommand.Run("", "bundle", file);
        Assert.Equal(1, done.ExitCode);
        Assert.Equal(41, done.Result.GetProperty("firstDivergence").GetInt64());
        Assert.StartsWith("position.x: ", done.Result.GetProperty("difference").GetString());
        Assert.Contains("Tick 41 is the first that differs here", done.Error);
    }

    [Fact]
    public void A_match_that_was_damaged_on_its_way_is_refused()
    {
        byte[] plain = new FixedStepRunner().Record().ToBundle(new Simulator());
        byte[] bytes = new FixedStepRunner().Record().ToBytes();
        bytes[30] ^= 1;
        Assert.StartsWith("football: match.segment: The bytes are broken: their checksum does not hold", FootballCommand.Run("", "bundle", Save(Zip(bytes, plain))).ErrorLine);
    }

    /// <summary>The bytes are sealed again, so that only their meaning is wrong: a flag that no bundle has, a second ball, a ball above the ground of this scene.</summary>
    [Fact]
    public void A_match_with_the_hash_of_a_scene_that_did_not_produce_it_is_refused()
    {
        var runner = new FixedStepRunner(new Simulator());
        byte[] bundle = runner.Record().ToBundle(runner.Simulator);

        // Format, version, hash, time step, tick, quantisation; then the flag, the number of balls, and the balls.
        byte[] moving = runner.Record().ToBytes();
        int scene = 6 + moving[5];
        int flag = scene + 18;
        moving[flag] = 1;
        byte[] two = new FixedStepRunner(new BallGroup(new Simulator(), 2)).Record().ToBytes();
        byte[] high = new FixedStepRunner(new Simulator(Scene.Default with { Ground = new Ground { Height = 1 } })).Record().ToBytes();
        moving.AsSpan(scene, 8).CopyTo(two.AsSpan(scene));
        moving.AsSpan(scene, 8).CopyTo(high.AsSpan(scene));
        foreach ((byte[] bytes, string says) in new[]
        {
            (moving, "football: match.segment is a match with moving colliders of an engine. "),
            (two, "football: match.segment: The scene differs from the recorded one (balls 1, "),
            (high, "football: match.segment: state.position is (0, 1.11, 0); allowed: "),
        })
        {
            var done = FootballCommand.Run("", "bundle", Save(Zip(Sealed(bytes), bundle)));
            Assert.StartsWith(says, done.ErrorLine);
            Assert.Equal(1, done.ExitCode);
        }
    }

    [Fact]
    public void What_is_no_bundle_or_a_tick_that_it_does_not_have_is_refused()
    {
        byte[] good = Bundle(Scene.Default, out _);
        Assert.StartsWith("football: FILE is not a zip file. ", FootballCommand.Run("", "bundle", Save([1, 2, 3])).ErrorLine);
        Assert.StartsWith("football: --tick is 201; allowed: 0 … 200", FootballCommand.Run("", "bundle", Save(good), "--tick", "201").ErrorLine);
        Assert.StartsWith("football: FILE \"none.zip\" cannot be read. ", FootballCommand.Run("", "bundle", "none.zip").ErrorLine);
        foreach ((string from, string to, string says) in new[]
        {
            ("\"gravity\":9.81", "\"gravity\":9.82", "football: sceneHash is "),
            ("\"gravity\"", "\"gravitas\"", "football: scene.gravitas is unknown"),
            ("\"gravity\":9.81", "\"gravity\":-1", "football: scene.gravity is -1; allowed: "),
        })
        {
            var done = FootballCommand.Run("", "bundle", Save(Edited(good, from, to)));
            Assert.Equal(1, done.ExitCode);
            Assert.StartsWith(says, done.ErrorLine);
        }
    }

    /// <summary>A small file that would unpack to much is refused before that is in memory.</summary>
    [Theory]
    [InlineData("match.json", (1 << 23) + 1)]
    [InlineData("match.segment", (1 << 26) + 1)]
    public void A_bundle_that_unpacks_to_too_much_is_refused(string name, int length)
    {
        byte[] bomb = Filled(Bundle(Scene.Default, out _), name, length);
        Assert.True(bomb.Length < 1 << 20);
        long before = GC.GetTotalAllocatedBytes(true);
        var done = FootballCommand.Run("", "bundle", Save(bomb));
        long allocated = GC.GetTotalAllocatedBytes(true) - before;
        Assert.StartsWith($"football: {name} is {length} bytes; allowed: at most {length - 1} bytes", done.ErrorLine);
        Assert.True(allocated < 1 << 24, $"{allocated} bytes were allocated");
    }

    [Fact]
    public void A_bundle_of_too_many_files_or_bytes_is_refused()
    {
        using var many = new MemoryStream();
        using (var zip = new ZipArchive(many, ZipArchiveMode.Create, leaveOpen: true))
        {
            for (int i = 0; i < 65; i++)
            {
                zip.CreateEntry($"{i}");
            }
        }

        Assert.StartsWith("football: FILE is a zip file of 65 files; allowed: at most 64", FootballCommand.Run("", "bundle", Save(many.ToArray())).ErrorLine);
        string large = Path.Combine(_folder, "large.zip");
        using (FileStream file = File.Create(large))
        {
            file.SetLength((1L << 26) + (1L << 20));
        }

        Assert.StartsWith("football: FILE is ", FootballCommand.Run("", "bundle", large).ErrorLine);
        Assert.Contains("allowed: at most 67108864 bytes", FootballCommand.Run("", "bundle", large).ErrorLine);
    }

    /// <summary>A list of a million files in a bundle of 60 MB is not read.</summary>
    [Fact]
    public void A_bundle_with_a_long_list_of_files_is_refused_before_the_list_is_read()
    {
        using var many = new MemoryStream();
        using (var zip = new ZipArchive(many, ZipArchiveMode.Create, leaveOpen: true))
        {
            for (int i = 0; i < 20_000; i++)
            {
                zip.CreateEntry($"{i}");
            }
        }

        // Its entries are not counted, as those of a short list are.
        string error = FootballCommand.Run("", "bundle", Save(many.ToArray())).ErrorLine;
        Assert.StartsWith("football: FILE is a zip file with ", error);
        Assert.Contains("list of files; allowed: at most 65536", error);
    }

    /// <summary>What the file says of where it comes from is shown, and not obeyed.</summary>
    [Theory]
    [InlineData("\"runtime\":\"")]
    [InlineData("\"system\":\"")]
    [InlineData("\"library\":\"")]
    public void Escape_sequences_of_a_bundle_do_not_reach_the_terminal(string field)
    {
        string file = Save(Edited(Bundle(Scene.Default, out _), field, field + "\\u001b]0;evil\\u0007\\u009b31m"));
        string told = FootballCommand.InTerminal("", "bundle", file).Output;
        Assert.Contains("\\u001b]0;evil\\u0007\\u009b31m", told);
        Assert.DoesNotContain(told, character => char.IsControl(character) && character != '\n');
        var redirected = FootballCommand.Run("", "bundle", file);
        Assert.DoesNotContain(redirected.Output + redirected.Error, character => char.IsControl(character) && character != '\n');
    }

    [Fact]
    public void A_scene_with_code_or_another_one_than_the_match_s_has_no_bundle()
    {
        Scene own = Scene.Default with { Forces = ForceSet.Measured with { CustomForces = [IForce.From(_ => Vector3d.Zero)] } };
        Assert.StartsWith("The scene cannot be written as a scenario, because forces.customForces[0] ", Assert.Throws<InvalidOperationException>(() => Bundle(own, out _)).Message);
        var runner = new FixedStepRunner();
        Recording segment = runner.Record();
        Assert.Throws<ArgumentException>(() => segment.ToBundle(new Simulator(Scene.Published)));
        Assert.Throws<ArgumentNullException>(() => segment.ToBundle(null!));
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static byte[] Bundle(Scene scene, out FixedStepRunner runner)
    {
        var bodies = new KinematicBodies();
        KinematicBody head = bodies.Add("head", BodyKind.Head);
        KinematicBody player = bodies.Add("player", BodyKind.Player);
        runner = new FixedStepRunner(new Simulator(scene with { Bodies = bodies }, new SolverSettings { Integrator = Integrator.Rk2 }), 1.0 / 60) { QuantizationInterval = 6 };
        runner.MoveBodies = time =>
        {
            head.MoveTo(new Vector3d(0.3 * time, 1.7, -6), new Vector3d(0.3, 0, 0), time);
            player.MoveTo(new Vector3d(2 - time, 0, -3), new Vector3d(-1, 0, 0), time);
        };
        Recording segment = runner.Record();
        runner.QueueKick(new Vector3d(1, 5, -17), new Vector3d(3, 30, 0));
        while (runner.Tick < 200)
        {
            runner.Step();
        }

        return segment.ToBundle(runner.Simulator);
    }

    private static byte[] Zip(byte[] segment, byte[] other)
    {
        using var memory = new MemoryStream();
        memory.Write(other);
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Update, leaveOpen: true))
        {
            zip.GetEntry("match.segment")!.Delete();
            using Stream entry = zip.CreateEntry("match.segment").Open();
            entry.Write(segment);
        }

        return memory.ToArray();
    }

    /// <summary>The bytes with their CRC-32 at the end, as Ethernet and zip files have it.</summary>
    private static byte[] Sealed(byte[] bytes)
    {
        uint crc = uint.MaxValue;
        foreach (byte part in bytes.AsSpan(0, bytes.Length - 4))
        {
            crc ^= part;
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc & 1) == 0 ? crc >> 1 : (crc >> 1) ^ 0xEDB88320;
            }
        }

        return [.. bytes.AsSpan(0, bytes.Length - 4), .. BitConverter.GetBytes(~crc)];
    }

    private static byte[] Edited(byte[] bundle, string from, string to)
    {
        using var memory = new MemoryStream();
        memory.Write(bundle);
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Update, leaveOpen: true))
        {
            string text;
            using (var reader = new StreamReader(zip.GetEntry("match.json")!.Open()))
            {
                text = reader.ReadToEnd();
            }

            Assert.Contains(from, text);
            zip.GetEntry("match.json")!.Delete();
            using var writer = new StreamWriter(zip.CreateEntry("match.json").Open());
            writer.Write(text.Replace(from, to, StringComparison.Ordinal));
        }

        return memory.ToArray();
    }

    /// <summary>A bundle with an entry of blanks.</summary>
    private static byte[] Filled(byte[] bundle, string name, int length)
    {
        using var memory = new MemoryStream();
        memory.Write(bundle);
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Update, leaveOpen: true))
        {
            zip.GetEntry(name)!.Delete();
            using Stream entry = zip.CreateEntry(name).Open();
            byte[] blanks = new byte[1 << 16];
            blanks.AsSpan().Fill((byte)' ');
            for (int left = length; left > 0; left -= blanks.Length)
            {
                entry.Write(blanks, 0, Math.Min(left, blanks.Length));
            }
        }

        return memory.ToArray();
    }

    private string Save(byte[] bundle)
    {
        string file = Path.Combine(_folder, $"{Guid.NewGuid():N}.zip");
        File.WriteAllBytes(file, bundle);
        return file;
    }
}
