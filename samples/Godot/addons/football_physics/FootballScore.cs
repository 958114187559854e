#nullable enable
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Counts and shows the goals in the tree, and resets the ball after a goal, or when a shot comes to rest.</summary>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballScore : CanvasLayer
{
    private FootballBall? _ball;
    private Label? _label;
    private Vector3 _spot;
    private double _left;

    /// <summary>The delay before the reset, s; 0: no reset.</summary>
    [Export(PropertyHint.Range, "0,10,0.1,suffix:s")]
    public float Again { get; set; } = 2;

    /// <summary>The number of goals so far.</summary>
    public int Goals { get; private set; }

    /// <summary>The number of shots so far: how often a ball left its spot.</summary>
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
            // Wait for the first frame: by then all nodes are ready, whatever their order in the tree.
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
