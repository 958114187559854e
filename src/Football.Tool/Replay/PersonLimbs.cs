using System.Reflection;
using System.Text.Json;

namespace FootballPhysics.Tool.Replay;

/// <summary>What somebody is drawn of: rods of two radii along a skeleton of feet, shoulders and hands, as the pages' figures.json says.</summary>
/// <param name="From">One end, m.</param>
/// <param name="To">The other end, m.</param>
/// <param name="FromRadius">Radius at the first end, m.</param>
/// <param name="ToRadius">Radius at the other, m.</param>
/// <param name="Colour">#rrggbb.</param>
internal readonly record struct PersonLimbs(Vector3d From, Vector3d To, double FromRadius, double ToRadius, string Colour)
{
    private static readonly JsonElement s_figures = Read();

    /// <summary>The limbs of somebody.</summary>
    /// <param name="skeleton">Feet, shoulders, hands and the direction he faces.</param>
    /// <param name="kit">What he wears, by its name.</param>
    /// <param name="who">Picks his face.</param>
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
