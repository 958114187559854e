#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Counts and shows the goals in the tree, and puts the ball back after a goal or a shot at rest.</summary>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballScore : CanvasLayer
{
    private FootballBall? _ball;
    private Label? _label;
    private Vector3 _spot;
    private double _left;

    /// <summary>Delay before the ball is put back after a goal or a shot at rest, s; 0: never.</summary>
    [Export(PropertyHint.Range, "0,10,0.1,suffix:s")]
    public float Again { get; set; } = 2;

    /// <summary>Goals so far.</summary>
    public int Goals { get; private set; }

    /// <summary>Shots so far: the number of times a ball left its spot.</summary>
    public int Shots { get; private set; }

    /// <inheritdoc/>
    public override void _Ready()
    {
        _label = new Label { Position = new Vector2(20, 16) };
        AddChild(_label, false, InternalMode.Back);
        Write();
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        if (_ball is null)
        {
            // Whatever the order in the tree: by the first frame all is ready.
            _ball = FootballBall.First;
            _spot = _ball?.GlobalPosition ?? Vector3.Zero;
        }

        int scored = 0;
        foreach (FootballGoal goal in FootballThing.Goals)
        {
            scored += goal.Count;
        }

        if (scored > Goals)
        {
            Goals = scored;
            _left = Again;
            Write();
        }

        if (_ball is null)
        {
            return;
        }

        if (_left > 0)
        {
            _left -= delta;
            if (_left <= 0)
            {
                _ball.Place(_spot);
                Shots++;
                Write();
            }
        }
        else if ((_ball.GlobalPosition - _spot).Length() > 1 && _ball.Motion == MotionState.Rest)
        {
            _left = Again;
        }
    }

    private void Write() => _label!.Text = $"Goals {Goals}   Shots {Shots}";
}
