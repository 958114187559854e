using System.Collections.Concurrent;
using MathNet.Numerics.LinearAlgebra;

namespace FootballPhysics.Benchmarks;

/// <summary>The errors next to the times: the mean error of the same method at the same step, m, against RK4 at 0.5 ms with every event located.</summary>
internal static class Errors
{
    private const double ReferenceStep = 0.5e-3;
    private const double LongestFlight = 20;

    private static readonly double Contact = BallProperties.Tunnel.Radius;
    private static readonly ConcurrentDictionary<(object Shots, Scene Scene, double? After), Vector3d[]> References = new();

    /// <summary>Returns the error of the first landings of shots from the ground, by the library.</summary>
    public static double Landing(Integrator integrator, PlainLawKind law, double h, IReadOnlyList<Shot> shots)
    {
        var simulator = new Simulator(PlainFlight.SceneOf(law), new SolverSettings { Integrator = integrator });
        return Mean(Reference(shots, law, after: null), shots.Select(shot => Land(simulator, shot, h)));
    }

    /// <summary>Returns the error of the first landings by the plain yardstick, with the impact found by bisection of the step to the last bit.</summary>
    public static double PlainLanding(Integrator integrator, PlainLawKind law, double h, IReadOnlyList<Shot> shots)
    {
        var flight = PlainFlight.Create(law, integrator);
        return Mean(Reference(shots, law, after: null), shots.Select(shot => Land(flight, shot, h)));
    }

    /// <summary>Returns the error of the first landings by the thesis' method, with the impact searched to 1 µs.</summary>
    public static double ThesisLanding(Integrator integrator, double h, IReadOnlyList<Shot> shots)
    {
        var ball = new ThesisBall(integrator);
        return Mean(Reference(shots, PlainLawKind.Published, after: null), shots.Select(shot => Land(ball, shot, h)));
    }

    /// <summary>Returns the error of the first landings by MathNet.Numerics, with the impact found by bisection.</summary>
    public static double MathNetLanding(Integrator integrator, double h, IReadOnlyList<Shot> shots)
    {
        var flight = new MathNetFlight(integrator);
        return Mean(Reference(shots, PlainLawKind.Published, after: null), shots.Select(shot => Land(flight, shot, h)));
    }

    /// <summary>Returns the error of the first landings by the general rigid-body engine, at the frame's end.</summary>
    public static double EngineLanding(double h, IReadOnlyList<Shot> shots)
    {
        var engine = new RigidBodyEngine();
        return Mean(Reference(shots, PlainLawKind.Published, after: null), shots.Select(shot => Land(engine, shot, h)));
    }

    /// <summary>Returns the error of positions of shots from the ground at the end of a look-ahead, by the library.</summary>
    public static double LookAhead(Scene scene, Integrator integrator, double h, IReadOnlyList<Shot> shots) =>
        After(scene, new SolverSettings { Integrator = integrator }, h, ShotSets.LookAhead, shots);

    /// <summary>Returns the error of positions of shots after a time, s, by the library.</summary>
    public static double After(Scene scene, SolverSettings settings, double h, double time, IReadOnlyList<Shot> shots)
    {
        var simulator = new Simulator(scene, settings);
        return Mean(Reference(shots, scene, time), shots.Select(shot => Ahead(simulator, shot, h, time)));
    }

    /// <summary>Returns the error of positions of shots after one step by the thesis' method.</summary>
    public static double ThesisStep(Integrator integrator, double h, IReadOnlyList<Shot> shots)
    {
        var ball = new ThesisBall(integrator);
        return Mean(Reference(shots, PlainLawKind.Published, h), shots.Select(shot => AfterStep(ball, shot, h)));
    }

    private static double Mean(Vector3d[] truth, IEnumerable<Vector3d> places) => truth.Zip(places, (a, b) => Vector3d.Distance(a, b)).Average();

    private static Vector3d[] Reference(IReadOnlyList<Shot> shots, PlainLawKind law, double? after) => Reference(shots, PlainFlight.SceneOf(law), after);

    private static Vector3d[] Reference(IReadOnlyList<Shot> shots, Scene scene, double? after) => References.GetOrAdd((shots, scene, after), _ =>
    {
        var simulator = new Simulator(scene);
        return [.. shots.Select(shot => after is { } time ? Ahead(simulator, shot, ReferenceStep, time) : Land(simulator, shot, ReferenceStep))];
    });

    private static Vector3d Ahead(Simulator simulator, Shot shot, double h, double time)
    {
        BallState s = simulator.Launch(shot.Position, shot.Velocity, shot.Spin);
        simulator.Run(ref s, h, time, StopAt.Time, new StepLog());
        return s.Position;
    }

    private static Vector3d Land(Simulator simulator, Shot shot, double h)
    {
        BallState s = simulator.Launch(shot.Position, shot.Velocity, shot.Spin);
        simulator.Run(ref s, h, LongestFlight, StopAt.Impact, new StepLog());
        return s.Position;
    }

    private static Vector3d Land(PlainFlight flight, Shot shot, double h)
    {
        var s = PlainState.Of(shot);
        PlainState before;
        do
        {
            before = s;
            flight.Step(ref s, h);
        }
        while (s.Position.Y > Contact);
        double low = 0;
        double high = h;
        for (int i = 0; i < 50; i++)
        {
            double middle = 0.5 * (low + high);
            s = before;
            flight.Step(ref s, middle);
            (low, high) = s.Position.Y > Contact ? (middle, high) : (low, middle);
        }

        return s.Position;
    }

    private static Vector3d Land(MathNetFlight flight, Shot shot, double h)
    {
        Vector<double> s = MathNetFlight.StateOf(shot);
        Vector<double> before;
        do
        {
            before = s;
            s = flight.Fly(s, h);
        }
        while (s[1] > Contact);
        double low = 0;
        double high = h;
        for (int i = 0; i < 50; i++)
        {
            double middle = 0.5 * (low + high);
            s = flight.Fly(before, middle);
            (low, high) = s[1] > Contact ? (middle, high) : (low, middle);
        }

        return new Vector3d(s[0], s[1], s[2]);
    }

    private static Vector3d Land(ThesisBall ball, Shot shot, double h)
    {
        ball.Kick(shot);
        while (ball.Impacts == 0)
        {
            ball.FixedUpdate((float)h);
        }

        return ball.LastImpact;
    }

    private static Vector3d AfterStep(ThesisBall ball, Shot shot, double h)
    {
        ball.Kick(shot);
        ball.FixedUpdate((float)h);
        return ball.Position;
    }

    private static Vector3d Land(RigidBodyEngine engine, Shot shot, double h)
    {
        var s = PlainState.Of(shot);
        do
        {
            engine.Step(ref s, h);
        }
        while (s.Position.Y > Contact);
        return s.Position;
    }
}
