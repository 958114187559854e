using FootballPhysics.Aiming;
using FootballPhysics.Labs.Stability;
using FsCheck.Fluent;
using FsCheck;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>A few thousand scenes of the stress matrix, and a search over its numbers that shrinks.</summary>
public sealed class StressTests
{
    private const long Seed = 2024;
    private const int Rounds = 40;

    public static TheoryData<string, Integrator> Cells() =>
        new(StressGenerator.Kinds.SelectMany(kind => StressGenerator.Integrators.Select(method => (kind.ToString(), method))));

    [Theory]
    [MemberData(nameof(Cells))]
    public void Every_invariant_holds(string kindName, Integrator method)
    {
        StressKind kind = Enum.Parse<StressKind>(kindName);
        for (int round = 0; round < Rounds; round++)
        {
            long index = StressGenerator.Index(kind, method, round);
            StressScene scene = StressGenerator.Make(Seed, index);
            Assert.Equal((kind, method), (scene.Kind, scene.Integrator));
            StressOutcome outcome = StressRun.Play(scene);
            Assert.True(outcome.Failure is null, $"scene {index} of seed {Seed}: {outcome.Failure}\n{scene.Text()}");
        }
    }

    [Fact]
    public void A_scene_is_the_same_whenever_it_is_made()
    {
        Assert.Equal(StressGenerator.Make(3, 17).Text(), StressGenerator.Make(3, 17).Text());
        Assert.NotEqual(StressGenerator.Make(3, 17).Text(), StressGenerator.Make(4, 17).Text());
    }

    /// <summary>What a search finds shrinks towards the plainest scene: nearer to the defaults, shorter, slower.</summary>
    [Theory]
    [ProfileData]
    public void A_kick_keeps_every_invariant_whatever_its_numbers(Profile profile)
    {
        Gen<Kick> kicks =
            from method in Gen.Elements(Enum.GetValues<Integrator>())
            from ball in Gen.Elements(BallProperties.Tunnel, BallProperties.BeachBall, BallProperties.MedicineBall)
            from step in Gen.Elements(1e-4, 1e-3, 0.01, 0.02, 0.04, 0.1, 0.3, 1)
            from height in Gen.Choose(-20, 300)
            from vx in Gen.Choose(-100, 100)
            from vy in Gen.Choose(-100, 100)
            from spinUp in Gen.Choose(-500, 500)
            from spinSide in Gen.Choose(-500, 500)
            from restitution in Gen.Choose(0, 100)
            from friction in Gen.Choose(0, 20)
            select new Kick(method, ball, step, height, vx, vy, spinUp, spinSide, restitution, friction);
        Prop.ForAll(Arb.From(kicks, Shrink), kick =>
        {
            StressOutcome outcome = StressRun.Play(kick.Scene(profile));
            Assert.True(outcome.Failure is null, $"{outcome.Failure} in {kick}");
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(500).WithReplay(7, 13));
    }

    private static IEnumerable<Kick> Shrink(Kick kick)
    {
        static IEnumerable<int> Towards(int value, int goal)
        {
            for (int gap = value - goal; gap != 0; gap /= 2)
            {
                yield return value - gap;
            }
        }

        return
        [
            .. Towards(kick.Height, 0).Select(value => kick with { Height = value }),
            .. Towards(kick.Vx, 0).Select(value => kick with { Vx = value }),
            .. Towards(kick.Vy, 0).Select(value => kick with { Vy = value }),
            .. Towards(kick.SpinUp, 0).Select(value => kick with { SpinUp = value }),
            .. Towards(kick.SpinSide, 0).Select(value => kick with { SpinSide = value }),
            .. Towards(kick.Restitution, 60).Select(value => kick with { Restitution = value }),
            .. Towards(kick.Friction, 5).Select(value => kick with { Friction = value }),
        ];
    }

    /// <summary>A kick in whole numbers: centimetres, metres and radians a second, percents, tenths.</summary>
    private sealed record Kick(
        Integrator Method, BallProperties Ball, double Step, int Height, int Vx, int Vy, int SpinUp, int SpinSide, int Restitution, int Friction)
    {
        public StressScene Scene(Profile profile) => new()
        {
            Kind = StressKind.AnyShot,
            Integrator = Method,
            Scene = profile.Scene() with
            {
                Ball = Ball,
                Ground = profile.Ground() with
                {
                    Material = profile.Ground().Material with
                    {
                        NormalRestitution = 0.01 * Restitution,
                        SlidingFriction = 0.1 * Friction,
                        RollingResistance = 0.01 * Friction,
                    }
                },
            },
            Settings = new SolverSettings { Integrator = Method },
            Position = new Vector3d(0, Ball.Radius + (0.01 * Height), 0),
            Velocity = new Vector3d(Vx, Vy, 0),
            Spin = new Vector3d(0, SpinUp, SpinSide),
            Frames = [.. Enumerable.Repeat(Step, 60)],
        };
    }
}
