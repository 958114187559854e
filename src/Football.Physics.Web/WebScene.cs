using System.Runtime.CompilerServices;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Web;

/// <summary>A scene with the bodies that JavaScript moves.</summary>
internal sealed class WebScene
{
    /// <summary>The length of a placement's numbers: kind, time, position, velocity, spin, orientation.</summary>
    private const int Numbers = 15;

    private readonly KinematicBodies? _bodies;
    private readonly double[] _placements;
    private Aimer? _aimer;

    private WebScene(Scene scene, SolverSettings settings)
    {
        Simulator = new Simulator(scene, settings);
        _bodies = scene.Bodies;
        _placements = GC.AllocateArray<double>(Math.Max(1, Numbers * (_bodies?.Count ?? 0)), pinned: true);
    }

    /// <summary>The compiled scene.</summary>
    public Simulator Simulator { get; }

    /// <summary>The address of the placements of the bodies; JavaScript writes them, and the next step applies them.</summary>
    public unsafe int BodyMemory => (int)Unsafe.AsPointer(ref _placements[0]);

    /// <summary>The names of the bodies.</summary>
    public string[] BodyNames => _bodies is null ? [] : [.. _bodies.Select(body => body.Name)];

    /// <summary>Reads, checks and compiles a scene.</summary>
    /// <exception cref="RefusedException">A member is unknown, of the wrong type or out of range.</exception>
    public static WebScene Read(ReadOnlySpan<byte> text)
    {
        // The first JSON takes a fifth of a second in the interpreter. Skip it for the default scene, so that the first ball is not delayed.
        if (text.SequenceEqual("{}"u8))
        {
            return new WebScene(new Scene(), SolverSettings.Default);
        }

        InputFields fields = Json.Fields(text);
        try
        {
            Scene scene = SceneInput.Scene(fields.Root) with { Bodies = WorldInput.Bodies(fields.Root) };
            SolverSettings settings = SceneInput.Solver(fields.Root, out _);
            fields.Check();
            return new WebScene(scene, settings);
        }
        catch (ArgumentException e) when (LibraryRefusal.Of(e, fields) is { } refusal)
        {
            throw refusal;
        }
    }

    /// <summary>Returns the radius of the ball, the viscosity of the air, the hash of the scene and its shapes, as JSON.</summary>
    public string Describe() => Json.Text(json =>
    {
        Scene scene = Simulator.Scene;
        json.WriteNumber("radius", scene.Ball.Radius);
        json.WriteNumber("kinematicViscosity", scene.Air.KinematicViscosity);
        json.WriteString("hash", Simulator.SceneHash.ToString("x16", System.Globalization.CultureInfo.InvariantCulture));
        SceneShapeJson.Write(json, SceneShapes.Of(scene), scene.Goals);
    });

    /// <summary>Applies the placements that JavaScript has written since the last call.</summary>
    /// <param name="time">The time of placements that have none, in s: the time of the ball.</param>
    /// <exception cref="ArgumentException">A placement is out of range; the message contains the name of the body. All placements are discarded.</exception>
    public void PlaceBodies(double time)
    {
        for (int i = 0; i < (_bodies?.Count ?? 0); i++)
        {
            Span<double> p = _placements.AsSpan(Numbers * i, Numbers);
            int kind = (int)p[0];
            if (kind == 0)
            {
                continue;
            }

            p[0] = 0;
            KinematicBody body = _bodies![i];
            try
            {
                if (kind == 3)
                {
                    body.Withdraw();
                    continue;
                }

                Quaterniond turned = kind == 2 ? new Quaterniond(p[11], p[12], p[13], p[14]) : body.Orientation;
                body.MoveTo(new Vector3d(p[2], p[3], p[4]), turned, new Vector3d(p[5], p[6], p[7]), new Vector3d(p[8], p[9], p[10]), double.IsNaN(p[1]) ? time : p[1]);
            }
            catch (ArgumentException e)
            {
                for (int j = i; j < _bodies.Count; j++)
                {
                    _placements[Numbers * j] = 0;
                }

                throw new ArgumentException(FormattableString.Invariant($"bodies[{i}] ({body.Name}): {Guard.Plain(e).Message}"), e);
            }
        }
    }

    /// <summary>Returns the position, velocity, spin and orientation of a body.</summary>
    public double[] Body(int index)
    {
        if (_bodies is null || index < 0 || index >= _bodies.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"body is {index}; allowed: 0 … {(_bodies?.Count ?? 0) - 1}."));
        }

        KinematicBody b = _bodies[index];
        Quaterniond q = b.Orientation;
        return [b.Position.X, b.Position.Y, b.Position.Z, b.Velocity.X, b.Velocity.Y, b.Velocity.Z, b.Spin.X, b.Spin.Y, b.Spin.Z, q.X, q.Y, q.Z, q.W];
    }

    /// <summary>Finds a kick, and returns it as JSON.</summary>
    /// <exception cref="RefusedException">A member is unknown, missing, of the wrong type or out of range.</exception>
    public string Aim(ReadOnlySpan<byte> text)
    {
        InputFields fields = Json.Fields(text);
        AimRequest request = AimInput.Request(fields.Root);
        fields.Check();
        AimResult found;
        try
        {
            found = (_aimer ??= new Aimer(Simulator)).Find(request);
        }
        catch (ArgumentException e) when (LibraryRefusal.Of(e, fields) is { } refusal)
        {
            throw refusal;
        }

        return Json.Text(json =>
        {
            json.WriteString("status", Json.Word(found.Status));
            Json.Write(json, "velocity", found.Velocity);
            Json.Write(json, "spin", found.Spin);
            Json.Write(json, "speed", found.Speed);
            Json.Write(json, "elevation", found.ElevationDegrees);
            Json.Write(json, "azimuth", found.AzimuthDegrees);
            Json.Write(json, "topSpin", found.TopSpin);
            Json.Write(json, "sideSpin", found.SideSpin);
            Json.Write(json, "miss", found.Miss);
            Json.Write(json, "time", found.Time);
            json.WriteString("blockedBy", found.BlockedBy);
            json.WriteString("reason", found.Reason);
        });
    }
}
