using System.Text.Json;
using System.Text.Json.Nodes;
using FootballPhysics.Aiming;
using FootballPhysics.Prediction;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Site.Live;

/// <summary>
/// A live example as C# computes it: the recorded path that a page shows before the first click. The page computes the same numbers by live.js
/// through the npm package; a test compares the two.
/// </summary>
internal sealed class LiveRun
{
    /// <summary>The number of points of a path.</summary>
    public const int Samples = 121;

    private const double TimeStep = 0.01;

    private readonly Dictionary<string, object?> _numbers = [];

    /// <summary>Runs an example.</summary>
    /// <param name="description">Its description, from <see cref="LiveExample.With"/>.</param>
    public LiveRun(JsonObject description)
    {
        using var document = JsonDocument.Parse(description.ToJsonString());
        JsonElement example = document.RootElement;
        Scene scene = example.TryGetProperty("scene", out JsonElement described) ? SceneInput.Scene(new InputFields(described).Root) : new Scene();
        var ball = new Ball(scene);
        AimResult? aim = null;
        if (example.TryGetProperty("aim", out JsonElement request))
        {
            AimRequest wanted = AimInput.Request(new InputFields(request).Root);
            aim = new Aimer(ball.Simulator).Find(wanted);
            ball.Launch(wanted.From, aim.Value.Velocity, aim.Value.Spin);
        }
        else
        {
            ball.Place(example.TryGetProperty("from", out JsonElement from) ? new Vector3d(from[0].GetDouble(), from[1].GetDouble(), from[2].GetDouble()) : new Vector3d(0, scene.Ball.Radius, 0));
            if (example.TryGetProperty("kick", out JsonElement kick))
            {
                ball.Kick(Number(kick, "speed"), Number(kick, "elevation"), Number(kick, "azimuth"), Number(kick, "topSpin"), Number(kick, "sideSpin"));
            }
        }

        double seconds = example.GetProperty("seconds").GetDouble();
        var path = new Trajectory();
        ball.LookAhead(new LookAheadRequest { Duration = seconds, TimeStep = TimeStep, StopAt = Stop(example.GetProperty("stop").GetString()!) }, path);
        Vector3d[] points = new Vector3d[Samples];
        double[] times = new double[Samples];
        for (int i = 0; i < Samples; i++)
        {
            times[i] = Math.Min(path.StartTime + (seconds * i / (Samples - 1)), path.EndTime);
            points[i] = path.PositionAt(times[i]);
        }

        (Times, Points) = (times, points);
        Compute(path, ball);
        if (aim is { } found)
        {
            Compute(found);
        }

        if (example.TryGetProperty("keeper", out JsonElement keeper))
        {
            Compute(new Interception().FindSave(path, Player(new InputFields(keeper).Root), scene.Goals[0]));
        }

        Shown = [.. example.GetProperty("show").EnumerateArray().Select(name => (name.GetString()!, _numbers[name.GetString()!]))];
    }

    public IReadOnlyList<double> Times { get; }

    public IReadOnlyList<Vector3d> Points { get; }

    /// <summary>The results that the page shows: numbers, words, or null for a number that does not exist.</summary>
    public IReadOnlyList<(string Name, object? Value)> Shown { get; }

    private static StopAt Stop(string name) => name switch { "rest" => StopAt.Rest, "impact" => StopAt.Impact, "time" => StopAt.Time, _ => throw new FormatException($"live.json: stop is {name}; allowed: rest, impact, time.") };

    private static double Number(JsonElement of, string name) => of.TryGetProperty(name, out JsonElement number) ? number.GetDouble() : 0;

    private static double? Finite(double number) => double.IsFinite(number) ? number : null;

    private static Player Player(InputObject fields)
    {
        var defaults = new Player();
        return new Player
        {
            Position = fields.Vector("position"),
            Acceleration = fields.Number("acceleration", defaults.Acceleration),
            Speed = fields.Number("speed", defaults.Speed),
            Reach = fields.Number("reach", defaults.Reach),
            MaximumHeight = fields.Number("maximumHeight", defaults.MaximumHeight),
        };
    }

    private void Compute(Trajectory path, Ball ball)
    {
        Vector3d start = Points[0];
        double Along(Vector3d at) => Math.Sqrt(((at.X - start.X) * (at.X - start.X)) + ((at.Z - start.Z) * (at.Z - start.Z)));
        BallEvent? landing = null;
        double? goal = null;
        int bounces = 0;
        var hits = new List<string>();
        foreach (BallEvent happened in path.Events)
        {
            string name = ball.NameOf(happened) ?? "";
            if (happened.Kind == BallEventKind.Goal)
            {
                goal ??= happened.Time;
            }
            else if (happened.Kind == BallEventKind.Impact && name == "ground")
            {
                landing ??= happened;
                bounces++;
            }
            else if (happened.Kind == BallEventKind.Impact)
            {
                hits.Add(name);
            }
        }

        _numbers["apex"] = Points.Max(point => point.Y);
        _numbers["carry"] = landing is { } first ? Along(first.Position) : null;
        _numbers["hang"] = landing?.Time;
        _numbers["bend"] = landing is { } there ? start.X - there.Position.X : null;
        _numbers["speed"] = landing is { VelocityBefore: var v } ? Math.Sqrt((v.X * v.X) + (v.Y * v.Y) + (v.Z * v.Z)) : null;
        _numbers["rise"] = landing is { } bounce ? Points.Where((_, i) => Times[i] > bounce.Time).Select(point => (double?)point.Y).DefaultIfEmpty(null).Max() : null;
        _numbers["bounces"] = (double)bounces;
        _numbers["end"] = Along(Points[^1]);
        _numbers["time"] = Times[^1];
        _numbers["goal"] = goal is null ? "no" : goal;
        _numbers["hits"] = hits.Count == 0 ? "nothing" : string.Join(", ", hits.Distinct());
    }

    private void Compute(AimResult found)
    {
        _numbers["status"] = JsonNamingPolicy.CamelCase.ConvertName(found.Status.ToString());
        _numbers["elevation"] = Finite(found.ElevationDegrees);
        _numbers["azimuth"] = Finite(found.AzimuthDegrees);
        _numbers["topSpin"] = Finite(found.TopSpin);
        _numbers["sideSpin"] = Finite(found.SideSpin);
        _numbers["arrives"] = Finite(found.Time);
    }

    private void Compute(KeeperResult answer)
    {
        _numbers["saved"] = answer.Saves ? "yes" : "no";
        _numbers["latest"] = Finite(answer.LatestReaction);
    }
}
