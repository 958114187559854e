using System.Xml.Linq;

namespace FootballPhysics.Labs;

/// <summary>One experiment: its rows, its findings and its charts.</summary>
internal sealed record AimSection(string Title, IReadOnlyList<AimRow> Rows)
{
    public string Remark { get; init; } = "";

    public IReadOnlyList<XElement> Charts { get; init; } = [];
}
