using System.Text.Json;
using FootballPhysics.Labs.Hostile;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>The hostile scenes: drawn as they always were, and checks that find what they are for.</summary>
public sealed class HostileTests
{
    /// <summary>Numbers of scenes are handed on with what was found in them: so the draw must not change.</summary>
    [Fact]
    public void A_scene_is_drawn_as_it_always_was()
    {
        HostileScene scene = HostileGenerator.Make(1079048);
        Assert.Equal(new Vector3d(1000000, 24.841312533205404, 43.908830437996585), scene.Position);
        Assert.Equal(new Vector3d(-10.425155424813742, -5.368160572451299, 4.438599443830627), scene.Spin);
        Assert.Equal((Integrator.Rk2, 6.3649022676890947), (scene.Settings.Integrator, scene.Scene.Forces.MagnusCoefficient));
        Assert.Equal([0.02, double.Epsilon, 1e-12, 0], scene.Frames[..4]);
        HostileScene forced = HostileGenerator.Make(431);
        Assert.Equal("Damper { OfVelocity = 0.008215159551674171, OfSpin = 25.075046340978815 }", Assert.Single(forced.Scene.Forces.CustomForces).ToString());
        Assert.Equal(new Vector3d(-0.8189793727143306, 5.250547456520825, 3.4591350911601237), forced.Velocity);
    }

    [Fact]
    public void The_same_scenes_lead_to_the_same_report_on_any_number_of_threads()
    {
        JsonElement Findings(string jobs) => FootballCommand.Run("", "lab", "stability", "--hostile", "--scenes", "60", "--jobs", jobs).Result.GetProperty("tables");
        Assert.Equal(Untimed(Findings("1")), Untimed(Findings("3")));
    }

    [Fact]
    public void A_scene_is_shown_frame_by_frame()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "stability", "--hostile", "--scene", "2");
        Assert.Equal(HostileGenerator.Make(2).Frames.Length, done.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
        Assert.Contains("NormalRestitution", done.Error);
    }

    /// <summary>A Magnus force that turns the velocity far in a step that is divided, against a drag that is too weak for what Euler and RK2 make of it.</summary>
    [Theory]
    [InlineData(1446)]
    [InlineData(1079048)]
    public void A_turning_velocity_is_not_made_longer(int number)
    {
        var run = new HostileRun();
        run.Play((ulong)number);
        Assert.DoesNotContain(run.Findings.Findings.Keys, kind => kind.StartsWith("energy made", StringComparison.Ordinal));
    }

    /// <summary>
    /// A spin decay that grew beyond friction while a slide ended in closed form, a slide without friction that the air's hold on no spin turned, balls that rose at their
    /// impact by bisection or by rounding, friction that drove a ball into drag far too strong for the piece, a step of 25 million evaluations, an angle that
    /// a snapshot refused, an impact some nanoseconds before its step, a flight without drag that followed the drag law's jump by rounding,
    /// a slide that began in its frame, by the heuristic that promises nothing for it, and an
    /// impact at 10¹² m/s, for which the clock is too coarse.
    /// </summary>
    [Theory]
    [InlineData(30027924)]
    [InlineData(30019276)]
    [InlineData(30011340)]
    [InlineData(30009012)]
    [InlineData(30008573)]
    [InlineData(40004495)]
    [InlineData(50017681)]
    [InlineData(30021615)]
    [InlineData(100007440)]
    [InlineData(100069242)]
    [InlineData(101032772)]
    [InlineData(710065843)]
    [InlineData(720098492)]
    public void A_scene_that_the_lab_found_holds(int number)
    {
        var run = new HostileRun();
        run.Play((ulong)number);
        Assert.Empty(run.Findings.Findings.Keys);
    }

    [Theory]
    [ProfileData("finite")]
    [ProfileData("penetration")]
    [ProfileData("energy made, more than 1 %")]
    [ProfileData("spin reversed in flight")]
    [ProfileData("velocity reversed by drag")]
    [ProfileData("clock")]
    public void A_frame_that_is_forged_is_found(Profile profile, string kind)
    {
        HostileScene scene = HostileGenerator.Make(1) with
        {
            Scene = profile.Scene() with { Gravity = 0, Forces = profile.Forces() with { Buoyancy = false, Magnus = ForceLaw.None } },
            Settings = SolverSettings.Default,
            Frames = [0.01],
        };
        var simulator = new Simulator(scene.Scene, scene.Settings);
        BallState state = simulator.Launch(new Vector3d(0, 5, 0), new Vector3d(20, 0, 0), new Vector3d(0, 30, 0));
        Assert.Empty(Forged(scene, simulator, state, forged => forged));
        Assert.Contains(Forged(scene, simulator, state, forged => Forge(kind, forged)), found => found.Contains(kind, StringComparison.Ordinal));
    }

    private static BallState Forge(string kind, BallState state)
    {
        switch (kind)
        {
            case "finite":
                state.Velocity = new Vector3d(double.NaN, 0, 0);
                break;
            case "penetration":
                state.Position = new Vector3d(0, 0.1, 0);
                break;
            case "clock":
                state.Time += 1e-9;
                break;
            case "spin reversed in flight":
                state.SetFlightSpin(-state.Spin);
                break;
            case "velocity reversed by drag":
                state.Velocity = -state.Velocity;
                break;
            default:
                state.Velocity = 1.2 * state.Velocity;
                break;
        }

        return state;
    }

    /// <summary>What is found in a frame whose end is not what was played.</summary>
    private static IEnumerable<string> Forged(HostileScene scene, Simulator simulator, BallState state, Func<BallState, BallState> forge)
    {
        var findings = new HostileFindings();
        var frame = new HostileFrame(scene, simulator, 0, findings);
        frame.Play(0, ref state, 0.01);
        frame.Forge(forge(state));
        if (HostileStateCheck.Holds(frame))
        {
            HostileEventCheck.Events(frame);
            HostileStateCheck.Energy(frame);
            HostileStateCheck.Reversal(frame);
        }

        return findings.Findings.Keys;
    }

    /// <summary>The tables without those findings that are about time, which is another in every run.</summary>
    private static string Untimed(JsonElement tables) => string.Join('\n', tables.EnumerateArray()
        .SelectMany(table => table.GetProperty("rows").EnumerateArray())
        .Select(row => row.GetRawText())
        .Where(row => !row.Contains("slow frame", StringComparison.Ordinal)));
}
