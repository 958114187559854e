using FootballPhysics.Game;
using FsCheck.Fluent;
using FsCheck;

namespace FootballPhysics.Tests.Game;

public sealed class SlerpTests
{
    [Fact]
    public void It_turns_by_that_fraction_of_the_angle()
    {
        var cases =
            from axis in Inputs.Vector(1)
            where axis.Length > 0.01
            from angle in Inputs.Number(0.999 * Math.PI) // at half a turn either way is the shorter one
            from fraction in Gen.Choose(0, 1000).Select(i => i / 1000.0)
            from start in Inputs.Vector(3)
            from flip in Gen.Elements(1.0, -1.0)
            select (axis: axis / axis.Length, angle, fraction, start, flip);
        Prop.ForAll(cases.ToArbitrary(), c =>
        {
            Quaterniond from = Quaterniond.FromRotationVector(c.start);
            Quaterniond to = Quaterniond.FromAxisAngle(c.axis, c.angle) * from;
            Quaterniond expected = Quaterniond.FromAxisAngle(c.axis, c.fraction * c.angle) * from;
            Quaterniond actual = Slerp.Between(from, new Quaterniond(c.flip * to.X, c.flip * to.Y, c.flip * to.Z, c.flip * to.W), c.fraction);
            Assert.Equal(1, actual.LengthSquared, 4e-15);
            FixedStepRunnerTests.AssertSameRotation(expected, actual, 1e-12);
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Half_a_turn_is_no_singularity()
    {
        Quaterniond middle = Slerp.Between(Quaterniond.Identity, new Quaterniond(0, 1, 0, 0), 0.5);
        FixedStepRunnerTests.AssertSameRotation(Quaterniond.FromAxisAngle(Vector3d.Up, Math.PI / 2), middle, 1e-12);
    }
}
