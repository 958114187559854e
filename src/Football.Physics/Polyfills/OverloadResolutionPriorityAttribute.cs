#if !NET9_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Makes the compiler prefer the applicable overload with the highest priority.</summary>
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Constructor | AttributeTargets.Property, Inherited = false)]
internal sealed class OverloadResolutionPriorityAttribute(int priority) : Attribute
{
    /// <summary>The priority; 0 without the attribute.</summary>
    public int Priority { get; } = priority;
}
#endif
