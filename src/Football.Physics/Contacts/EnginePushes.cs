using System.Runtime.CompilerServices;
using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>The engine colliders that the ball has pushed since the engine placed them, with their saved motions.</summary>
internal sealed class EnginePushes
{
    private static readonly ConditionalWeakTable<IEngineColliders, EnginePushes> s_all = new();

    private readonly List<EngineCollider> _pushed = [];
    private IReadOnlyList<(EngineCollider Collider, EnginePush Push)>? _held;

    /// <summary>Returns the pushes of an engine.</summary>
    /// <remarks>Several simulators may share an engine, such as those of a match and its look-aheads. They share its pushed colliders
    /// too.</remarks>
    public static EnginePushes Of(IEngineColliders engine) => s_all.GetValue(engine, _ => new EnginePushes());

    /// <summary>Records a collider before it is pushed.</summary>
    public void Note(EngineCollider collider)
    {
        ForgetBefore(collider.Placement.Motion.Time);
        if (!_pushed.Contains(collider))
        {
            _pushed.Add(collider);
        }
    }

    /// <summary>Removes the pushes of earlier times: a push is valid until the engine's time advances.</summary>
    /// <param name="time">The engine's time, s.</param>
    public void ForgetBefore(double time)
    {
        for (int i = _pushed.Count - 1; i >= 0; i--)
        {
            if (_pushed[i].PushedAt != time && !IsKept(_pushed[i]))
            {
                _pushed[i].ForgetPush();
                _pushed.RemoveAt(i);
            }
        }
    }

    /// <summary>Holds the pushes that a look-ahead has saved, until it restores them.</summary>
    /// <param name="saved">The saved pushes; null at the end of the look-ahead.</param>
    public void Hold(IReadOnlyList<(EngineCollider Collider, EnginePush Push)>? saved) => _held = saved;

    /// <summary>Copies the pushes.</summary>
    public void Read(List<(EngineCollider Collider, EnginePush Push)> into)
    {
        into.Clear();
        for (int i = 0; i < _pushed.Count; i++)
        {
            into.Add((_pushed[i], _pushed[i].PushSoFar));
        }
    }

    /// <summary>Restores copied pushes. Colliders first pushed since then get their original motions.</summary>
    public void Write(List<(EngineCollider Collider, EnginePush Push)> from)
    {
        for (int i = 0; i < _pushed.Count; i++)
        {
            _pushed[i].ForgetPush();
        }

        _pushed.Clear();
        for (int i = 0; i < from.Count; i++)
        {
            from[i].Collider.PushSoFar = from[i].Push;
            _pushed.Add(from[i].Collider);
        }
    }

    /// <summary>Returns one of the pushed colliders.</summary>
    /// <param name="index">Its index among them, from 0.</param>
    /// <param name="time">Start time of a step, s.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="box">A box around all its positions in that step, with and without the push.</param>
    /// <returns>False after the last one.</returns>
    public bool Has(int index, double time, double dt, out Bounds3d box)
    {
        box = default;
        if (index >= _pushed.Count)
        {
            return false;
        }

        EngineCollider collider = _pushed[index];
        Bounds3d at = collider.Placement.BoundsDuring(time, dt);
        box = at.Union(at.Translated(dt * collider.Placement.Motion.Velocity)).Expanded(2.0 * dt * collider.PushSoFar.Pushed.Length);
        return true;
    }

    /// <summary>Undoes all pushes.</summary>
    public void Forget()
    {
        for (int i = 0; i < _pushed.Count; i++)
        {
            _pushed[i].ForgetPush();
        }

        _pushed.Clear();
    }

    private bool IsKept(EngineCollider collider)
    {
        // A push stored during a look-ahead belongs to the real step, which continues after the look-ahead.
        for (int i = 0; _held is not null && i < _held.Count; i++)
        {
            if (_held[i].Collider == collider)
            {
                return true;
            }
        }

        return false;
    }
}
