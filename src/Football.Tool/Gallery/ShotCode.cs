using System.Buffers;
using System.Text;
using System.Text.Json;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Writes a shot as a program and as a command. Both are complete, with goal, wall and goalkeeper, and have all digits.</summary>
internal static class ShotCode
{
    /// <summary>Returns a C# program that simulates the shot and prints its events.</summary>
    /// <param name="scenario">The shot.</param>
    /// <param name="scene">The scene in C#, without goals and obstacles.</param>
    /// <param name="keeper">The goalkeeper who dives in the shot; null if there is none.</param>
    public static string Program(Scenario scenario, string scene, KeeperDive? keeper = null)
    {
        if (keeper is not null)
        {
            return WithKeeper(scenario, scene, keeper);
        }

        string[] things =
        [
            .. Listed("Goals", scenario.Scene.Goals.Select(goal => $"new Goal {{ Center = {Of(goal.Center)}, Facing = {Of(goal.Facing)} }}")),
            .. Listed("Obstacles", scenario.Scene.Obstacles.Select(Of)),
        ];
        string built = things.Length == 0 ? scene : $"{(scene.Contains(' ', StringComparison.Ordinal) && scene != "new Scene()" ? $"({scene})" : scene)} with\n{{\n{string.Concat(things)}}}";
        string place = scenario.Position.Y > scenario.Scene.Ball.Radius || scenario.Position.Y < scenario.Scene.Ball.Radius || scenario.Position.Horizontal.Length > 0 ? $"ball.Place({Of(scenario.Position)});\n" : "";
        return $$"""
            using FootballPhysics;
            {{(scenario.Scene.Obstacles.Count > 0 ? "using FootballPhysics.Shapes;\n" : "")}}
            var ball = new Ball({{built}});
            {{place}}ball.Kick(velocity: {{Of(scenario.Velocity)}}, spin: {{Of(scenario.Spin)}});
            while (ball.Motion != MotionState.Rest)
            {
                ball.Step({{Step(scenario.TimeStep)}});
                foreach (BallEvent happened in ball.Events)
                    Console.WriteLine($"{happened.Time:F6} s: {happened.Kind} {ball.NameOf(happened)} at {happened.Position:F6}");
            }

            """;
    }

    /// <summary>Returns a program for a shot at a goalkeeper of typical abilities.</summary>
    private static string WithKeeper(Scenario scenario, string scene, KeeperDive keeper) => $$"""
        using FootballPhysics;
        using FootballPhysics.Engines;      // the keeper

        var goal = new Goal { Center = {{Of(keeper.Goal.Center)}}, Facing = {{Of(keeper.Goal.Facing)}} };
        var scene = {{scene}} with { Goals = [goal] };
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("keeper", KeeperDive.Kind);
        var keeper = new KeeperDive(body, goal, ahead: new Simulator(scene), feet: {{Of(QueryShots.KeeperFeet)}});
        var ball = new Ball(scene with { Bodies = bodies });
        ball.Kick(velocity: {{Of(scenario.Velocity)}}, spin: {{Of(scenario.Spin)}});
        while (ball.Motion != MotionState.Rest)
        {
            keeper.Follow(ball.State);
            ball.Step({{Step(scenario.TimeStep)}});
            foreach (BallEvent happened in ball.Events)
                Console.WriteLine($"{happened.Time:F6} s: {happened.Kind} {ball.NameOf(happened)} at {happened.Position:F6}");
        }

        """;

    /// <summary>Returns a command that simulates the shot and writes a page that shows it.</summary>
    public static string Command(Scenario scenario, IReadOnlyList<string> fields, string id)
    {
        var buffer = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            json.WriteStartObject("launch");
            Write(json, "position", scenario.Position);
            Write(json, "velocity", scenario.Velocity);
            Write(json, "spin", scenario.Spin);
            json.WriteEndObject();
            if (scenario.Scene.Goals.Count > 0)
            {
                json.WriteStartArray("goals");
                foreach (Goal goal in scenario.Scene.Goals)
                {
                    json.WriteStartObject();
                    Write(json, "center", goal.Center);
                    Write(json, "facing", goal.Facing);
                    json.WriteEndObject();
                }

                json.WriteEndArray();
            }

            if (scenario.Scene.Obstacles.Count > 0)
            {
                json.WriteStartArray("obstacles");
                foreach (Obstacle obstacle in scenario.Scene.Obstacles)
                {
                    Write(json, obstacle);
                }

                json.WriteEndArray();
            }

            json.WriteStartObject("stop");
            json.WriteString("at", "rest");
            json.WriteNumber("time", scenario.Duration);
            json.WriteEndObject();
            json.WriteEndObject();
        }

        string sets = string.Concat(fields.Select(field => $" --set {field}"));
        return $"echo '{Encoding.UTF8.GetString(buffer.WrittenSpan)}' | football replay - -o {id}.html{sets}";
    }

    private static IEnumerable<string> Listed(string name, IEnumerable<string> items)
    {
        string[] all = [.. items];
        return all.Length == 0 ? [] : [$"    {name} =\n    [\n{string.Concat(all.Select(item => $"        {item},\n"))}    ],\n"];
    }

    private static string Of(Obstacle obstacle)
    {
        string shape = obstacle.Shape switch
        {
            BoxShape box when box.Rotation == Quaterniond.Identity => $"new BoxShape({Of(box.Center)}, {Of(box.HalfSize)})",
            BoxShape box => $"new BoxShape({Of(box.Center)}, {Of(box.HalfSize)}, new Quaterniond({Of(box.Rotation.X)}, {Of(box.Rotation.Y)}, {Of(box.Rotation.Z)}, {Of(box.Rotation.W)}))",
            CapsuleShape rod => $"new CapsuleShape({Of(rod.From)}, {Of(rod.To)}, {Of(rod.Radius)})",
            SphereShape ball => $"new SphereShape({Of(ball.Center)}, {Of(ball.Radius)})",
            _ => throw new ArgumentException("No code for this shape.", nameof(obstacle)),
        };
        string surface = Material(obstacle) is { } name ? $", Surface = SurfaceMaterial.Presets[\"{name}\"]" : "";
        string velocity = obstacle.Velocity == Vector3d.Zero ? "" : $", Velocity = {Of(obstacle.Velocity)}";
        return $"new Obstacle {{ Name = \"{obstacle.Name}\", Shape = {shape}{surface}{velocity} }}";
    }

    private static void Write(Utf8JsonWriter json, Obstacle obstacle)
    {
        json.WriteStartObject();
        json.WriteString("name", obstacle.Name);
        switch (obstacle.Shape)
        {
            case BoxShape box:
                json.WriteString("shape", "box");
                Write(json, "center", box.Center);
                Write(json, "halfSize", box.HalfSize);
                json.WriteStartArray("rotation");
                foreach (double part in new[] { box.Rotation.X, box.Rotation.Y, box.Rotation.Z, box.Rotation.W })
                {
                    json.WriteNumberValue(part);
                }

                json.WriteEndArray();
                break;
            case CapsuleShape rod:
                json.WriteString("shape", "capsule");
                Write(json, "from", rod.From);
                Write(json, "to", rod.To);
                json.WriteNumber("radius", rod.Radius);
                break;
            case SphereShape ball:
                json.WriteString("shape", "sphere");
                Write(json, "center", ball.Center);
                json.WriteNumber("radius", ball.Radius);
                break;
            default:
                throw new ArgumentException("No JSON for this shape.", nameof(obstacle));
        }

        if (Material(obstacle) is { } material)
        {
            json.WriteStartObject("surface");
            json.WriteString("material", material);
            json.WriteEndObject();
        }

        if (obstacle.Velocity != Vector3d.Zero)
        {
            Write(json, "velocity", obstacle.Velocity);
        }

        json.WriteEndObject();
    }

    /// <summary>Returns the name of an obstacle's material; null for the default material of obstacles.</summary>
    private static string? Material(Obstacle obstacle) =>
        obstacle.Surface == SurfaceMaterial.GoalFrame ? null : SurfaceMaterial.Presets.First(preset => preset.Value == obstacle.Surface).Key;

    private static void Write(Utf8JsonWriter json, string name, Vector3d v)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(v.X + 0.0);
        json.WriteNumberValue(v.Y + 0.0);
        json.WriteNumberValue(v.Z + 0.0);
        json.WriteEndArray();
    }

    private static string Of(double number) => FormattableString.Invariant($"{number + 0.0:R}");

    /// <summary>Returns a frame time as a double: <see cref="Ball.Step(double)"/> takes no whole numbers.</summary>
    private static string Step(double time) => Of(time) is var text && text.All(char.IsDigit) ? text + ".0" : text;

    private static string Of(Vector3d v) => $"new Vector3d({Of(v.X)}, {Of(v.Y)}, {Of(v.Z)})";
}
