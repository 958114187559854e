using FsCheck.Fluent;
using FsCheck;

namespace FootballPhysics.Tests.Game;

/// <summary>Random matches: kicks, scenes and frame times.</summary>
internal static class Inputs
{
    public const double TimeStep = 1.0 / 60.0;

    private static readonly Simulator[] s_simulators =
    [
        new(),
        new(Scene.Published with { Air = new Air { Wind = new Vector3d(4, 0, -7) } }),
        new(Scene.Published with { Forces = ForceSet.Regularized, Ground = Ground.Presets["publishedWetTurf"] }),
        new(Scene.Published with { Forces = ForceSet.Constant }, new SolverSettings { Integrator = Integrator.Rk2 }),
        new(Scene.Vacuum, new SolverSettings { Integrator = Integrator.SemiImplicitEuler, CollisionTiming = CollisionTiming.Bisection }),
        new(Scene.Measured with
        {
            Ball = BallProperties.Jabulani,
            Air = new Air { WindField = new WindByHeight(6, 1, -2, gusts: new Gusts { Seed = 11 }) },
            Forces = ForceSet.Measured with { KnuckleSeed = -5 },
        }),
        new(Scene.Published with { Forces = ForceSet.Published with { CustomForces = [IForce.From(ball => new Vector3d(0.1 * ball.Velocity.Y, 0, 0.2))] } }),
    ];

    public static Gen<Simulator> Simulators => Gen.Elements(s_simulators);

    /// <summary>A number with few or many digits, so that all forms of the bytes occur.</summary>
    public static Gen<double> Number(double size) => Gen.OneOf(
        Gen.Constant(0.0),
        Gen.Choose(-1000, 1000).Select(i => (double)(float)(i * size / 1000)),
        Gen.Choose(-1_000_000, 1_000_000).Select(i => i * size / 1_000_000));

    public static Gen<Vector3d> Vector(double size) =>
        from x in Number(size)
        from y in Number(size)
        from z in Number(size)
        select new Vector3d(x, y, z);

    public static Gen<KickInput> Kick(int ticks) =>
        from tick in Gen.Choose(0, ticks - 1)
        from player in Gen.Choose(0, 3)
        from velocity in Vector(18)
        from spin in Vector(60)
        select new KickInput(tick, velocity, spin, player);

    public static Gen<KickInput[]> Kicks(int ticks) => Gen.Choose(0, 8).SelectMany(n => Kick(ticks).ArrayOf(n));

    public static FixedStepRunner Runner(Simulator simulator, IEnumerable<KickInput> kicks)
    {
        var runner = new FixedStepRunner(simulator, TimeStep);
        foreach (KickInput kick in kicks)
        {
            runner.Kicks.Add(kick);
        }

        return runner;
    }

    /// <summary>The states at every tick of an undisturbed run.</summary>
    public static BallState[] Play(FixedStepRunner runner, int ticks)
    {
        var states = new BallState[ticks + 1];
        states[0] = runner.State;
        for (int i = 1; i <= ticks; i++)
        {
            runner.Step();
            states[i] = runner.State;
        }

        return states;
    }
}
