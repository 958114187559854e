namespace FootballPhysics.Native;

/// <summary>The forces of one contact on a ball.</summary>
internal unsafe struct NativeContactForce
{
    /// <summary>The index of the object in the scene. fp_name writes its name.</summary>
    public int Thing;

    /// <summary>0.</summary>
    public int Reserved;

    /// <summary>The contact point, m.</summary>
    public fixed double Point[3];

    /// <summary>The unit normal of the surface, towards the ball.</summary>
    public fixed double Normal[3];

    /// <summary>The force along the normal, N.</summary>
    public fixed double Load[3];

    /// <summary>The force along the surface, N.</summary>
    public fixed double Friction[3];
}
