using System.Text.Json;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Native;

/// <summary>Reads scenes and requests from JSON. Their members are those of a scenario.</summary>
internal static unsafe class Requests
{
    /// <summary>Checks the caller's text, and returns it without a copy.</summary>
    public static ReadOnlySpan<byte> Text(byte* json, long bytes, string name)
    {
        Guard.Given(json, name);
        if (bytes < 0 || bytes > LineReader.LongestInput)
        {
            throw Guard.Refusal(name + "_bytes", bytes.ToString(System.Globalization.CultureInfo.InvariantCulture), $"0 … {LineReader.LongestInput}");
        }

        return new ReadOnlySpan<byte>(json, (int)bytes);
    }

    /// <summary>Reads, checks and compiles a scene.</summary>
    /// <exception cref="RefusedException">A member is unknown, of the wrong type or out of range.</exception>
    public static CompiledScene Scene(ReadOnlySpan<byte> json) => Read(json, hasBodies: false, (scene, settings, _) =>
    {
        // Balls and threads share a scene, so none of them may move an object in it.
        for (int i = 0; i < scene.Obstacles.Count; i++)
        {
            if (double.IsFinite(scene.Obstacles[i].Mass))
            {
                throw new RefusedException($"obstacles[{i}].mass", scene.Obstacles[i].Mass.ToString(System.Globalization.CultureInfo.InvariantCulture), "no mass, because all balls share a scene; leave it out");
            }
        }

        return new CompiledScene(scene, settings);
    });

    /// <summary>Reads the scene of a match, and creates the match.</summary>
    /// <exception cref="RefusedException">A member is unknown, of the wrong type or out of range.</exception>
    public static Match Match(ReadOnlySpan<byte> json, int balls, double dt) => Read(json, hasBodies: true, (scene, settings, kinds) =>
        new Match(new FixedStepRunner(kinds!.Group(scene, settings, balls), dt, dt), null));

    /// <summary>Reads the scene of a recording, and creates a match that replays it.</summary>
    /// <exception cref="RefusedException">A member is unknown, of the wrong type or out of range.</exception>
    /// <exception cref="FormatException">The recording is corrupt.</exception>
    public static Match Replay(ReadOnlySpan<byte> json, ReadOnlySpan<byte> bytes)
    {
        Recording recording = Recording.FromBytes(bytes);
        BallGroup group = Read(json, hasBodies: true, (scene, settings, kinds) => kinds!.Group(scene, settings, recording.Balls));
        return new Match(recording.Replay(group), recording);
    }

    /// <summary>Reads a request, and finds a kick.</summary>
    /// <exception cref="RefusedException">A member is unknown, missing, of the wrong type or out of range.</exception>
    public static AimResult Aim(CompiledScene scene, ReadOnlySpan<byte> json)
    {
        InputFields fields = Fields(json);
        AimRequest request = AimInput.Request(fields.Root);
        fields.Check();
        Aimer aimer = scene.TakeAimer();
        AimResult found = Translated(fields, () => aimer.Find(request));
        scene.GiveBack(aimer);
        return found;
    }

    /// <summary>Reads a shot, and computes its probability to score.</summary>
    /// <exception cref="RefusedException">A member is unknown, missing, of the wrong type or out of range.</exception>
    /// <exception cref="OperationCanceledException">The search was cancelled.</exception>
    public static GoalChanceResult GoalChance(CompiledScene scene, ReadOnlySpan<byte> json, IProgress<double>? progress, CancellationToken cancellation)
    {
        InputFields fields = Fields(json);
        GoalChanceRequest request = GoalChanceInput.Request(fields.Root, scene.Simulator.Scene.Goals);
        fields.Check();
        GoalChance search = scene.TakeGoalChance();
        GoalChanceResult found = Translated(fields, () => search.Find(request, progress, cancellation));
        scene.GiveBack(search);
        return found;
    }

    /// <summary>Reads the request for a fit of one flight.</summary>
    /// <exception cref="RefusedException">A member is unknown or of the wrong type.</exception>
    public static TrackFitRequest Fit(ReadOnlySpan<byte> json) => Checked(json, FitInput.Track);

    /// <summary>Reads the request for a fit of a match.</summary>
    /// <exception cref="RefusedException">A member is unknown or of the wrong type.</exception>
    public static MatchFitRequest MatchFit(ReadOnlySpan<byte> json) => Checked(json, FitInput.Match);

    /// <summary>Returns the parameter with a name of <see cref="MatchFitResult.Names"/>.</summary>
    public static NativeFitParameter Parameter(string name) => Enum.Parse<NativeFitParameter>(name.Replace(".", ""), ignoreCase: true);

    private static T Checked<T>(ReadOnlySpan<byte> json, Func<InputObject, T> read)
    {
        InputFields fields = Fields(json);
        T request = read(fields.Root);
        fields.Check();
        return request;
    }

    private static T Translated<T>(InputFields fields, Func<T> find)
    {
        try
        {
            return find();
        }
        catch (ArgumentException e) when (LibraryRefusal.Of(e, fields) is { } refusal)
        {
            throw refusal;
        }
    }

    private static T Read<T>(ReadOnlySpan<byte> json, bool hasBodies, Func<Scene, SolverSettings, MatchBalls?, T> make)
    {
        InputFields fields = Fields(json);
        return Translated(fields, () =>
        {
            Scene scene = SceneInput.Scene(fields.Root);
            scene = hasBodies ? scene with { Bodies = WorldInput.Bodies(fields.Root) } : scene;
            MatchBalls? balls = hasBodies ? MatchBalls.Of(fields.Root, scene.Ball) : null;
            SolverSettings settings = SceneInput.Solver(fields.Root, out _);
            fields.Check();
            return make(scene, settings, balls);
        });
    }

    private static InputFields Fields(ReadOnlySpan<byte> json)
    {
        JsonFault? fault = JsonText.Parse(json, out JsonElement root);
        return fault is null ? new InputFields(root) : throw new RefusedException(fault.Path.Length > 0 ? fault.Path : "the input", fault.Value, fault.Expected);
    }
}
