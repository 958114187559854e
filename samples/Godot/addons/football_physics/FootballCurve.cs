#if TOOLS
#nullable enable
using System;
using System.IO;
using System.Linq;
using System.Xml.Linq;
using FootballPhysics.Engines;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Draws the drag coefficient of a preset from 0 to 40 m/s, up to 0.6: without spin, and in grey with 60 rad/s. The source of each number is below.</summary>
[Tool]
public partial class FootballCurve : Control
{
    private const float Fastest = 40;
    private const float Highest = 0.6f;
    private const float CurveHeight = 120;
    private const int Places = 80;

    /// <summary>The path of the library's documentation after a build, if the project sets CopyDocumentationFilesFromPackages.</summary>
    private const string Documentation = "res://.godot/mono/temp/bin/Debug/Football.Physics.xml";

    private readonly Label _notes = new() { AutowrapMode = TextServer.AutowrapMode.WordSmart, Position = new Vector2(0, CurveHeight + 4) };
    private int _drawn;

    /// <summary>The preset.</summary>
    public FootballPreset? Preset { get; set; }

    /// <summary>The source of each number.</summary>
    public string Notes => _notes.Text;

    /// <inheritdoc/>
    public override void _Ready()
    {
        CustomMinimumSize = new Vector2(100, CurveHeight + 130);
        AddChild(_notes);
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        if (Preset is not null && Preset.Stamp != _drawn)
        {
            _drawn = Preset.Stamp;
            _notes.Text = Note("BallProperties", Preset.Ball == FootballPreset.BallChoice.Generic ? nameof(BallProperties.Tunnel) : Preset.Ball.ToString()) + Note("SurfaceMaterial", GroundName());
            _notes.Size = new Vector2(Size.X, 120);
            QueueRedraw();
        }
    }

    /// <inheritdoc/>
    public override void _Draw()
    {
        if (Preset is null)
        {
            return;
        }

        try
        {
            Simulator simulator = Preset.Compile();
            DrawPolyline(Curve(simulator, 60), new Color(0.6f, 0.6f, 0.6f), 2);
            DrawPolyline(Curve(simulator, 0), new Color(1, 0.92f, 0.016f), 2);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            _notes.Text = refusal.Message;
        }
    }

    private string GroundName() => Preset!.Surface != FootballPreset.GroundChoice.OfProfile ? Preset.Surface.ToString()
        : Preset.Profile == FootballPreset.ProfileChoice.Measured ? "MatchTurf" : "PublishedTurf";

    private Vector2[] Curve(Simulator simulator, double spin)
    {
        var points = new Vector2[Places];
        for (int i = 0; i < Places; i++)
        {
            float speed = Fastest * (i + 1) / Places;
            float drag = Math.Clamp((float)AirCurve.Drag(simulator, speed, spin), 0, Highest);
            points[i] = new Vector2(Size.X * speed / Fastest, CurveHeight * (1 - (drag / Highest)));
        }

        return points;
    }

    /// <summary>Returns the summary and the remarks of a preset; empty if they are not available.</summary>
    private static string Note(string type, string name)
    {
        string file = ProjectSettings.GlobalizePath(Documentation);
        if (!File.Exists(file))
        {
            return "";
        }

        XElement? found = XDocument.Load(file).Descendants("member").FirstOrDefault(member => (string?)member.Attribute("name") == $"P:FootballPhysics.{type}.{name}");
        string text = $"{found?.Element("summary")?.Value} {found?.Element("remarks")?.Value}";
        return found is null ? "" : $"{name}: {string.Join(' ', text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries))}\n";
    }
}
#endif
