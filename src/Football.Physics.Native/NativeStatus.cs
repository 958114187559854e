namespace FootballPhysics.Native;

/// <summary>The outcome of a call.</summary>
internal enum NativeStatus
{
    /// <summary>Done.</summary>
    Ok = 0,

    /// <summary>An argument is null or out of range, or a state is none that the library made; nothing has changed.</summary>
    Argument = 1,

    /// <summary>The text of a scene or of a request is refused: no JSON, an unknown member, a number out of range.</summary>
    Scene = 2,

    /// <summary>The caller's buffer is too short: it holds as much as it has room for, and the call says how much there is.</summary>
    Buffer = 3,

    /// <summary>The handle is none of a scene: it is null, was freed, or never was one.</summary>
    Handle = 4,

    /// <summary>Header and library do not belong together.</summary>
    Abi = 5,

    /// <summary>A fault of the library, or no memory left; what the call was to write is not to be used.</summary>
    Internal = 6,

    /// <summary>The caller cancelled the call by its watch; nothing was written.</summary>
    Cancelled = 7,
}
