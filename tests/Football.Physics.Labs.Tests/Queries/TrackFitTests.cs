using System.Text.Json;
using FootballPhysics.Labs.Queries;
using FootballPhysics.Laws;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>The launch from where a camera saw the ball.</summary>
public sealed class TrackFitTests
{
    /// <summary>football lab fit --tracks 1000 tells of a thousand.</summary>
    [Fact]
    public void Truth_is_within_the_stated_uncertainty()
    {
        var check = new FitCheck();
        for (int i = 0; i < 10; i++)
        {
            check.Run(new SeededRandom(SeededRandom.Mix(5, i)), also: false);
        }

        Assert.InRange(check.Counts["within"], 8, 10);
        Assert.Equal(0, check.Counts["not converged"]);
    }

    [Fact]
    public void So_it_is_with_drag_lift_restitution_and_friction()
    {
        var check = new FitCheck();
        for (int i = 0; i < 4; i++)
        {
            check.Run(new SeededRandom(SeededRandom.Mix(5, i)), also: true);
        }

        Assert.InRange(check.Counts["within"], 3, 4);
        Assert.Equal(0, check.Counts["not converged"]);
    }

    /// <summary>What the track alone says of the spin, and how surely, along its vaguest direction; then something else is known before, just as surely.</summary>
    [Fact]
    public void A_track_and_what_is_known_before_meet_half_way_where_both_are_as_sure()
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(3, 9, -20), new Vector3d(5, 30, 0));
        var track = new TrackPoint[25];
        for (int i = 0; i < track.Length; i++)
        {
            track[i] = new TrackPoint(0.04 * i, ball.Position, 0.01);
            simulator.Run(ref ball, 0.01, 0.04, StopAt.Time, new StepLog());
        }

        var fit = new TrackFit();
        TrackFitResult alone = fit.Find(track, new TrackFitRequest { SpinDeviation = 1e4, Spin = new Vector3d(5, 30, 0) });
        Assert.True(alone.Converged);

        // The vaguest direction, by the power method, and the variance along it.
        var vaguest = new Vector3d(0.3, 0.5, 0.8);
        double variance = 0;
        for (int i = 0; i < 200; i++)
        {
            double Row(int row) => (alone.Covariance(row, 6) * vaguest.X) + (alone.Covariance(row, 7) * vaguest.Y) + (alone.Covariance(row, 8) * vaguest.Z);
            var next = new Vector3d(Row(6), Row(7), Row(8));
            variance = next.Length;
            vaguest = next / variance;
        }

        double deviation = Math.Sqrt(variance);
        Assert.InRange(deviation, 3, 30);
        var known = new TrackFitRequest { SpinDeviation = deviation, Spin = alone.Spin + (0.5 * deviation * vaguest) };
        TrackFitResult both = fit.Find(track, known);
        Assert.Equal(0.25 * deviation, Vector3d.Dot(both.Spin - alone.Spin, in vaguest), 0.02 * deviation);
    }

    [Fact]
    public void What_a_track_does_not_tell_is_not_identified()
    {
        // In the air all the time, without spin: nothing of the ground, nothing of the lift.
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(3, 12, -20), Vector3d.Zero);
        var track = new TrackPoint[30];
        for (int i = 0; i < track.Length; i++)
        {
            track[i] = new TrackPoint(0.04 * i, ball.Position, 0.02);
            simulator.Run(ref ball, 0.01, 0.04, StopAt.Time, new StepLog());
        }

        TrackFitResult found = new TrackFit(Scene.Measured).Find(track, new TrackFitRequest { Drag = true, Lift = true, Restitution = true, Friction = true });
        Assert.True(found.Converged);
        Assert.Equal(["drag", "lift", "restitution", "friction"], found.Names.Skip(9));
        Assert.Equal([true, false, false, false], Enumerable.Range(9, 4).Select(found.IsIdentified));
        Assert.All(Enumerable.Range(0, 6), i => Assert.True(found.IsIdentified(i)));
        Assert.Equal(1, found.Value(11), 1e-6);
        Assert.Equal(0.3, found.StandardError(11), 1e-6);
    }

    [Fact]
    public void A_track_without_noise_gives_the_launch_and_the_scenes_own_numbers()
    {
        Scene scene = Scene.Measured with { Ground = Scene.Measured.Ground with { Material = Scene.Measured.Ground.Material with { NormalRestitution = 0.55 } } };
        var simulator = new Simulator(scene);
        var velocity = new Vector3d(4, 6, -18);
        var spin = new Vector3d(10, 30, -5);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, spin);
        var track = new TrackPoint[60];
        for (int i = 0; i < track.Length; i++)
        {
            track[i] = new TrackPoint(7 + (0.04 * i), ball.Position, 1e-4);
            simulator.Run(ref ball, 0.01, 0.04, StopAt.Time, new StepLog());
        }

        TrackFitResult found = new TrackFit(Scene.Measured).Find(track, new TrackFitRequest { Restitution = true });
        Assert.True(found.Converged);
        Assert.Equal(7, found.Time);
        Assert.InRange(Vector3d.Distance(found.Velocity, velocity), 0, 1e-3);
        Assert.InRange(Vector3d.Distance(found.Spin, spin), 0, 0.05);
        Assert.Equal("restitution", found.Names[9]);
        Assert.Equal(0.55 / Scene.Measured.Ground.Material.NormalRestitution, found.Value(9), 1e-3);
    }

    [Fact]
    public void Scaled_air_is_what_a_scene_of_other_laws_has()
    {
        // Constant laws: twice the coefficient is twice the force.
        Scene scene = Scene.Measured with { Forces = ForceSet.Constant };
        Scene doubled = scene with { Forces = scene.Forces with { DragCoefficient = 2 * scene.Forces.DragCoefficient } };
        Scene scaled = scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, 2, 1)] } };
        Vector3d Land(Scene of)
        {
            var simulator = new Simulator(of);
            BallState ball = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(20, 8, 0), new Vector3d(0, 30, 10));
            simulator.Run(ref ball, 0.005, 1, StopAt.Time, new StepLog());
            return ball.Position;
        }

        Assert.InRange(Vector3d.Distance(Land(doubled), Land(scaled)), 0, 1e-6);
    }

    [Theory]
    [InlineData(AerodynamicModel.Measured)]
    [InlineData(AerodynamicModel.Published)]
    public void Scaled_laws_are_the_scaled_air(AerodynamicModel form)
    {
        Scene scene = Scene.Measured with { Forces = ForceSet.Measured with { Coefficients = form } };
        Scene scaled = scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, 1.15, 0.8)] } };
        Vector3d End(Simulator simulator)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(18, 7, 2), new Vector3d(10, 30, 25));
            simulator.Run(ref ball, 0.005, 2, StopAt.Time, new StepLog());
            return ball.Position;
        }

        Vector3d asLaws = End(new Simulator(scaled));
        Scene asForce = scene with { Forces = scene.Forces with { CustomForces = [.. scaled.Forces.CustomForces, IForce.From(_ => Vector3d.Zero)] } };
        Assert.InRange(Vector3d.Distance(asLaws, End(new Simulator(asForce))), 0, 1e-6);
        Assert.InRange(Vector3d.Distance(asLaws, End(new Simulator(scene))), 0.5, 10);

        // Where more acts, or where it was made for another ball, it is a force among others.
        Assert.False(SceneAir.Of(scaled).Varies);
        Assert.True(SceneAir.Of(asForce).Varies);
        Assert.True(SceneAir.Of(scaled with { Ball = scaled.Ball with { Mass = 0.4 } }).Varies);
    }

    [Fact]
    public void Derivatives_in_scaled_air_are_its_differences()
    {
        Scene scene = Scene.Measured;
        var simulator = new Simulator(scene with { Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, 1.15, 0.8)] } });
        var velocity = new Vector3d(18, 7, 2);
        Vector3d End(Vector3d changed)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), changed, new Vector3d(10, 30, 25));
            simulator.Run(ref ball, 0.01, 2, StopAt.Time, new StepLog());
            return ball.Position;
        }

        var derivatives = new LaunchDerivatives(simulator);
        BallState kicked = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, new Vector3d(10, 30, 25));
        derivatives.Run(ref kicked, 0.01, 2, StopAt.Time);
        var along = new Vector3d(1e-4, 2e-4, -1e-4);
        Vector3d difference = 0.5 * (End(velocity + along) - End(velocity - along));
        Assert.InRange(Vector3d.Distance(derivatives.PositionByVelocity * along, difference), 0, 1e-5 * difference.Length);
    }

    [Fact]
    public void The_command_tells_values_and_deviations()
    {
        const string Track = """{"time": 0, "position": [0, 0.11, 0]}, {"time": 0.2, "position": [0.6, 1.31, -4.2]}, {"time": 0.4, "position": [1.2, 2.12, -8.1]}, {"time": 0.6, "position": [1.8, 2.57, -11.8]}""";
        JsonElement answer = FootballCommand.Run($$"""{"profile": "measured", "track": [{{Track}}]}""", "fit", "-").Result;
        Assert.InRange(answer.GetProperty("values").GetProperty("velocity.z").GetDouble(), -24, -19);
        Assert.InRange(answer.GetProperty("deviations").GetProperty("position.x").GetDouble(), 0.001, 0.03);
        Assert.True(answer.GetProperty("converged").GetBoolean());
        Assert.InRange(answer.GetProperty("probability").GetDouble(), 0, 1);
        Assert.False(string.IsNullOrEmpty(answer.GetProperty("verdict").GetString()));
        Assert.Contains("of 3 expected", answer.GetProperty("explanation").GetString(), StringComparison.Ordinal);
        Assert.Contains("spin.z", answer.GetProperty("unidentified").EnumerateArray().Select(name => name.GetString()));
    }

    [Fact]
    public void Fewer_than_four_points_are_refused() => Assert.Contains(
        "track's points", Assert.Throws<ArgumentOutOfRangeException>(() => new TrackFit().Find(new TrackPoint[3])).Message, StringComparison.Ordinal);
}
