using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace FootballPhysics.Scenarios;

/// <summary>Writes results as JSON, one per line.</summary>
public static class ResultWriter
{
    private static readonly JsonWriterOptions Options = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>Returns the line of a shot that was simulated.</summary>
    public static ReadOnlyMemory<byte> Result(string? name, Outcome outcome) => Line(json =>
    {
        json.WriteString("name", name);
        WriteFinals(json, outcome);
        json.WriteStartArray("events");
        foreach (BallEvent item in outcome.Events)
        {
            WriteEvent(json, in item, outcome);
        }

        json.WriteEndArray();
        if (outcome.Missed > 0)
        {
            json.WriteNumber("missed", outcome.Missed);
        }

        if (outcome.Balls.Count == 0)
        {
            json.WriteNumber("apex", outcome.Apex);
        }

        json.WriteNumber("bounces", outcome.Bounces);
        json.WriteNumber("steps", outcome.Steps);
        json.WriteNumber("evaluations", outcome.Evaluations);
        if (outcome.Derivatives is { } derivatives)
        {
            WriteDerivatives(json, derivatives);
        }

        if (outcome.Samples is not null)
        {
            WriteSamples(json, outcome.Samples);
        }
    });

    /// <summary>Returns the line of a shot that was rejected.</summary>
    public static ReadOnlyMemory<byte> Error(string? name, string message) => Line(json =>
    {
        json.WriteString("name", name);
        json.WriteString("error", message);
    });

    /// <summary>Returns an object on one line.</summary>
    public static ReadOnlyMemory<byte> Line(Action<Utf8JsonWriter> writeMembers)
    {
        var buffer = new ArrayBufferWriter<byte>(1024);
        using (var json = new Utf8JsonWriter(buffer, Options))
        {
            json.WriteStartObject();
            writeMembers(json);
            json.WriteEndObject();
        }

        buffer.Write("\n"u8);
        return buffer.WrittenMemory;
    }

    private static void WriteDerivatives(Utf8JsonWriter json, LaunchDerivatives derivatives)
    {
        json.WriteStartObject("derivatives");
        json.WriteStartObject("position");
        WriteMatrix(json, "velocity", derivatives.PositionByVelocity);
        WriteMatrix(json, "spin", derivatives.PositionBySpin);
        json.WriteEndObject();
        json.WriteStartObject("time");
        WriteVector(json, "velocity", derivatives.TimeByVelocity);
        WriteVector(json, "spin", derivatives.TimeBySpin);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WriteMatrix(Utf8JsonWriter json, string name, in Matrix3d matrix)
    {
        json.WriteStartArray(name);
        foreach (Vector3d row in (ReadOnlySpan<Vector3d>)[matrix.X, matrix.Y, matrix.Z])
        {
            json.WriteStartArray();
            json.WriteNumberValue(row.X);
            json.WriteNumberValue(row.Y);
            json.WriteNumberValue(row.Z);
            json.WriteEndArray();
        }

        json.WriteEndArray();
    }

    /// <summary>Writes the state of a ball as an object.</summary>
    public static void WriteMoment(Utf8JsonWriter json, in Moment moment)
    {
        json.WriteStartObject();
        json.WriteNumber("time", moment.Time);
        json.WriteString("state", moment.State switch
        {
            MotionState.Airborne => "airborne",
            MotionState.Sliding => "sliding",
            MotionState.Rolling => "rolling",
            _ => "stopped",
        });
        WriteVector(json, "position", moment.Position);
        WriteVector(json, "velocity", moment.Velocity);
        WriteVector(json, "spin", moment.Spin);
        WriteRotation(json, "orientation", moment.Orientation);
        json.WriteEndObject();
    }

    private static void WriteFinals(Utf8JsonWriter json, Outcome outcome)
    {
        if (outcome.Balls.Count == 0)
        {
            json.WritePropertyName("final");
            WriteMoment(json, outcome.Final);
            return;
        }

        json.WriteStartArray("balls");
        for (int i = 0; i < outcome.Balls.Count; i++)
        {
            json.WriteStartObject();
            json.WritePropertyName("final");
            WriteMoment(json, outcome.Balls[i]);
            if (outcome.BallSamples.Count > 0)
            {
                WriteSamples(json, outcome.BallSamples[i]);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteSamples(Utf8JsonWriter json, IReadOnlyList<Moment> samples)
    {
        json.WriteStartArray("samples");
        foreach (Moment sample in samples)
        {
            WriteMoment(json, sample);
        }

        json.WriteEndArray();
    }

    private static void WriteEvent(Utf8JsonWriter json, in BallEvent item, Outcome outcome)
    {
        string? surface = outcome.SurfaceOf(in item);
        json.WriteStartObject();
        json.WriteString("kind", item.Kind switch
        {
            BallEventKind.Impact => "impact",
            BallEventKind.Slide => "slide",
            BallEventKind.Roll => "roll",
            BallEventKind.Net => "net",
            BallEventKind.Goal => "goal",
            BallEventKind.ContactEnd => "leave",
            BallEventKind.Pinned => "squeezed",
            BallEventKind.EnterZone => "enterZone",
            BallEventKind.ExitZone => "exitZone",
            _ => "rest",
        });
        if (outcome.Balls.Count > 0)
        {
            json.WriteNumber("ball", item.Ball);
        }

        json.WriteNumber("time", item.Time);
        if (surface is not null)
        {
            json.WriteString("surface", surface);
        }

        WriteVector(json, "position", item.Position);
        if (item.Kind == BallEventKind.Impact)
        {
            WriteVector(json, "velocityBefore", item.VelocityBefore);
            WriteVector(json, "spinBefore", item.SpinBefore);
        }

        WriteVector(json, "velocity", item.Velocity);
        WriteVector(json, "spin", item.Spin);
        if (item.Normal != Vector3d.Zero)
        {
            WriteVector(json, "normal", item.Normal);
        }

        if (item.AddedEnergy > 0)
        {
            json.WriteNumber("addedEnergy", item.AddedEnergy);
        }

        if (outcome.ImpulseOf(item) is { } impulse)
        {
            WriteVector(json, "impulse", impulse);
        }

        if (item.Kind == BallEventKind.Impact)
        {
            Write(json, outcome.ImpactOf(item));
        }

        json.WriteEndObject();
    }

    /// <summary>Writes the outputs of an impact.</summary>
    private static void Write(Utf8JsonWriter json, in Impact impact)
    {
        json.WriteNumber("normalImpulse", impact.NormalImpulse);
        json.WriteNumber("tangentialImpulse", impact.TangentialImpulse);
        json.WriteNumber("slipBefore", impact.SlipBefore);
        json.WriteNumber("slipAfter", impact.SlipAfter);
        json.WriteBoolean("grips", impact.Grips);
        json.WriteNumber("contactTime", impact.ContactTime);
        json.WriteNumber("compression", impact.Compression);
        json.WriteNumber("peakForce", impact.PeakForce);
        json.WriteNumber("energyLost", impact.EnergyLost);
    }

    /// <summary>Writes an orientation as [x, y, z, w].</summary>
    public static void WriteRotation(Utf8JsonWriter json, string name, in Quaterniond rotation)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(rotation.X);
        json.WriteNumberValue(rotation.Y);
        json.WriteNumberValue(rotation.Z);
        json.WriteNumberValue(rotation.W);
        json.WriteEndArray();
    }

    /// <summary>Writes a vector as [x, y, z].</summary>
    public static void WriteVector(Utf8JsonWriter json, string name, in Vector3d vector)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(vector.X);
        json.WriteNumberValue(vector.Y);
        json.WriteNumberValue(vector.Z);
        json.WriteEndArray();
    }
}
