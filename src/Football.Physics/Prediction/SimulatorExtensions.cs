using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>Predicts paths by simulating a copy of the state, and warms up a simulator.</summary>
public static class SimulatorExtensions
{
    /// <summary>The step of a warm-up, in s, and the maximum number of steps until a ball rests.</summary>
    private const double Frame = 1.0 / 60.0;
    private const int MostFrames = 1200;

    /// <summary>Predicts the path of a ball.</summary>
    /// <param name="simulator">The scene, compiled for the integrator of the prediction.</param>
    /// <param name="from">The state of the ball; unchanged.</param>
    /// <param name="request">The duration and the stop conditions.</param>
    /// <param name="into">Receives the path and the events.</param>
    /// <remarks>Does not allocate once the trajectory is large enough. An exception from a custom force propagates; the path then ends before the
    /// failed step.</remarks>
    /// <exception cref="ArgumentException"><paramref name="from"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public static void LookAhead(this Simulator simulator, in BallState from, LookAheadRequest request, Trajectory into)
    {
        Check.Given(nameof(simulator), simulator);
        Check.Given(nameof(request), request);
        Check.Given(nameof(into), into);
        LookAheadSteps steps = into.Alone;
        steps.Start(simulator, in from, request);
        steps.Begin(endsWhenFull: false);
        steps.Run();
        if (steps.IsTooLong)
        {
            // Simulate again, up to the last segment that fits.
            steps.Begin(endsWhenFull: true);
            steps.Run();
        }
    }

    /// <summary>Predicts the paths of several balls, including their contacts with each other.</summary>
    /// <param name="group">The balls.</param>
    /// <param name="from">The states of the balls; unchanged.</param>
    /// <param name="request">The duration, and the event that ends it: the first impact of any ball, or the rest of all. A plane or a point is not
    /// supported.</param>
    /// <param name="into">Receives the path and events of each ball. If a buffer that you provided is full, its path stays incomplete, and
    /// its ball continues without it.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The number of states or trajectories differs from the number of balls, the times of the states differ, or
    /// one was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public static void LookAhead(this BallGroup group, BallState[] from, LookAheadRequest request, Trajectory[] into)
    {
        Check.Given(nameof(group), group);
        Check.Given(nameof(from), from);
        Check.Given(nameof(request), request);
        Check.Given(nameof(into), into);
        if (into.Length != group.Count)
        {
            throw new ArgumentException($"into has {into.Length} trajectories, but the group has {group.Count} balls. Pass one trajectory for each ball.");
        }

        for (int i = 0; i < into.Length; i++)
        {
            Check.GivenItem(nameof(into), i, into[i], "a trajectory");
        }

        var steps = new LookAheadSteps(group, into);
        steps.Start(from, request);
        steps.Begin(endsWhenFull: false);
        steps.Run();
    }

    /// <summary>Compiles the code and builds the tables in advance, so that no frame of your game is delayed.</summary>
    /// <remarks>
    /// The method simulates hidden balls through steps, impacts, slides, rolls and look-aheads. With just-in-time compilation, the first impact, roll and
    /// look-ahead cost milliseconds each. Call it while a level loads. It has no visible effect, but calls custom forces. A runtime optimises
    /// frequently called code only after about a tenth of a second. A second call at the end of loading therefore makes the first roll and look-ahead
    /// several times faster.
    /// </remarks>
    /// <param name="simulator">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public static void WarmUp(this Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        var path = new Trajectory();
        var look = new LookAheadRequest();
        var log = new StepLog();
        Vector3d from = simulator.OnGround(0, 0);

        // Simulate a shot, a drive without spin, and a pass along the ground.
        foreach ((Vector3d velocity, Vector3d spin) in ((Vector3d, Vector3d)[])
            [(new Vector3d(2, 7, -22), new Vector3d(10, 30, 0)), (new Vector3d(0, 2, -12), Vector3d.Zero), (new Vector3d(0, 0, -8), Vector3d.Zero)])
        {
            // Run both the look-ahead and the steps, to compile both.
            BallState ball = simulator.Launch(from, velocity, spin);
            simulator.LookAhead(in ball, look, path);
            for (int i = 0; i < MostFrames && ball.Motion != MotionState.Rest; i++)
            {
                log.Clear();
                simulator.Step(ref ball, Frame, log);
            }

            path.TryGetCrossing(new Plane3d(new Vector3d(0, 0, -5), new Vector3d(0, 0, 1)), out PathPoint at);
            path.ClosestApproach(at.Position);
        }

        // Contacts with several objects, pushes and nets occur only in scenes with objects.
        if (!simulator.World.IsBare)
        {
            WarmUpScenes.Press(simulator.Settings, log);
            WarmUpScenes.Net(simulator.Settings, log);
        }

        WarmUpScenes.Group(simulator.Settings, log);
    }
}
