// The library in a browser. The page's worker calls these methods with numbers; they do not depend on the drawing.
using System.Buffers;
using System.Runtime.InteropServices.JavaScript;
using System.Runtime.Versioning;
using System.Text;
using System.Text.Json;
using FootballPhysics.Aiming;
using FootballPhysics.Golden;
using FootballPhysics.Prediction;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Web;

[assembly: SupportedOSPlatform("browser")]

internal static partial class Playground
{
    private static readonly Trajectory s_ahead = new();
    private static readonly Dictionary<int, Flight> s_flights = [];
    private static readonly Setting[] s_settings = new Setting[2];
    private static readonly Simulator[] s_simulators = new Simulator[2];
    private static Aimer? s_aimer;

    private static void Main()
    {
    }

    [JSExport]
    internal static string Names() => string.Join(' ', BallProperties.Presets.Keys) + "|" + string.Join(' ', SurfaceMaterial.Presets.Keys.TakeWhile(name => name != "goalFrame"));

    /// <summary>Sets the scene, and returns its objects for the drawing.</summary>
    [JSExport]
    internal static string Set(string profile, string ball, string ground, double altitude, double windAcross, double windAlong, double distance, double aside, int wall, int keeper)
    {
        s_settings[0] = new Setting(profile, ball, ground, altitude, windAcross, windAlong, distance, aside, wall, keeper);
        Scene scene = s_settings[0].Scene(null);
        s_simulators[0] = new Simulator(scene);
        s_aimer = new Aimer(s_simulators[0]);
        var buffer = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            json.WriteNumber("radius", s_settings[0].Start.Y);
            SceneShapeJson.Write(json, SceneShapes.Of(scene), scene.Goals);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(buffer.WrittenSpan);
    }

    /// <summary>Sets a second scene to compare with: the first with other laws and another ball; the ball's radius.</summary>
    [JSExport]
    internal static double Beside(string profile, string ball)
    {
        s_settings[1] = s_settings[0] with { Profile = profile, Ball = ball };
        s_simulators[1] = new Simulator(s_settings[1].Scene(null));
        return s_settings[1].Start.Y;
    }

    /// <summary>The path of a kick in the first or second scene, without the goalkeeper, in the steps of the page: times and positions.</summary>
    [JSExport]
    internal static double[] Ahead(int scene, double speed, double elevation, double azimuth, double top, double side, double seconds)
    {
        Look(scene, speed, elevation, azimuth, top, side, seconds, out _, out _);
        var told = new List<double>();
        for (double time = 0; time <= s_ahead.EndTime + 1e-9; time += 2 * Setting.TimeStep)
        {
            told.AddRange([time, .. Parts(s_ahead.PositionAt(Math.Min(time, s_ahead.EndTime)))]);
        }

        return [.. told];
    }

    /// <summary>Kicks a ball, under a number of the page's.</summary>
    [JSExport]
    internal static void Kick(int number, int scene, double speed, double elevation, double azimuth, double top, double side)
    {
        Look(scene, speed, elevation, azimuth, top, side, 3, out Vector3d velocity, out Vector3d spin);
        s_flights[number] = new Flight(s_settings[scene], s_ahead, velocity, spin);
    }

    /// <summary>Goes on with a ball; what there is to tell of it.</summary>
    [JSExport]
    internal static double[] Advance(int number, double seconds) => s_flights[number].Advance(seconds);

    [JSExport]
    internal static bool IsOver(int number) => s_flights[number].IsOver;

    [JSExport]
    internal static string NameOf(int number, int thing) => s_flights[number].NameOf(thing);

    /// <summary>The goalkeeper's answer in a sentence; empty where there is none.</summary>
    [JSExport]
    internal static string Answer(int number) => s_flights[number].Answer switch
    {
        { Crosses: true, IsOnTarget: true, Saves: true } answer => FormattableString.Invariant($"The keeper can get there if he dives by {answer.LatestReaction:F2} s."),
        { Crosses: true, IsOnTarget: true } answer => FormattableString.Invariant($"Out of the keeper's reach: he covers {answer.ReachRight:F1} m, it is {Math.Abs(answer.LateralOffset):F1} m aside."),
        { Crosses: true } => "Off target.",
        _ => "",
    };

    [JSExport]
    internal static void Forget() => s_flights.Clear();

    /// <summary>The kick that hits a point at a speed, over or round the wall: status, speed, elevation, azimuth, topspin, sidespin, miss, time; as words where there is none.</summary>
    [JSExport]
    internal static string Aim(double x, double y, double z, double speed, double top, double side)
    {
        var request = new AimRequest
        {
            From = s_settings[0].Start,
            Target = new Vector3d(x, y, z),
            Speed = speed,
            TopSpin = top,
            SideSpin = side,
            MaximumElevationDegrees = 60,
            MaximumTopSpin = 70,
            MaximumSideSpin = 90,
            Tolerance = 0.02,
            SpinIsFree = s_settings[0].Wall > 0,
        };
        AimResult found = s_aimer!.Find(request);
        return FormattableString.Invariant(
            $"{found.Status}|{found.Velocity.Length:R}|{found.ElevationDegrees:R}|{found.AzimuthDegrees:R}|{found.TopSpin:R}|{found.SideSpin:R}|{found.Miss:R}|{found.Time:R}|{found.BlockedBy}");
    }

    /// <summary>The C# that plays a kick as it is seen.</summary>
    [JSExport]
    internal static string Code(double speed, double elevation, double azimuth, double top, double side)
    {
        KickVectors.FromAngles(speed, elevation, azimuth, top, side, out Vector3d velocity, out Vector3d spin);
        return s_settings[0].Code(velocity, spin);
    }

    /// <summary>The golden kicks, line by line, as every runtime must play them.</summary>
    [JSExport]
    internal static string Golden() => string.Join('\n', GoldenShots.Lines());

    private static void Look(int scene, double speed, double elevation, double azimuth, double top, double side, double seconds, out Vector3d velocity, out Vector3d spin)
    {
        KickVectors.FromAngles(speed, elevation, azimuth, top, side, out velocity, out spin);
        Simulator simulator = s_simulators[scene];
        simulator.LookAhead(simulator.Launch(s_settings[scene].Start, velocity, spin), new LookAheadRequest { Duration = seconds, TimeStep = Setting.TimeStep, StopAt = StopAt.Rest }, s_ahead);
    }

    private static double[] Parts(Vector3d v) => [v.X, v.Y, v.Z];
}
