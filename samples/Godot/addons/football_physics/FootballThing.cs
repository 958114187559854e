#nullable enable
using System;
using System.Collections.Generic;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>An object that every football in the tree can hit: a goal, pitch, wall or keeper. It is drawn as it collides, also in the editor.</summary>
/// <remarks>A change of a field or of the transform takes effect in the next step, and recompiles the scene of every ball.</remarks>
[Tool]
public abstract partial class FootballThing : Node3D, ISerializationListener
{
    private static readonly List<FootballThing> s_all = new();

    private FootballDrawing? _drawing;
    private int _drawn;

    /// <summary>A hash that changes when any football node in the tree changes.</summary>
    internal static int StampOfAll
    {
        get
        {
            var stamp = new HashCode();
            for (int i = 0; i < s_all.Count; i++)
            {
                stamp.Add(s_all[i].Stamp);
            }

            return stamp.ToHashCode();
        }
    }

    /// <summary>The order in which the objects are added: pitches, goals, walls, keepers.</summary>
    internal abstract int Order { get; }

    /// <summary>A hash that changes when the object changes.</summary>
    internal int Stamp => HashCode.Combine(Order, GlobalTransform, StampOfFields());

    /// <summary>All goals in the tree.</summary>
    internal static IEnumerable<FootballGoal> Goals
    {
        get
        {
            foreach (FootballThing thing in s_all)
            {
                if (thing is FootballGoal goal)
                {
                    yield return goal;
                }
            }
        }
    }

    /// <summary>Returns all objects, in the same order on every machine.</summary>
    internal static List<FootballThing> InOrder()
    {
        var things = new List<FootballThing>(s_all);
        things.Sort((a, b) =>
        {
            (Vector3 p, Vector3 q) = (a.GlobalPosition, b.GlobalPosition);
            return (a.Order, p.X, p.Z, p.Y).CompareTo((b.Order, q.X, q.Z, q.Y));
        });
        return things;
    }

    /// <inheritdoc/>
    public override void _EnterTree() => s_all.Add(this);

    /// <inheritdoc/>
    public override void _ExitTree() => s_all.Remove(this);

    /// <inheritdoc/>
    public override void _Ready() => Redraw();

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        if (Stamp != _drawn)
        {
            Redraw();
        }
    }

    /// <summary>Called by Godot before the editor reloads the project's code.</summary>
    public void OnBeforeSerialize()
    {
    }

    /// <summary>Called by Godot after the reload, which clears static fields.</summary>
    public void OnAfterDeserialize()
    {
        if (IsInsideTree() && !s_all.Contains(this))
        {
            s_all.Add(this);
        }
    }

    /// <summary>Adds the object to the scene of a ball.</summary>
    internal abstract void AddTo(FootballScene scene);

    /// <summary>Draws the colliders of the object.</summary>
    internal abstract void Draw(FootballDrawing drawing);

    /// <summary>Returns a number that changes when any property of the object changes.</summary>
    internal abstract int StampOfFields();

    /// <summary>The rotation of the object, without its scale.</summary>
    internal Quaterniond Turn => GodotFrame.FromGodot(GlobalTransform.Basis.GetRotationQuaternion());

    private void Redraw()
    {
        _drawn = Stamp;
        _drawing ??= new FootballDrawing(this);
        _drawing.Clear();
        try
        {
            Draw(_drawing);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            GD.PushError($"{Name}: {refusal.Message}");
        }
    }
}
