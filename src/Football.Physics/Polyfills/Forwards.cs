using System.Runtime.CompilerServices;

// Programs compiled against the netstandard2.1 assembly name this type in every init accessor and look for it here; on newer
// targets it is the runtime's own. Without the forward their calls would find no such method.
[assembly: TypeForwardedTo(typeof(IsExternalInit))]
