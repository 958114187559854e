namespace Football.Physics.Tests.Api;

/// <summary>A profile changes which code is compiled, and nothing else.</summary>
public sealed class AirProfileTests
{
    public static TheoryData<string> Profiles() => new("Published", "Regularised", "Measured", "Constant", "Vacuum");

    [Theory]
    [MemberData(nameof(Profiles))]
    public void A_profile_gives_the_same_bits(string name)
    {
        (AirProfile profile, ForceSet forces) = Of(name);
        Assert.Equal(name, profile.Name);
        IForce push = Force.From(ball => new Vector3d(0.2, 0, 0));
        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            foreach (Scene scene in (Scene[])[
                new() { Forces = forces },
                new() { Forces = forces with { Custom = [push] } },
                new() { Forces = forces, Air = new Air { WindField = new Gusts() } },
            ])
            {
                var settings = new SolverSettings { Integrator = integrator };
                Assert.Equal(Snapshot.Hash(Fly(new Simulator(scene, settings))), Snapshot.Hash(Fly(new Simulator(scene, settings, profile))));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Profiles))]
    public void A_profile_refuses_other_laws(string name)
    {
        (AirProfile profile, ForceSet forces) = Of(name);
        Assert.True(profile.Covers(new Scene { Forces = forces }));
        var other = new Scene { Forces = forces with { Drag = name == "Constant" ? ForceLaw.None : ForceLaw.Constant } };
        Assert.False(profile.Covers(other));
        string message = Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(other, null, profile)).Message;
        Assert.Contains($"AirProfile.{name}", message, StringComparison.Ordinal);
        Assert.True(AirProfile.All.Covers(other));
    }

    [Fact]
    public void An_aimer_of_a_profile_finds_the_same_kicks()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(2, 1.5, -20), SideSpin = 20 };
        AimResult all = new Aimer(new Simulator()).Find(request);
        AimResult one = new Aimer(new Simulator(null, null, AirProfile.Measured)).Find(request);
        Assert.Equal(all.Velocity, one.Velocity);
    }

    private static (AirProfile Profile, ForceSet Forces) Of(string name) => name switch
    {
        "Published" => (AirProfile.Published, ForceSet.Published),
        "Regularised" => (AirProfile.Regularised, ForceSet.Regularised),
        "Measured" => (AirProfile.Measured, ForceSet.Measured),
        "Constant" => (AirProfile.Constant, ForceSet.Constant),
        _ => (AirProfile.Vacuum, ForceSet.None),
    };

    private static BallState Fly(Simulator simulator)
    {
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(4, 6, -20), new Vector3d(5, 20, 3));
        simulator.Run(ref state, 0.01, 4, StopAt.Rest, new StepLog());
        return state;
    }

    private sealed class Gusts : IWind
    {
        public double Fastest => 4;

        public Vector3d At(double time, in Vector3d position) => new(2 + position.Y, 0, 0);
    }
}
