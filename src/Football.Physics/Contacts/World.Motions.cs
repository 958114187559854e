using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <content>The motions of the objects that a ball can push, read and restored together.</content>
internal sealed partial class World
{
    private MotionSnapshot? _kept;

    /// <summary>Number of stored motions: bodies, then obstacles with a mass.</summary>
    public int Movers => (Bodies?.Count ?? 0) + Obstacles.Count;

    /// <summary>Reads the motions of all movable objects.</summary>
    public void ReadMotions(Span<RigidMotion> into)
    {
        int bodies = Bodies?.Count ?? 0;
        for (int i = 0; i < bodies; i++)
        {
            into[i] = Bodies![i].Motion;
        }

        Obstacles.Read(into.Slice(bodies));
    }

    /// <summary>Returns the name of a movable object.</summary>
    public string NameOfMover(int mover)
    {
        int bodies = Bodies?.Count ?? 0;
        return mover < bodies ? Bodies![mover].Name : Obstacles.NameOf(mover - bodies);
    }

    /// <summary>Saves all motions before a look-ahead.</summary>
    public void KeepMotions()
    {
        _kept ??= new MotionSnapshot(this, Movers);
        _kept.Save();
        Bodies?.BeginLook();
        Engine?.Pushes.Hold(_kept.Pushes);
    }

    /// <summary>Restores the saved motions.</summary>
    public void PutMotionsBack()
    {
        _kept!.PutBack();
        Bodies?.EndLook();
        Engine?.Pushes.Hold(null);
    }

    /// <summary>Returns a box around a movable object, valid for a duration if the box moves at the object's velocity.</summary>
    public Bounds3d BoundsOfMover(int mover, double time, double duration)
    {
        int bodies = Bodies?.Count ?? 0;
        return mover < bodies ? Bodies![mover].BoundsDuring(time, duration) : Obstacles.BoundsAt(mover - bodies, time);
    }

    /// <summary>Sets the motions of all movable objects.</summary>
    public void WriteMotions(Span<RigidMotion> from)
    {
        int bodies = Bodies?.Count ?? 0;
        for (int i = 0; i < bodies; i++)
        {
            Bodies![i].Motion = from[i];
        }

        if (Obstacles.Count > 0)
        {
            Obstacles.Write(from.Slice(bodies));
        }
    }
}
