using System.Text.Json;

namespace Football.Physics.Tests.Things;

/// <summary>
/// Cases whose reference goes against a sentence of the page that it was computed from. They are compared up to the event where it does.
/// </summary>
internal static class WorldReferenceContradictions
{
    private const double Radius = 0.11;

    /// <summary>The reference is "stopped", at 6 to 12 m/s and where it was hit, or at 0.3 m/s and more off its carrier.</summary>
    private const string FliesOn = "w_s ≥ minimumBounceSpeed flies; a resting ball is woken by a body that hits it";

    /// <summary>The reference is "rolling" on level ground, centimetres above or below it.</summary>
    private const string KeptOnSurface = "the normal part of the acceleration is what keeps the ball on the surface";

    /// <summary>The reference rests with 30 to 100 times that energy in its spin about the normal.</summary>
    private const string RestEnergy = "rests when its energy is below restEnergy";

    /// <summary>The reference slides into what it touches at 0.8 m/s.</summary>
    private const string ImpactWhileApproaching = "impact is the instant at which d(p) = r while (v − V)·n < 0; nothing is ever passed through";

    /// <summary>The surface turns away from the ball, faster than that comes closer, and the impulse of the reference pulls.</summary>
    private const string NoPull = "u_n = u·n < 0";

    /// <summary>By name: how many of its events hold, and the sentence that what follows goes against.</summary>
    public static IReadOnlyDictionary<string, (int Events, string Sentence)> Cases { get; } = new Dictionary<string, (int, string)>
    {
        ["world-net-021"] = (9, RestEnergy),
        ["world-net-025"] = (11, RestEnergy),
        ["world-things-045"] = (5, ImpactWhileApproaching),
        ["world-things-048"] = (9, KeptOnSurface),
        ["world-moving-057"] = (3, FliesOn),
        ["world-moving-058"] = (3, FliesOn),
        ["world-moving-060"] = (3, NoPull),
        ["world-moving-061"] = (4, KeptOnSurface),
        ["world-moving-062"] = (5, FliesOn),
        ["world-moving-064"] = (3, FliesOn),
        ["world-moving-065"] = (2, NoPull),
        ["world-moving-066"] = (3, FliesOn),
        ["world-moving-067"] = (3, FliesOn),
        ["world-moving-068"] = (3, FliesOn),
        ["world-moving-069"] = (3, FliesOn),
        ["world-moving-070"] = (2, NoPull),
    };

    /// <summary>Whether the numbers of a case go against a sentence.</summary>
    public static bool Breaks(JsonElement line, int events, string sentence)
    {
        JsonElement scenario = line.GetProperty("scenario");
        JsonElement expected = line.GetProperty("expected");
        JsonElement ground = scenario.GetProperty("ground");
        JsonElement[] all = [.. expected.GetProperty("events").EnumerateArray()];
        switch (sentence)
        {
            case FliesOn:
                return expected.GetProperty("state").GetString() == "stopped"
                    && Vector(expected, "velocity").Y >= ground.GetProperty("minimumBounceSpeed").GetDouble();
            case KeptOnSurface:
                return expected.GetProperty("state").GetString() == "rolling"
                    && Math.Abs(Vector(expected, "position").Y - ground.GetProperty("height").GetDouble() - Radius) > 0.01;
            case RestEnergy:
                JsonElement ball = scenario.GetProperty("ball");
                double inertia = ball.GetProperty("inertiaFactor").GetDouble() * ball.GetProperty("mass").GetDouble() * Radius * Radius;
                return all[events].GetProperty("kind").GetString() == "rest"
                    && 0.5 * inertia * Vector(all[events], "spin").LengthSquared > 10 * ground.GetProperty("restEnergy").GetDouble();
            case ImpactWhileApproaching:
                JsonElement sphere = scenario.GetProperty("obstacles")[0];
                Vector3d off = Vector(all[events - 1], "position") - Vector(sphere, "center");
                double gap = off.Length - sphere.GetProperty("radius").GetDouble() - Radius;
                return gap < 1e-5 && Vector3d.Dot(Vector(all[events - 1], "velocity"), off / off.Length) < -0.5;
            case NoPull:
                JsonElement foot = scenario.GetProperty("obstacles")[0];
                Vector3d gone = all[events - 1].GetProperty("time").GetDouble() * Vector(foot, "velocity");
                var shape = new CapsuleShape(Vector(foot, "from") + gone, Vector(foot, "to") + gone, foot.GetProperty("radius").GetDouble());
                Vector3d normal = shape.At(Vector(all[events - 1], "position")).Normal;
                return Vector3d.Dot(Vector(all[events - 1], "velocity") - Vector(all[events - 2], "velocity"), in normal) < -0.05;
            default:
                return false;
        }
    }

    private static Vector3d Vector(JsonElement of, string name)
    {
        JsonElement[] numbers = [.. of.GetProperty(name).EnumerateArray()];
        return new Vector3d(numbers[0].GetDouble(), numbers[1].GetDouble(), numbers[2].GetDouble());
    }
}
