using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool.Fit;

/// <summary>Writes a fit as a line of JSON.</summary>
internal static class FitWriter
{
    public static ReadOnlyMemory<byte> Result(string? name, TrackFitResult fit) => ResultWriter.Line(writer =>
    {
        if (name is not null)
        {
            writer.WriteString("name", name);
        }

        writer.WriteNumber("time", fit.Time);
        writer.WriteStartObject("values");
        for (int i = 0; i < fit.Names.Count; i++)
        {
            writer.WriteNumber(fit.Names[i], fit.Value(i));
        }

        writer.WriteEndObject();
        writer.WriteStartObject("deviations");
        for (int i = 0; i < fit.Names.Count; i++)
        {
            writer.WriteFinite(fit.Names[i], fit.StandardError(i));
        }

        writer.WriteFinite("spin.alongVelocity", fit.SpinAlongVelocityError);
        if (fit.DepthError is { } depth)
        {
            writer.WriteFinite("position.depth", depth);
            writer.WriteFinite("path.depth", fit.PathDepthError);
        }

        writer.WriteEndObject();
        writer.WriteStartArray("unidentified");
        foreach (string unidentified in fit.Unidentified)
        {
            writer.WriteStringValue(unidentified);
        }

        writer.WriteEndArray();
        writer.WriteNumber("chiSquared", fit.ChiSquared);
        writer.WriteNumber("freedom", fit.DegreesOfFreedom);
        writer.WriteNumber("iterations", fit.Iterations);
        writer.WriteBoolean("converged", fit.Converged);
        writer.WriteNumber("probability", fit.Probability);
        writer.WriteString("verdict", fit.Verdict == TrackVerdict.NoiseOverestimated ? "tooWell" : Words.Of(fit.Verdict));
        writer.WriteString("explanation", fit.Explanation);
        writer.WriteString("goodFor", GoodFor(fit));
        MatchWriter.WriteSuspicions(writer, fit.Suspicions);
        if (fit.OtherSpin is { } other)
        {
            ResultWriter.WriteVector(writer, "otherSpin", other);
        }
    });

    /// <summary>Returns the reliable answers of a fit in words.</summary>
    public static string GoodFor(TrackFitResult fit)
    {
        (MatchAnswers Answer, string Word)[] words =
            [(MatchAnswers.Launches, "launch"), (MatchAnswers.Spins, "spin"), (MatchAnswers.WindAndDrag, "drag"), (MatchAnswers.Surface, "surface")];
        string[] good = [.. words.Where(word => fit.GoodFor.HasFlag(word.Answer)).Select(word => word.Word)];
        return good.Length > 0 ? string.Join(", ", good) : "nothing";
    }
}
