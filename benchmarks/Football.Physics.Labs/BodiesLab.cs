using System.Diagnostics;

namespace FootballPhysics.Labs;

/// <summary>football lab bodies: compares an engine's rigid body with <see cref="Aerodynamics"/> with the library's own flight.</summary>
internal static class BodiesLab
{
    private const int Kicks = 60;
    private const int Many = 10_000;
    private const int Repeats = 200;

    /// <summary>The largest additional error of a body over its own integrator with exact forces, m.</summary>
    private const double MostMore = 0.01;

    /// <summary>The largest error of a body with the corrected kick at 30 m and 240 Hz, m.</summary>
    private const double MostCorrected = 0.02;

    /// <summary>The longest time of a kick to the last distance, s.</summary>
    private const double LongestKick = 2;

    /// <summary>The longest time of a body that misses it, s.</summary>
    private const double Longest = 6;

    private static readonly double[] Distances = [10, 20, 30];

    private enum Body
    {
        /// <summary>The library's own semi-implicit Euler method.</summary>
        Exact,

        /// <summary>A rigid body in single precision with the forces of <see cref="Aerodynamics"/>.</summary>
        Rigid,

        /// <summary>The rigid body, kicked with <see cref="Aerodynamics.KickVelocity"/>.</summary>
        Kicked,

        /// <summary>The kicked body, with the forces of <see cref="Aerodynamics.EvaluateForStep"/> too.</summary>
        Corrected,
    }

    public static Lab Create() => new Lab(
        "bodies",
        "How far a rigid body, stepped as engines do, misses the library's own flight at 10, 20 and 30 m, with the air's forces from Aerodynamics.",
        ["football lab bodies"]).Plays(Run);

    private static void Run(LabRun run)
    {
        SeededRandom random = run.Random(53);
        var scene = new Scene { Ground = Ground.None };
        var air = new Aerodynamics(scene);
        LabTable table = run.Table(
            "60 kicks: distance from the library's flight in the plane, mm",
            "steps", "distance, m", "exact mean", "exact worst", "body mean", "body worst", "more, worst", "kicked mean", "kicked worst", "corrected mean", "corrected worst", "verdict");
        var kicks = new (Vector3d Velocity, Vector3d Spin)[Kicks];
        var truth = new Vector3d[Kicks][];
        for (int i = 0; i < Kicks;)
        {
            // A slow ball that falls does not get this far: draw another kick.
            kicks[i] = Kick(random);
            truth[i] = Flight(scene, new SolverSettings { Integrator = Integrator.Rk4 }, 0.001, kicks[i].Velocity, kicks[i].Spin, LongestKick);
            i += truth[i][^1].IsFinite ? 1 : 0;
        }

        foreach (int rate in (int[])[240, 50])
        {
            run.Progress.Report(table.Rows.Count, 6, () => $"{rate} Hz");
            double step = 1.0 / rate;
            double[][][] misses = [.. Enum.GetValues<Body>().Select(body => Misses(body, scene, air, step, kicks, truth))];
            for (int d = 0; d < Distances.Length; d++)
            {
                double[] Of(Body body) => [.. misses[(int)body].Select(kick => 1e3 * kick[d])];
                double[] exact = Of(Body.Exact);
                double[] rigid = Of(Body.Rigid);
                double[] kicked = Of(Body.Kicked);
                double[] corrected = Of(Body.Corrected);
                double more = rigid.Zip(exact, (mine, own) => mine - own).Max();
                bool holds = more <= 1e3 * MostMore && (rate != 240 || corrected.Max() <= 1e3 * MostCorrected);
                table.Judge(holds, $"{rate} Hz", Distances[d], exact.Average(), exact.Max(), rigid.Average(), rigid.Max(), more, kicked.Average(), kicked.Max(), corrected.Average(), corrected.Max());
            }
        }

        run.Notes.Add("exact: the library's semi-implicit Euler method. body: single precision, forces from Aerodynamics. kicked: the same, kicked with KickVelocity. corrected: forces from EvaluateForStep too.");
        run.Notes.Add(FormattableString.Invariant($"{Many} bodies in one call: {TimeOfMany(air, kicks):0.00} ms"));
    }

    private static (Vector3d Velocity, Vector3d Spin) Kick(SeededRandom random)
    {
        double speed = random.Uniform(18, 32);
        double elevation = random.Uniform(5, 25) * Math.PI / 180;
        double spin = random.Uniform(0, 60);
        var axis = new Vector3d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
        return (new Vector3d(0, speed * Math.Sin(elevation), -speed * Math.Cos(elevation)), spin / axis.Length * axis);
    }

    /// <summary>Returns the misses of each kick at each distance, m.</summary>
    private static double[][] Misses(Body body, Scene scene, Aerodynamics air, double step, (Vector3d Velocity, Vector3d Spin)[] kicks, Vector3d[][] truth) =>
        [.. kicks.Select((kick, i) =>
        {
            Vector3d[] at = body == Body.Exact
                ? Flight(scene, new SolverSettings { Integrator = Integrator.SemiImplicitEuler }, step, kick.Velocity, kick.Spin)
                : RigidBody(air, step, body, kick.Velocity, kick.Spin);
            return Enumerable.Range(0, Distances.Length).Select(d => (at[d] - truth[i][d]).Length).ToArray();
        })];

    /// <summary>Returns the points at which the library's own flight passes the distances.</summary>
    private static Vector3d[] Flight(Scene scene, SolverSettings settings, double step, Vector3d velocity, Vector3d spin, double longest = Longest)
    {
        var simulator = new Simulator(scene, settings);
        var log = new StepLog();
        BallState state = simulator.Launch(Vector3d.Zero, velocity, spin);
        return Crossings(step, longest, () =>
        {
            simulator.Step(ref state, step, log);
            return state.Position;
        });
    }

    /// <summary>Returns the points at which a body passes the distances. It is stepped as in an engine: in single precision, v += Δt a and then p += Δt v.</summary>
    private static Vector3d[] RigidBody(Aerodynamics air, double step, Body body, Vector3d kick, Vector3d kickSpin)
    {
        float dt = (float)step;
        float mass = (float)air.Scene.Ball.Mass;
        float inertia = (float)air.Scene.Ball.MomentOfInertia;
        var gravity = new System.Numerics.Vector3(0, -9.81f, 0);
        Vector3d pull = (Vector3d)gravity + (air.Buoyancy / air.Scene.Ball.Mass);
        System.Numerics.Vector3 position = default;
        System.Numerics.Vector3 velocity = (body == Body.Rigid ? kick : air.KickVelocity(Vector3d.Zero, kick, kickSpin, dt, pull)).ToVector3();
        System.Numerics.Vector3 spin = kickSpin.ToVector3();
        return Crossings(step, Longest, () =>
        {
            ForceAndTorque load = body == Body.Corrected
                ? air.EvaluateForStep(position, velocity, spin, dt, pull)
                : air.Evaluate(position, velocity, spin);
            velocity += dt * (gravity + ((load.Force + air.Buoyancy).ToVector3() / mass));
            spin += dt * (load.Torque.ToVector3() / inertia);
            position += dt * velocity;
            return position;
        });
    }

    /// <summary>Returns the first points at the distances along −z, interpolated linearly between the steps; NaN for distances that the ball does not reach in time.</summary>
    private static Vector3d[] Crossings(double step, double longest, Func<Vector3d> move)
    {
        var points = new Vector3d[Distances.Length];
        Array.Fill(points, new Vector3d(double.NaN, double.NaN, double.NaN));
        Vector3d before = Vector3d.Zero;
        int next = 0;
        for (double time = 0; next < points.Length && time < longest; time += step)
        {
            Vector3d after = move();
            for (; next < points.Length && -after.Z >= Distances[next]; next++)
            {
                points[next] = before + ((Distances[next] + before.Z) / (before.Z - after.Z) * (after - before));
            }

            before = after;
        }

        return points;
    }

    /// <summary>Returns the least time of a call for many bodies, ms.</summary>
    private static double TimeOfMany(Aerodynamics air, (Vector3d Velocity, Vector3d Spin)[] kicks)
    {
        var positions = new Vector3d[Many];
        Vector3d[] velocities = [.. Enumerable.Range(0, Many).Select(i => kicks[i % Kicks].Velocity)];
        Vector3d[] spins = [.. Enumerable.Range(0, Many).Select(i => kicks[i % Kicks].Spin)];
        var loads = new ForceAndTorque[Many];
        double least = double.PositiveInfinity;
        for (int i = 0; i < Repeats; i++)
        {
            long start = Stopwatch.GetTimestamp();
            air.Evaluate(positions, velocities, spins, 0, loads);
            least = Math.Min(least, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }

        return least;
    }
}
