using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Batch;

/// <summary>Which laws fly in lanes, and how one more is brought in.</summary>
public sealed class LaneFlightTests
{
    private const int Balls = 200;
    private const double Duration = 1.5;

    /// <summary>A law is one type in one file, which nothing else knows.</summary>
    [Fact]
    public void A_law_of_a_file_of_its_own_flies_as_its_equations_say()
    {
        Scene scene = Scene.Published;
        LaneGroup one = Launch(out Vector3d[] velocities, out Vector3d[] spins);
        LaneGroup eight = Launch(out _, out _);
        new LaneKernel<Lanes1, InventedLaneLaw<Lanes1>, LaneRk4>(scene, 0.01, upAlongX: false, findsApex: false).Fly(one, Duration);
        new LaneKernel<Lanes8, InventedLaneLaw<Lanes8>, LaneRk4>(scene, 0.01, upAlongX: false, findsApex: false).Fly(eight, Duration);
        for (int i = 0; i < Balls; i++)
        {
            Vector3d place = Vector3d.Zero;
            Vector3d u = velocities[i];
            Vector3d w = spins[i];
            for (int step = 0; step < 300; step++)
            {
                Step(scene, ref place, ref u, ref w, Duration / 300);
            }

            Assert.True(Vector3d.Distance(place, one.EndPath[i]) < 1e-5, $"{u} {w}: {Vector3d.Distance(place, one.EndPath[i]):e2} m");
            Assert.True(Vector3d.Distance(u, one.EndVelocity[i]) < 1e-5);
            Assert.Equal(w.Length, one.EndSpin[i], 1e-4);
            Assert.Equal(BatchScenes.Bits(one.EndPath[i]), BatchScenes.Bits(eight.EndPath[i]));
        }
    }

    [Fact]
    public void A_law_that_there_is_not_is_refused()
    {
        ForceSet[] unknown =
        [
            new() { Drag = (ForceLaw)3 },
            new() { Magnus = (ForceLaw)7 },
            new() { SpinDecay = (ForceLaw)(-1) },
            new() { Drag = (ForceLaw)7, Magnus = (ForceLaw)7, SpinDecay = (ForceLaw)7 },
        ];
        foreach (ForceSet forces in unknown)
        {
            var scene = Scene.Published with { Forces = forces };
            Assert.Throws<ArgumentOutOfRangeException>(() => LaneFlight.Covers(scene));
            Assert.Throws<ArgumentOutOfRangeException>(() => Create(scene));
            Assert.Throws<ArgumentOutOfRangeException>(() => new LaneDomain(scene, 0.01));
            Assert.Throws<ArgumentOutOfRangeException>(() => new BallBatch(scene));
            Assert.Throws<ArgumentOutOfRangeException>(() => new BatchAimer(scene));
        }
    }

    [Fact]
    public void A_form_of_the_drag_coefficient_that_there_is_not_is_refused()
    {
        foreach (int form in (int[])[-1, 3, 7])
        {
            var scene = Scene.Published with { Forces = ForceSet.Published with { Coefficients = (AerodynamicModel)form } };
            string message = Assert.Throws<ArgumentOutOfRangeException>(() => Create(scene)).Message;
            Assert.Contains($"forces.coefficients is {form}", message, StringComparison.Ordinal);
            Assert.Throws<ArgumentOutOfRangeException>(() => new BallBatch(scene));
            Assert.Throws<ArgumentOutOfRangeException>(() => new BatchAimer(scene));
        }
    }

    [Fact]
    public void Air_by_place_and_time_and_things_to_hit_are_left_to_the_single_ball()
    {
        Assert.True(LaneFlight.Covers(Scene.Measured));
        Assert.False(LaneFlight.Covers(Scene.Measured with { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(0.1, 1, 0) } }));
        Assert.False(LaneFlight.Covers(Scene.Measured with { Obstacles = [new Obstacle { Shape = new SphereShape(Vector3d.Zero, 0.5) }] }));
        Assert.False(LaneFlight.Covers(Scene.Published with { Air = new Air { WindField = new WindByHeight(5, 1, 0) } }));
        Assert.False(LaneFlight.Covers(Scene.Published with { Forces = ForceSet.Published with { KnuckleSeed = 1 } }));
    }

    [Fact]
    public void Laws_of_two_kinds_are_left_to_the_single_ball()
    {
        var scene = Scene.Published with { Forces = ForceSet.Published with { Drag = ForceLaw.Constant, Magnus = ForceLaw.None } };
        Assert.False(LaneFlight.Covers(scene));
        Assert.Throws<ArgumentOutOfRangeException>(() => Create(scene));
        Assert.True(LaneFlight.Covers(Scene.Published with { Forces = ForceSet.Published with { Drag = ForceLaw.None } }));
    }

    private static LaneFlight Create(Scene scene) => LaneFlight.Create(scene, fourthOrder: true, 0.01, 8);

    private static LaneGroup Launch(out Vector3d[] velocities, out Vector3d[] spins)
    {
        var random = new Shots(21);
        var group = new LaneGroup();
        group.Clear();
        velocities = new Vector3d[Balls];
        spins = new Vector3d[Balls];
        for (int i = 0; i < Balls; i++)
        {
            velocities[i] = random.Velocity(8, 35, 5, 40);
            Vector3d axis = random.Direction();
            spins[i] = random.Uniform(1, 60) * axis;
            group.Add(i, in velocities[i], in axis, spins[i].Length, double.NegativeInfinity, 0);
        }

        return group;
    }

    /// <summary>Classical Runge–Kutta.</summary>
    private static void Step(Scene scene, ref Vector3d place, ref Vector3d u, ref Vector3d w, double h)
    {
        MotionRates k1 = InventedLaneLaw<Lanes1>.Rates(scene, u, w);
        MotionRates k2 = InventedLaneLaw<Lanes1>.Rates(scene, u + (0.5 * h * k1.Acceleration), w + (0.5 * h * k1.SpinAcceleration));
        MotionRates k3 = InventedLaneLaw<Lanes1>.Rates(scene, u + (0.5 * h * k2.Acceleration), w + (0.5 * h * k2.SpinAcceleration));
        MotionRates k4 = InventedLaneLaw<Lanes1>.Rates(scene, u + (h * k3.Acceleration), w + (h * k3.SpinAcceleration));
        place += (h * u) + (h * h / 6 * (k1.Acceleration + k2.Acceleration + k3.Acceleration));
        u += h / 6 * (k1.Acceleration + (2 * k2.Acceleration) + (2 * k3.Acceleration) + k4.Acceleration);
        w += h / 6 * (k1.SpinAcceleration + (2 * k2.SpinAcceleration) + (2 * k3.SpinAcceleration) + k4.SpinAcceleration);
    }
}
