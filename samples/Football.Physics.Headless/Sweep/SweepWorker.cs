using System.Buffers;
using System.Text.Json;
using Football.Physics.Headless.Simulate;

namespace Football.Physics.Headless.Sweep;

/// <summary>Draws, flies and writes a run of rows, on one thread.</summary>
internal sealed class SweepWorker
{
    private readonly SweepScenario _sweep;
    private readonly long _seed;
    private readonly BallBatch _batch;
    private readonly KickNumbers[] _kicks;
    private readonly BatchLaunches _launches;
    private readonly BatchFlights _flights;
    private readonly ArrayBufferWriter<byte> _rows = new(1 << 16);

    public SweepWorker(SweepScenario sweep, long seed, int capacity)
    {
        _sweep = sweep;
        _seed = seed;
        _batch = new BallBatch(sweep.Scene, sweep.Settings);
        _kicks = new KickNumbers[capacity];
        _launches = new BatchLaunches(capacity);
        _flights = new BatchFlights(capacity);
    }

    /// <summary>The rows of the last run.</summary>
    public ReadOnlySpan<byte> Rows => _rows.WrittenSpan;

    public void Run(long from, int count)
    {
        for (int i = 0; i < count; i++)
        {
            _kicks[i] = _sweep.Draw(_seed, from + i);
            _kicks[i].Vectors(out Vector3d velocity, out Vector3d spin);
            _launches.Set(i, _sweep.From, velocity, spin);
        }

        _batch.Fly(_launches, _flights, count, _sweep.Duration);
        _rows.ResetWrittenCount();
        using var json = new Utf8JsonWriter(_rows);
        for (int i = 0; i < count; i++)
        {
            WriteRow(json, from + i, i);
            json.Flush();
            json.Reset();
            _rows.Write("\n"u8);
        }
    }

    private void WriteRow(Utf8JsonWriter json, long index, int i)
    {
        ref readonly KickNumbers kick = ref _kicks[i];
        json.WriteStartObject();
        json.WriteNumber("index", index);
        json.WriteNumber("speed", kick.Speed);
        json.WriteNumber("elevation", kick.Elevation);
        json.WriteNumber("azimuth", kick.Azimuth);
        json.WriteNumber("topSpin", kick.TopSpin);
        json.WriteNumber("sideSpin", kick.SideSpin);
        json.WriteString("end", _flights.End[i] switch
        {
            BatchEnd.Impact => "impact",
            BatchEnd.Time => "time",
            _ => "ground",
        });
        json.WriteNumber("time", _flights.Time[i]);
        Write(json, "position", _flights.Position[i]);
        Write(json, "velocity", _flights.Velocity[i]);
        Write(json, "spin", _flights.Spin[i]);
        Write(json, "velocityAfter", _flights.VelocityAfter[i]);
        Write(json, "spinAfter", _flights.SpinAfter[i]);
        json.WriteNumber("apex", _flights.Apex[i]);
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, string name, Vector3d v)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(v.X);
        json.WriteNumberValue(v.Y);
        json.WriteNumberValue(v.Z);
        json.WriteEndArray();
    }
}
