using FsCheck;
using FsCheck.Fluent;

namespace FootballPhysics.Tests.Game;

public sealed class EngineFrameTests
{
    private static readonly EngineFrame s_unity = EngineFrame.LeftHanded;

    [Fact]
    public void The_library_s_forward_is_the_left_handed_engine_s_forward()
    {
        Assert.Equal(new Vector3d(1, 2, 3), s_unity.Vector(new Vector3d(1, 2, -3)));
        Assert.Equal(new Vector3d(0, 0, 1), s_unity.Vector(new Vector3d(0, 0, -1)));
    }

    [Fact]
    public void There_and_back_loses_no_bit()
    {
        var vectors = from v in Inputs.Vector(30) from w in Inputs.Vector(60) select (v, w);
        Prop.ForAll(vectors.ToArbitrary(), c =>
        {
            foreach (EngineFrame frame in new[] { EngineFrame.LeftHanded, EngineFrame.RightHanded })
            {
                Quaterniond q = Quaterniond.FromRotationVector(c.w);
                Assert.Equal(c.v, frame.Vector(frame.Vector(c.v)));
                Assert.Equal(c.w, frame.Spin(frame.Spin(c.w)));
                Assert.Equal(q, frame.Rotation(frame.Rotation(q)));
            }
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Products_keep_their_meaning_in_the_mirror()
    {
        var vectors = from v in Inputs.Vector(30) from w in Inputs.Vector(60) select (v, w);
        Prop.ForAll(vectors.ToArbitrary(), c =>
        {
            // Magnus force ω × v, and the velocity of a point of a turning body, are polar in either frame.
            Vector3d mirrored = Vector3d.Cross(s_unity.Spin(c.w), s_unity.Vector(c.v));
            Assert.Equal(0, Vector3d.Distance(mirrored, s_unity.Vector(Vector3d.Cross(c.w, c.v))), 1e-9);

            // A rotated point is the same point, rotated, in either frame.
            Quaterniond q = Quaterniond.FromRotationVector(0.1 * c.w);
            Vector3d point = s_unity.Rotation(q).Rotate(s_unity.Vector(c.v));
            Assert.Equal(0, Vector3d.Distance(point, s_unity.Vector(q.Rotate(c.v))), 1e-9);

            // The rotation by a spin's rotation vector is the mirrored one.
            Quaterniond turned = Quaterniond.FromRotationVector(0.1 * s_unity.Spin(c.w));
            FixedStepRunnerTests.AssertSameRotation(s_unity.Rotation(q), turned, 1e-12);
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void A_zero_of_the_engine_is_the_library_s_zero()
    {
        Vector3d v = s_unity.Vector(Vector3d.Zero);
        Vector3d w = s_unity.Spin(Vector3d.Zero);
        Assert.Equal(0, BitConverter.DoubleToInt64Bits(v.Z));
        Assert.Equal(0, BitConverter.DoubleToInt64Bits(w.X) | BitConverter.DoubleToInt64Bits(w.Y));
    }
}
