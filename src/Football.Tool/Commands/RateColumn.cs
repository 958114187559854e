using System.Globalization;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace FootballPhysics.Tool.Commands;

/// <summary>A column with the rate, per second.</summary>
internal sealed class RateColumn : ProgressColumn
{
    public override IRenderable Render(RenderOptions options, ProgressTask task, TimeSpan deltaTime) => new Text(
        task.Speed is { } speed && double.IsFinite(speed) ? speed.ToString(speed < 10 ? "0.0/s" : "#,0/s", CultureInfo.InvariantCulture) : "");
}
