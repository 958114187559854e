using System.Globalization;
using System.Text;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Scenes;

/// <summary>The numbers of a scenario's scene as the code lists them: unit, range, default and its evidence.</summary>
internal static class FieldTable
{
    /// <summary>The table in Markdown.</summary>
    public static string Markdown()
    {
        var text = new StringBuilder("\n| field | meaning | unit | allowed | default | evidence |\n|---|---|---|---|--:|---|\n");
        Add(text, "ball", SceneFields.Ball, BallProperties.Modern);
        Add(text, "ball.dragCurve", SceneFields.Drag, DragCurve.Modern);
        Add(text, "dials", SceneFields.Dials, new Dials());
        Add(text, "air", SceneFields.Air, new Air());
        Add(text, "forces", SceneFields.Forces, ForceSet.Measured);
        Add(text, "ground", SceneFields.Ground, new Ground());
        Add(text, "ground", SceneFields.Material, SurfaceMaterial.MatchTurf);
        Add(text, "net", SceneFields.Net, new Net { Center = default, Normal = default, Along = default, HalfLength = 1, HalfWidth = 1 });
        return text.Append('\n').ToString();
    }

    private static void Add<T>(StringBuilder text, string part, NumberField<T>[] fields, T defaults)
    {
        foreach (NumberField<T> field in fields)
        {
            string most = double.IsPositiveInfinity(field.Most) || field.Most == double.MaxValue ? "∞" : Text(field.Most);
            string allowed = field.IsAboveLeast ? $"above {Text(field.Least)} … {most}" : $"{Text(field.Least)} … {most}";
            text.Append(CultureInfo.InvariantCulture, $"| `{part}.{field.Name}` | {field.Meaning} | {field.Unit} | {allowed} | {Text(field.Get(defaults))} | {field.Evidence} |\n");
        }
    }

    private static string Text(double value) => value.ToString(Math.Abs(value) is >= 1e6 or (> 0 and < 1e-3) ? "0.####e-0" : Math.Abs(value) > 1000 ? "0" : "0.#####", CultureInfo.InvariantCulture);
}
