using System.Text;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>The forces on a ball in C, against the library itself.</summary>
public sealed unsafe class ForcesTests
{
    private const string Json = """
        {"gravity": [2, -9.6, 0], "obstacles": [{"name": "board", "shape": "box", "center": [1, 0.5, 0], "halfSize": [0.1, 0.5, 40]}], "nets": [{"center": [0, 2, -12], "normal": [0, 0, 1], "along": [1, 0, 0], "halfSize": [4, 2]}]}
        """;

    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_free = &Exports.SceneFree;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, NativeState*, NativeStatus> s_launch = &Exports.Launch;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, NativeEvent*, int, int*, NativeStatus> s_step = &Exports.Step;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, NativeForcesResult*, NativeContactForce*, int, int*, NativeStatus> s_forces = &Exports.Forces;

    /// <summary>A kick into the net, a roll along the board, a slide to the board, and a ball that falls onto the ground.</summary>
    [Theory]
    [InlineData(0, 1, 0, 2, 6, -24, 20, 40, 5)]
    [InlineData(0.79, 0.11, 0, 0, 0, -9, -80, 0, 0)]
    [InlineData(-1, 0.11, 5, 0, 0, 6, 0, 0, 0)]
    [InlineData(-1, 0.3, 8, 0, -1, 0, 0, 0, 0)]
    public void Every_force_of_a_run_is_that_of_the_library(double x, double y, double z, double vx, double vy, double vz, double wx, double wy, double wz)
    {
        NativeScene* scene = Scene(Json);
        double* numbers = stackalloc double[9] { x, y, z, vx, vy, vz, wx, wy, wz };
        NativeState ball;
        Assert.True(s_launch(scene, numbers, numbers + 3, numbers + 6, &ball) == NativeStatus.Ok, Error());
        Simulator simulator = Requests.Scene(Encoding.UTF8.GetBytes(Json)).Simulator;
        BallState same = simulator.Launch(new Vector3d(x, y, z), new Vector3d(vx, vy, vz), new Vector3d(wx, wy, wz));
        const double Dt = 1.0 / 60;
        NativeContactForce* contacts = stackalloc NativeContactForce[8];
        var log = new StepLog();
        int determined = 0;
        for (int i = 0; i < 240; i++)
        {
            NativeForcesResult forces;
            int count;
            Assert.True(s_forces(scene, &ball, Dt, &forces, contacts, 8, &count) == NativeStatus.Ok, Error());
            BallForces? expected = simulator.ForcesAt(in same, Dt);
            Assert.Equal(expected is null ? 0 : 1, forces.Determined);
            determined += forces.Determined;
            Vector3d[] vectors = expected is null
                ? new Vector3d[11]
                : [
                    expected.Weight, expected.Buoyancy, expected.Drag, expected.Magnus, expected.Knuckle, expected.Custom, expected.Nets, expected.Load, expected.Friction,
                    expected.Sum, expected.Acceleration,
                ];
            for (int v = 0; v < vectors.Length; v++)
            {
                double* at = forces.Weight + (3 * v);
                Assert.Equal(vectors[v], new Vector3d(at[0], at[1], at[2]));
            }

            Assert.Equal(expected?.Contacts.Count ?? 0, count);
            for (int c = 0; c < count; c++)
            {
                ContactForce contact = expected!.Contacts[c];
                Assert.Equal(contact.ColliderIndex, contacts[c].Thing);
                double* at = contacts[c].Point;
                Vector3d[] of = [contact.Point, contact.Normal, contact.Load, contact.Friction];
                for (int v = 0; v < of.Length; v++, at += 3)
                {
                    Assert.Equal(of[v], new Vector3d(at[0], at[1], at[2]));
                }
            }

            Assert.Equal(NativeStatus.Ok, s_step(scene, &ball, Dt, null, 0, null));
            simulator.Step(ref same, Dt, log);
        }

        Assert.InRange(determined, 120, 240);
        Assert.Equal(Snapshot.Hash(in same), Snapshot.Hash(in *(BallState*)&ball));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Fact]
    public void A_ball_with_more_contacts_than_capacity_has_the_first_ones_and_their_number()
    {
        NativeScene* scene = Scene("{}");
        double* numbers = stackalloc double[6];
        NativeState ball;
        Assert.Equal(NativeStatus.Ok, s_launch(scene, numbers, numbers + 3, numbers + 3, &ball));
        NativeForcesResult forces;
        int count;
        Assert.Equal(NativeStatus.Buffer, s_forces(scene, &ball, 0.01, &forces, null, 0, &count));
        Assert.Equal("capacity is 0; there are 1 contacts.", Error());
        Assert.Equal((1, 1), (count, forces.Determined));
        Assert.True(forces.Load[1] > 4, "The ground supports the ball.");

        // Neither contacts nor their number are wanted.
        Assert.Equal(NativeStatus.Ok, s_forces(scene, &ball, 0.01, &forces, null, 0, null));
        Assert.Equal(NativeStatus.Argument, s_forces(scene, &ball, 0, &forces, null, 0, null));
        Assert.StartsWith("dt is 0", Error());
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }
}
