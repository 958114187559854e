using System.Reflection;
using Xunit.Sdk;
using Xunit.v3;

namespace FootballPhysics.Tests.Support;

/// <summary>A row of a theory for each profile, which is the first argument; the others are those given here, or the rows of a member.</summary>
[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ProfileDataAttribute(params object[] row) : DataAttribute
{
    /// <summary>The static method or property of the test class that has the rows.</summary>
    public string? Member { get; init; }

    public override ValueTask<IReadOnlyCollection<ITheoryDataRow>> GetData(MethodInfo testMethod, DisposalTracker disposalTracker)
    {
        IEnumerable<object?[]> rows = Member is null ? [row] : Rows(testMethod.DeclaringType!);
        return new([.. rows.SelectMany(arguments => Profiles.All, (arguments, profile) => new TheoryDataRow([profile, .. arguments]))]);
    }

    public override bool SupportsDiscoveryEnumeration() => true;

    private IEnumerable<object?[]> Rows(Type type)
    {
        const BindingFlags Any = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;
        object? rows = type.GetProperty(Member!, Any)?.GetValue(null) ?? type.GetMethod(Member!, Any)?.Invoke(null, null);
        return ((IEnumerable<ITheoryDataRow>)rows!).Select(item => item.GetData());
    }
}
