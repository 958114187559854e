using System.Globalization;
using System.Runtime.InteropServices.JavaScript;
using System.Text;
using FootballPhysics.Golden;

namespace FootballPhysics.Web;

/// <summary>The functions that JavaScript calls. Scenes and balls have numbers, which JavaScript frees.</summary>
internal static partial class Engine
{
    private static readonly Slots<WebScene> s_scenes = new("scene");
    private static readonly Slots<WebBall> s_balls = new("ball");

    /// <summary>Returns the version, and the names of balls, grounds and materials, as JSON.</summary>
    [JSExport]
    internal static string Names() => Json.Text(json =>
    {
        json.WriteString("version", typeof(Scene).Assembly.GetName().Version!.ToString(3));
        json.WriteStartObject("balls");
        foreach ((string name, BallProperties ball) in BallProperties.Presets)
        {
            json.WriteStartObject(name);
            json.WriteNumber("mass", ball.Mass);
            json.WriteNumber("radius", ball.Radius);
            json.WriteNumber("inertiaFactor", ball.InertiaFactor);
            json.WriteNumber("bounce", ball.Bounce);
            json.WriteEndObject();
        }

        json.WriteEndObject();
        Json.Write(json, "grounds", Ground.Presets.Keys);
        Json.Write(json, "materials", SurfaceMaterial.Presets.Keys);
    });

    /// <summary>Reads, checks and compiles a scene.</summary>
    /// <param name="text">The members of a scenario that describe a scene, as JSON.</param>
    [JSExport]
    internal static int CreateScene(string text) => Guard.Call(() => s_scenes.Add(WebScene.Read(Encoding.UTF8.GetBytes(text))));

    [JSExport]
    internal static void FreeScene(int scene) => s_scenes.Remove(scene);

    /// <summary>Returns the radius of the ball, the hash of the scene and its shapes, as JSON.</summary>
    [JSExport]
    internal static string DescribeScene(int scene) => Guard.Call(() => s_scenes[scene].Describe());

    /// <summary>Returns the names of all objects, by index.</summary>
    [JSExport]
    internal static string[] SceneNames(int scene) => Guard.Call(() => s_scenes[scene].Simulator.Names.ToArray());

    /// <summary>Returns the names of the bodies.</summary>
    [JSExport]
    internal static string[] BodyNames(int scene) => Guard.Call(() => s_scenes[scene].BodyNames);

    /// <summary>Returns the address of the placements of the bodies.</summary>
    [JSExport]
    internal static int BodyMemory(int scene) => Guard.Call(() => s_scenes[scene].BodyMemory);

    /// <summary>Finds a kick, and returns it as JSON.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="request">The members of a scenario's aim, as JSON.</param>
    [JSExport]
    internal static string Aim(int scene, string request) => Guard.Call(() => s_scenes[scene].Aim(Encoding.UTF8.GetBytes(request)));

    /// <summary>Computes the velocity and the spin of a kick at a speed and two angles.</summary>
    [JSExport]
    internal static double[] KickVector(double speed, double elevation, double azimuth, double topSpin, double sideSpin) => Guard.Call(() =>
    {
        KickVectors.FromAngles(speed, elevation, azimuth, topSpin, sideSpin, out Vector3d velocity, out Vector3d spin);
        return new[] { velocity.X, velocity.Y, velocity.Z, spin.X, spin.Y, spin.Z };
    });

    /// <summary>Returns the golden kicks, line by line. Every runtime must produce the same lines.</summary>
    /// <param name="every">1 for all lines. Above 1: only every so many kicks and scenes, and no totals.</param>
    [JSExport]
    internal static string Golden(int every) => string.Join('\n', GoldenShots.Lines(every));

    /// <summary>Stores objects under numbers.</summary>
    /// <param name="name">The noun for an object in messages.</param>
    private sealed class Slots<T>(string name)
        where T : class
    {
        private readonly List<T?> _all = [];
        private readonly Stack<int> _free = [];

        public T this[int number] => number >= 0 && number < _all.Count && _all[number] is { } found
            ? found
            : throw new ArgumentException(string.Create(CultureInfo.InvariantCulture, $"The {name} was freed. Create a new one."));

        public int Add(T item)
        {
            if (_free.TryPop(out int number))
            {
                _all[number] = item;
                return number;
            }

            _all.Add(item);
            return _all.Count - 1;
        }

        public void Remove(int number)
        {
            if (number >= 0 && number < _all.Count && _all[number] is not null)
            {
                _all[number] = null;
                _free.Push(number);
            }
        }
    }
}
