namespace FootballPhysics;

/// <summary>How an engine's collider is, and what has pushed it.</summary>
internal readonly struct EnginePush
{
    public RigidMotion Motion { get; init; }

    public Vector3d Pushed { get; init; }

    public Vector3d Gone { get; init; }

    public double At { get; init; }

    public bool IsAsPlaced { get; init; }
}
