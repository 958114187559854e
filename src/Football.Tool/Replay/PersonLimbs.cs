using System.Reflection;
using System.Text.Json;

namespace FootballPhysics.Tool.Replay;

/// <summary>A limb of a drawn person: a rod with two radii, placed relative to feet, shoulders and hands as figures.json of the pages defines.</summary>
/// <param name="From">The first end, in m.</param>
/// <param name="To">The second end, in m.</param>
/// <param name="FromRadius">The radius at the first end, in m.</param>
/// <param name="ToRadius">The radius at the second end, in m.</param>
/// <param name="Colour">The colour as #rrggbb.</param>
internal readonly record struct PersonLimbs(Vector3d From, Vector3d To, double FromRadius, double ToRadius, string Colour)
{
    private static readonly JsonElement s_figures = Read();

    /// <summary>Returns the limbs of a person.</summary>
    /// <param name="skeleton">The feet, shoulders, hands and facing direction.</param>
    /// <param name="kit">The name of the kit.</param>
    /// <param name="who">Selects colours of the person, such as that of the skin.</param>
    public static IEnumerable<PersonLimbs> Of(Vector3d[] skeleton, string kit, int who)
    {
        JsonElement colours = s_figures.GetProperty("kits").GetProperty(kit);
        Vector3d up = (skeleton[1] - skeleton[0]).Normalized();
        Vector3d right = Vector3d.Cross(up, skeleton[3]).Normalized();
        Vector3d front = Vector3d.Cross(right, up);
        Vector3d At(JsonElement c) => (c[0].GetDouble() * skeleton[0]) + (c[1].GetDouble() * skeleton[1]) + (c[2].GetDouble() * skeleton[2])
            + (c[3].GetDouble() * right) + (c[4].GetDouble() * front) + (c[5].GetDouble() * up);
        string Picked(string part)
        {
            JsonElement colour = colours.GetProperty(part);
            colour = colour.ValueKind == JsonValueKind.String && colour.GetString() == "" ? colours.GetProperty("skin") : colour;
            return colour.ValueKind == JsonValueKind.Array ? colour[who % colour.GetArrayLength()].GetString()! : colour.GetString()!;
        }

        return s_figures.GetProperty("limbs").EnumerateArray().Select(limb => new PersonLimbs(
            At(limb.GetProperty("from")), At(limb.GetProperty("to")), limb.GetProperty("r")[0].GetDouble(), limb.GetProperty("r")[1].GetDouble(), Picked(limb.GetProperty("part").GetString()!)));
    }

    private static JsonElement Read()
    {
        using Stream figures = Assembly.GetExecutingAssembly().GetManifestResourceStream("Replay.Page.figures.json")!;
        using var document = JsonDocument.Parse(figures);
        return document.RootElement.Clone();
    }
}
