#nullable enable
using System;
using System.Collections.Generic;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>A thing that every football in the tree meets: a goal, a pitch, a wall, a keeper. It is drawn as it is hit, in the editor too.</summary>
/// <remarks>What is changed of it, its transform included, counts at the next step; a change compiles the scene of every ball anew.</remarks>
[Tool]
public abstract partial class FootballThing : Node3D, ISerializationListener
{
    private static readonly List<FootballThing> s_all = new();

    private FootballDrawing? _drawing;
    private int _drawn;

    /// <summary>A number that changes when any of the things in the tree does.</summary>
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

    /// <summary>All of them, in an order that is the same on every machine.</summary>
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

    /// <summary>Called before the editor loads the project's code anew.</summary>
    public void OnBeforeSerialize()
    {
    }

    /// <summary>Called when it has: what was static is empty then.</summary>
    public void OnAfterDeserialize()
    {
        if (IsInsideTree() && !s_all.Contains(this))
        {
            s_all.Add(this);
        }
    }

    /// <summary>Adds it to the scene of a ball.</summary>
    internal abstract void AddTo(FootballScene scene);

    /// <summary>Draws its colliders.</summary>
    internal abstract void Draw(FootballDrawing drawing);

    /// <summary>A number that changes when any of its properties does.</summary>
    internal abstract int StampOfFields();

    /// <summary>How it is turned, without its scale.</summary>
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
