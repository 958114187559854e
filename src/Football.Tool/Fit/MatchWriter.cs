using System.Text.Json;
using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool.Fit;

/// <summary>Writes the fit of a match as lines of JSON: the pieces in order of time, then a summary.</summary>
internal static class MatchWriter
{
    /// <summary>Returns the word for a kind of piece.</summary>
    public static string Word(MatchPieceKind kind) => kind switch
    {
        MatchPieceKind.Flight => "flight",
        MatchPieceKind.Impact => "impact",
        MatchPieceKind.Ground => "ground",
        MatchPieceKind.Touch => "touch",
        _ => "lost",
    };

    /// <summary>Returns the word for a motion on the ground.</summary>
    public static string Word(MotionState motion) => motion == MotionState.Sliding ? "sliding" : "rolling";

    /// <summary>Returns c₀ + c₁ v at the mean speed of the windows in which the ball rolls.</summary>
    public static double RollingResistance(MatchFitResult fit) => fit.Scene.Ground.Material.RollingResistance + (fit.Scene.Ground.Material.RollingResistancePerSpeed * fit.RollingSpeed);

    /// <summary>Returns the line of a piece. For a piece on the ground, it lists the windows in which the ball slides or rolls untouched.</summary>
    public static ReadOnlyMemory<byte> Piece(MatchPiece piece, MatchFitResult fit) => ResultWriter.Line(json =>
    {
        json.WriteString("kind", Word(piece.Kind));
        json.WriteNumber("from", piece.StartTime);
        json.WriteNumber("to", piece.EndTime);
        json.WriteNumber("points", piece.Points);
        json.WriteNumber("rms", piece.Rms);
        json.WriteNumber("worst", piece.MaximumResidual);
        ResultWriter.WriteVector(json, "position", piece.Position);
        ResultWriter.WriteVector(json, "velocity", piece.Velocity);
        ResultWriter.WriteVector(json, "spin", piece.Spin);
        if (piece.Kind is MatchPieceKind.Impact or MatchPieceKind.Touch)
        {
            ResultWriter.WriteVector(json, "velocityBefore", piece.VelocityBefore);
            ResultWriter.WriteVector(json, "spinBefore", piece.SpinBefore);
        }

        if (piece.Kind == MatchPieceKind.Impact)
        {
            json.WriteFinite("restitution", piece.Restitution);
            json.WriteNumber("kept", piece.SpeedRetained);
        }

        if (piece.Kind == MatchPieceKind.Ground)
        {
            WriteWindows(json, piece, fit);
        }

        json.WriteStartObject("deviations");
        if (piece.VelocityDeviation != Vector3d.Zero)
        {
            ResultWriter.WriteVector(json, "velocity", piece.VelocityDeviation);
            ResultWriter.WriteVector(json, "spin", piece.SpinDeviation);
        }

        json.WriteEndObject();
    });

    /// <summary>
    /// Returns the line of the summary. "fitted" has the parameters of the complete track, "deviations" the standard errors of the estimated ones.
    /// </summary>
    public static ReadOnlyMemory<byte> Summary(MatchFitResult fit) => ResultWriter.Line(json =>
    {
        json.WriteString("kind", "summary");
        json.WriteNumber("rms", fit.Rms);
        json.WriteNumber("flights", fit.Flights);
        json.WriteNumber("covered", fit.Covered);
        json.WriteNumber("impacts", fit.Impacts);
        json.WriteNumber("noise", fit.Noise);
        json.WriteStartObject("fitted");
        ResultWriter.WriteVector(json, "wind", fit.Scene.Air.Wind);
        json.WriteNumber("drag", Of(fit, "drag") ?? 1);
        json.WriteNumber("crisis", fit.Scene.Ball.DragCurve.CriticalReynolds);
        json.WriteNumber("lift", Of(fit, "lift") ?? 1);
        json.WriteNumber("groundHeight", fit.Scene.Ground.Height);
        json.WriteNumber("restitution", fit.Scene.Ground.Material.NormalRestitution);
        json.WriteNumber("restitutionRise", fit.Scene.Ground.Material.GrazingRestitutionGain);
        json.WriteFinite("friction", fit.Scene.Ground.Material.ImpactFriction);
        json.WriteNumber("slidingFriction", fit.Scene.Ground.Material.SlidingFriction);
        json.WriteNumber("rollingFriction", fit.Scene.Ground.Material.RollingResistance);
        json.WriteNumber("rollingFrictionBySpeed", fit.Scene.Ground.Material.RollingResistancePerSpeed);
        json.WriteEndObject();
        json.WriteStartObject("deviations");
        WriteDeviations(json, fit);
        json.WriteEndObject();
        WriteRolling(json, fit);
        WriteRobotSoccer(json, fit);
        json.WriteString("goodFor", fit.Explanation);
        WriteSuspicions(json, fit.Suspicions);
    });

    /// <summary>Writes the suspected faults of a track as a list.</summary>
    public static void WriteSuspicions(Utf8JsonWriter json, TrackSuspicions suspicions)
    {
        json.WriteStartArray("suspicions");
        foreach (TrackSuspicions fault in Enum.GetValues<TrackSuspicions>().Where(fault => fault != 0 && suspicions.HasFlag(fault)))
        {
            json.WriteStringValue(JsonNamingPolicy.CamelCase.ConvertName(fault.ToString()));
        }

        json.WriteEndArray();
    }

    private static void WriteWindows(Utf8JsonWriter json, MatchPiece piece, MatchFitResult fit)
    {
        json.WriteStartArray("windows");
        foreach (GroundWindow window in fit.Windows.Where(window => window.StartTime >= piece.StartTime && window.EndTime <= piece.EndTime))
        {
            json.WriteStartObject();
            json.WriteString("motion", Word(window.Motion));
            json.WriteNumber("from", window.StartTime);
            json.WriteNumber("to", window.EndTime);
            json.WriteNumber("points", window.Points);
            json.WriteNumber("speed", window.Speed);
            json.WriteNumber("resistance", window.Resistance);
            json.WriteNumber("deviation", window.StandardError);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <summary>Writes the numbers of slides and rolls, and the rolling resistance at the speed at which it is most accurate.</summary>
    private static void WriteRolling(Utf8JsonWriter json, MatchFitResult fit)
    {
        json.WriteNumber("slides", fit.Windows.Count(window => window.Motion == MotionState.Sliding));
        json.WriteNumber("rolls", fit.Windows.Count(window => window.Motion == MotionState.Rolling));
        if (fit.RollingSpeed > 0)
        {
            json.WriteStartObject("rolling");
            json.WriteNumber("speed", fit.RollingSpeed);
            json.WriteNumber("resistance", RollingResistance(fit));
            json.WriteNumber("deviation", fit.RollingDeviation);
            json.WriteEndObject();
        }
        else
        {
            json.WriteNull("rolling");
        }
    }

    /// <summary>Writes the fitted ball in the terms and names of robot soccer.</summary>
    private static void WriteRobotSoccer(Utf8JsonWriter json, MatchFitResult fit)
    {
        if (RobotSoccerModel.Of(fit.Scene) is { } model)
        {
            json.WriteStartObject("robotSoccer");
            json.WriteNumber("acc_slide", model.SlideAcceleration);
            json.WriteNumber("acc_roll", model.RollAcceleration);
            json.WriteNumber("k_switch", model.SwitchFraction);
            json.WriteNumber("damping_xy_first_hop", model.FirstHopDamping);
            json.WriteNumber("damping_xy_other_hops", model.OtherHopsDamping);
            json.WriteNumber("damping_z", model.VerticalDamping);
            json.WriteEndObject();
        }
        else
        {
            json.WriteNull("robotSoccer");
        }
    }

    private static void WriteDeviations(Utf8JsonWriter json, MatchFitResult fit)
    {
        for (int i = 0; i < fit.Names.Count; i++)
        {
            if (fit.Names[i] == "wind.x")
            {
                ResultWriter.WriteVector(json, "wind", new Vector3d(fit.StandardError(i), 0, fit.StandardError(i + 1)));
            }
            else if (fit.Names[i] != "wind.z")
            {
                json.WriteNumber(fit.Names[i], fit.StandardError(i));
            }
        }
    }

    private static double? Of(MatchFitResult fit, string name)
    {
        for (int i = 0; i < fit.Names.Count; i++)
        {
            if (fit.Names[i] == name)
            {
                return fit.Value(i);
            }
        }

        return null;
    }
}
