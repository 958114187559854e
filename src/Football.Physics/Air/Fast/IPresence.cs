namespace Football.Physics;

/// <summary>Whether a law of the fused kernel is there: a fact of the type, so that an absent law leaves no code.</summary>
internal interface IPresence
{
    /// <summary>True for <see cref="Present"/>.</summary>
    bool Is { get; }
}

/// <summary>The law acts.</summary>
internal readonly struct Present : IPresence
{
    public bool Is
    {
        [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.AggressiveInlining)]
        get => true;
    }
}

/// <summary>The law is left out.</summary>
internal readonly struct Absent : IPresence
{
    public bool Is
    {
        [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.AggressiveInlining)]
        get => false;
    }
}
