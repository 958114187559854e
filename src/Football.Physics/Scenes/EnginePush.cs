namespace FootballPhysics.Scenes;

/// <summary>A snapshot of an engine collider: its motion and the impulses it received.</summary>
internal readonly struct EnginePush
{
    public RigidMotion Motion { get; init; }

    public Vector3d Pushed { get; init; }

    public Vector3d Gone { get; init; }

    public double At { get; init; }

    public bool IsAsPlaced { get; init; }
}
