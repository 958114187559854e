using System.Reflection;
using FootballPhysics.Integration;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Architecture;

/// <summary>All phases of a step read alike.</summary>
public sealed class PhaseTests
{
    [Theory]
    [InlineData(typeof(FlightPhase<ClassicalRungeKutta>))]
    [InlineData(typeof(SurfacePhase<ClassicalRungeKutta>))]
    [InlineData(typeof(ContactSetPhase<ClassicalRungeKutta>))]
    public void A_phase_has_five_methods_in_this_order(Type phase)
    {
        string[] five = ["Propose", "Integrate", "Shorten", "Move", "Respond"];
        IEnumerable<MethodInfo> methods = phase.GetMethods(BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly);
        Assert.Equal(five, methods.OrderBy(method => method.MetadataToken).Select(method => method.Name).Where(five.Contains).Distinct());
    }
}
