#nullable enable
using System.Collections.Generic;
using FootballPhysics.Engines;
using FootballPhysics.Prediction;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>The scene of one ball: its preset, the football nodes in the tree, and Godot's bodies.</summary>
internal sealed class FootballScene
{
    private readonly List<FootballGoal> _goals = new();
    private readonly List<FootballKeeper> _keepers = new();
    private readonly FootballColliders? _colliders;
    private readonly FootballColliders? _collidersAhead;

    /// <summary>Compiles the scene.</summary>
    public FootballScene(FootballPreset? preset, uint mask, double greatestSpeed, PhysicsDirectSpaceState3D? space)
    {
        Stage = new BallScene(preset?.MakeScene(), preset?.Settings);
        if (mask != 0 && space is not null)
        {
            _colliders = new FootballColliders(space, mask, greatestSpeed, pushes: true);
            _collidersAhead = new FootballColliders(space, mask, greatestSpeed);
            Stage.Colliders = _colliders;
            Stage.PredictionColliders = _collidersAhead;
        }

        foreach (FootballThing thing in FootballThing.InOrder())
        {
            thing.AddTo(this);
        }

        Stage.Compile();
    }

    public BallScene Stage { get; }

    /// <summary>Adds a goal.</summary>
    public void Add(FootballGoal goal, Goal made)
    {
        Stage.Add(made);
        _goals.Add(goal);
    }

    /// <summary>Adds a keeper to a goal, or to the nearest one.</summary>
    public void Add(FootballKeeper keeper, FootballGoal? goal, Vector3d feet, Player abilities)
    {
        int index = goal is not null ? _goals.IndexOf(goal) : Stage.NearestGoal(feet);
        if (index < 0)
        {
            GD.PushWarning($"{keeper.Name}: this keeper has no goal to guard. Add a FootballGoal to the scene.");
            return;
        }

        Stage.AddKeeper(index, feet, abilities);
        _keepers.Add(keeper);
    }

    /// <summary>Sets the time, on the ball's clock, at which the positions of Godot's bodies hold, and the maximum speed of these bodies.</summary>
    public void CollidersAreAt(double time, double greatestSpeed)
    {
        if (_colliders is not null && _collidersAhead is not null)
        {
            _colliders.Time = time;
            _colliders.MaximumSpeed = greatestSpeed;
            _collidersAhead.Time = time;
            _collidersAhead.MaximumSpeed = greatestSpeed;
        }
    }

    /// <summary>Returns the goal of an event; null if there is none.</summary>
    public FootballGoal? GoalOf(in BallEvent happened)
    {
        int goal = happened.ColliderIndex >= 0 ? Stage.GoalOf(in happened) : -1;
        return goal >= 0 ? _goals[goal] : null;
    }

    /// <summary>Returns the name of the surface that an event reports: "ground", "left post", the name of a body.</summary>
    public string NameOf(in BallEvent happened) => Stage.Game.NameOf(happened.ColliderIndex) ?? "";

    /// <summary>Returns the body or the goal that an event reports; null for other objects.</summary>
    public Node3D? NodeOf(in BallEvent happened) => _colliders?.Of(Stage.ColliderOf(in happened)) is { } body ? body : GoalOf(in happened);

    /// <summary>Returns the outputs of an impact, for sound, haptics and looks.</summary>
    public Impact ImpactOf(in BallEvent happened) => Stage.Game.ImpactOf(in happened);

    /// <summary>Applies the impulse to the body that was hit, if it is a dynamic body.</summary>
    public void Push(in BallEvent happened)
    {
        if (happened.Kind == BallEventKind.Impact && _colliders?.Of(Stage.ColliderOf(in happened)) is RigidBody3D { Freeze: false } body)
        {
            Vector3d point = happened.Position - (Stage.Game.Scene.Ball.Radius * happened.Normal);
            body.ApplyImpulse(GodotFrame.ToGodot(-Stage.Game.ImpactOf(in happened).Impulse), GodotFrame.ToGodot(point) - body.GlobalPosition);
        }
    }

    /// <summary>Draws the nets and the keepers in their current shape.</summary>
    public void Draw()
    {
        for (int i = 0; i < _goals.Count; i++)
        {
            if (GodotObject.IsInstanceValid(_goals[i]))
            {
                _goals[i].Follow(Stage.Bulges, Stage.FirstNetOf(i));
            }
        }

        for (int i = 0; i < _keepers.Count; i++)
        {
            if (GodotObject.IsInstanceValid(_keepers[i]))
            {
                _keepers[i].Follow(Stage.Keepers[i]);
            }
        }
    }
}
