namespace FootballPhysics.Scenes;

/// <summary>A snapshot of an engine collider: its motion and the impulses it received.</summary>
internal struct EnginePush
{
    public RigidMotion Motion { get; set; }

    /// <summary>The motion without the pushes.</summary>
    public RigidMotion Placed { get; set; }

    public Vector3d Pushed { get; set; }

    public Vector3d Gone { get; set; }

    public double At { get; set; }

    public bool IsAsPlaced { get; set; }
}
