using System.Runtime.CompilerServices;

// Programs compiled against the netstandard2.1 assembly reference this type here in every init accessor. Newer targets have it in the runtime: the
// forward makes these references resolve.
[assembly: TypeForwardedTo(typeof(IsExternalInit))]
