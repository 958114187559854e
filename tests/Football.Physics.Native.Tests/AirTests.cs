using System.Text;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>fp_air_many, called by its address as C calls it.</summary>
public sealed unsafe class AirTests
{
    private const int Count = 50;
    private static readonly delegate* unmanaged<NativeScene*, long, double*, double*, double*, double, double*, double*, double*, double*, NativeStatus> s_air = &Exports.AirMany;
    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_free = &Exports.SceneFree;

    [Fact]
    public void It_has_the_bits_of_Aerodynamics()
    {
        NativeScene* scene = Scene();
        double* position = stackalloc double[3 * Count];
        double* velocity = stackalloc double[3 * Count];
        double* spin = stackalloc double[3 * Count];
        double* flown = stackalloc double[Count];
        double* force = stackalloc double[3 * Count];
        double* torque = stackalloc double[3 * Count];
        for (int i = 0; i < 3 * Count; i++)
        {
            position[i] = (i % 17) - 8;
            velocity[i] = 23 - (i * 7 % 46);
            spin[i] = 50 - (i * 11 % 100);
            flown[i / 3] = i;
        }

        double* turned = stackalloc double[4 * Count];
        for (int i = 0; i < 4 * Count; i++)
        {
            turned[i] = 1 + (i % 5);
        }

        Assert.Equal(NativeStatus.Ok, s_air(scene, Count, position, velocity, spin, 1.5, flown, turned, force, torque));
        var air = new Aerodynamics(new Scene { Air = new Air { Wind = new Vector3d(2, 0, 1) }, Ball = BallProperties.Jabulani, Forces = new ForceSet { KnuckleSeed = 4 } });
        for (int i = 0; i < Count; i++)
        {
            Assert.Equal(air.Evaluate(At(position, i), At(velocity, i), At(spin, i), 1.5, flown[i], new Quaterniond(turned[4 * i], turned[(4 * i) + 1], turned[(4 * i) + 2], turned[(4 * i) + 3])), new ForceAndTorque(At(force, i), At(torque, i)));
        }

        // Without distances and torques; and none at all.
        Assert.Equal(NativeStatus.Ok, s_air(scene, 1, position, velocity, spin, 1.5, null, null, force, null));
        Assert.Equal(air.Evaluate(At(position, 0), At(velocity, 0), At(spin, 0), 1.5).Force, At(force, 0));
        Assert.Equal(NativeStatus.Ok, s_air(scene, 0, null, null, null, 0, null, null, null, null));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Fact]
    public void What_is_out_of_range_is_rejected_and_nothing_is_written()
    {
        NativeScene* scene = Scene();
        double* fine = stackalloc double[6] { 0, 1, 0, 0, 1, 0 };
        double* odd = stackalloc double[6] { 0, 1, 0, 0, double.NaN, 0 };
        double* force = stackalloc double[6] { 7, 7, 7, 7, 7, 7 };
        Assert.Equal(NativeStatus.Argument, s_air(scene, 2, fine, odd, fine, 0, null, null, force, null));
        Assert.StartsWith("velocity is ", Error());
        Assert.Equal(7, force[0]);
        Assert.Equal(NativeStatus.Argument, s_air(scene, 2, fine, fine, fine, -1, null, null, force, null));
        Assert.StartsWith("time is -1; allowed: ", Error());
        Assert.Equal(NativeStatus.Argument, s_air(scene, 2, fine, fine, fine, 0, null, null, null, null));
        Assert.Equal("force is null; allowed: a pointer.", Error());
        Assert.Equal(NativeStatus.Argument, s_air(scene, -1, fine, fine, fine, 0, null, null, force, null));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
        Assert.Equal(NativeStatus.Handle, s_air(scene, 2, fine, fine, fine, 0, null, null, force, null));
    }

    private static Vector3d At(double* rows, int i) => new(rows[3 * i], rows[(3 * i) + 1], rows[(3 * i) + 2]);

    private static NativeScene* Scene() => SceneCalls.Scene("""{"ball": {"type": "jabulani"}, "air": {"wind": [2, 0, 1]}, "forces": {"knuckleSeed": 4}}""");
}
