using System.Text.Json;
using System.Xml;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Recognises tracker files that are not CSV, and reads them.</summary>
/// <remarks>
/// Each layout follows a public parser or specification. TRACAB's lines and JSON, Sportec and the DFL, Second Spectrum, Hawk-Eye, Stats Perform MA25,
/// SkillCorner, PFF and Signality: kloppy (github.com/PySport/kloppy, kloppy/infra/serializers/tracking, and the files in kloppy/tests/files). The
/// Common Data Format: its schema (github.com/UnravelSports/common-data-format-validator, cdf/files/v0.2.3/schema/tracking.json).
/// </remarks>
internal static class TrackLayouts
{
    /// <summary>Returns the table of a file; null if it has none of these layouts.</summary>
    public static TrackTable? Find(string text, TrackFormat format, Action<string> report)
    {
        ReadOnlySpan<char> start = text.AsSpan().TrimStart();
        try
        {
            return start.StartsWith("<") ? TrackXml.Read(text, report)
                : start.StartsWith("{") || start.StartsWith("[") ? TrackJson.Read(text, format, report)
                : TrackFrames.Find(text, report);
        }
        catch (Exception e) when (e is JsonException or XmlException or InvalidOperationException)
        {
            throw new RefusedException($"TRACK is not valid {(e is XmlException ? "XML" : "JSON")} ({Quote.Short(e.Message)}). Write it anew, or as CSV with a header t,x,y,z.");
        }
    }
}
