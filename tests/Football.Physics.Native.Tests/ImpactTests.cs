using System.Text;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>The outputs of impacts in C, against the library itself.</summary>
public sealed unsafe class ImpactTests
{
    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_free = &Exports.SceneFree;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, NativeState*, NativeStatus> s_launch = &Exports.Launch;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, NativeEvent*, int, int*, NativeStatus> s_step = &Exports.Step;
    private static readonly delegate* unmanaged<NativeScene*, NativeEvent*, NativeImpactResult*, NativeStatus> s_impact = &Exports.Impact;

    [Fact]
    public void An_event_of_a_stationary_surface_has_the_outputs_of_the_library()
    {
        NativeScene* scene = Scene("{}");
        double* position = stackalloc double[3] { 0, 0.5, 0 };
        double* velocity = stackalloc double[3] { 14, -6, 2 };
        double* spin = stackalloc double[3] { 10, 30, -20 };
        NativeState ball;
        Assert.Equal(NativeStatus.Ok, s_launch(scene, position, velocity, spin, &ball));
        NativeEvent* events = stackalloc NativeEvent[8];
        int count;
        Assert.Equal(NativeStatus.Ok, s_step(scene, &ball, 0.2, events, 8, &count));

        var simulator = new Simulator();
        BallState same = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(14, -6, 2), new Vector3d(10, 30, -20));
        var log = new StepLog();
        simulator.Step(ref same, 0.2, log);
        Impact expected = simulator.ImpactOf(in log.Events[0]);
        NativeImpactResult impact;
        Assert.Equal(NativeStatus.Ok, s_impact(scene, events, &impact));
        Assert.Equal(
            (expected.NormalImpulse, expected.TangentialImpulse, expected.SlipBefore, expected.SlipAfter, expected.Grips ? 1 : 0),
            (impact.NormalImpulse, impact.TangentialImpulse, impact.SlipBefore, impact.SlipAfter, impact.Grips));
        Assert.Equal(
            (expected.ContactTime, expected.Compression, expected.PeakForce, expected.EnergyLost), (impact.ContactTime, impact.Compression, impact.PeakForce, impact.EnergyLost));

        // Not an impact, and an object that is not in the scene.
        events[0].Kind = (int)BallEventKind.Roll;
        Assert.Equal(NativeStatus.Argument, s_impact(scene, events, &impact));
        Assert.StartsWith("event.kind is ", Error());
        events[0].Kind = (int)BallEventKind.Impact;
        events[0].Thing = 99;
        Assert.Equal(NativeStatus.Argument, s_impact(scene, events, &impact));
        Assert.StartsWith("event.thing is 99", Error());
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }
}
