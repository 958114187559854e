#if !NET9_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Of several overloads that would do, that of the highest priority is meant.</summary>
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Constructor | AttributeTargets.Property, Inherited = false)]
internal sealed class OverloadResolutionPriorityAttribute(int priority) : Attribute
{
    /// <summary>The priority; 0 where there is no attribute.</summary>
    public int Priority { get; } = priority;
}
#endif
