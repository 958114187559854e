namespace FootballPhysics.Native;

/// <summary>The outcome of a call.</summary>
internal enum NativeStatus
{
    /// <summary>The call succeeded.</summary>
    Ok = 0,

    /// <summary>An argument is null or out of range, or a state was not created by the library; nothing has changed.</summary>
    Argument = 1,

    /// <summary>The text of a scene or of a request is rejected: invalid JSON, an unknown member, or a number out of range.</summary>
    Scene = 2,

    /// <summary>The caller's buffer is too short. It contains the items that fit, and the call returns the total number.</summary>
    Buffer = 3,

    /// <summary>The handle is not valid: it is null, was freed, or was never a handle of this kind.</summary>
    Handle = 4,

    /// <summary>The header does not match the library.</summary>
    Abi = 5,

    /// <summary>The library has a bug, or memory is exhausted; do not use the results of the call.</summary>
    Internal = 6,

    /// <summary>The caller cancelled the call through its watch; nothing was written.</summary>
    Cancelled = 7,
}
