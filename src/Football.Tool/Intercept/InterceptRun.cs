using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Intercept;

/// <summary>Simulates a shot, and finds the players who can reach the ball.</summary>
internal static class InterceptRun
{
    private const int Pieces = 4096;
    private const int MostPieces = 1 << 22;

    /// <summary>Finds the interceptions.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the library's range.</exception>
    /// <exception cref="RefusedException">The path has too many pieces for memory.</exception>
    public static InterceptOutcome Find(InterceptScenario scenario)
    {
        var interception = new Interception();
        interception.Find(Path(scenario.Shot), scenario.Runners);
        return new InterceptOutcome(scenario, [.. scenario.Runners.Select((_, i) => interception.WindowsOf(i).ToArray())], interception.FindShares().ToArray())
        {
            First = interception.First,
            Lead = interception.TimeMargin,
        };
    }

    /// <summary>Returns the path of the ball until the scenario's stop condition, in the scenario's steps.</summary>
    public static Trajectory Path(Scenario shot)
    {
        var simulator = new Simulator(shot.Scene, shot.Settings);
        BallState state = simulator.Launch(shot.Position, shot.Velocity, shot.Spin, shot.Orientation ?? simulator.LaunchOrientation);
        var request = new LookAheadRequest { Duration = shot.Duration, TimeStep = shot.TimeStep, StopAt = shot.StopAt };
        for (int pieces = Pieces; pieces <= MostPieces; pieces *= 4)
        {
            var path = new Trajectory(new PathSegment[pieces]);
            simulator.LookAhead(in state, request, path);
            if (path.IsComplete)
            {
                return path;
            }
        }

        throw new RefusedException(FormattableString.Invariant(
            $"The path is too long: stop.time {shot.Duration} / solver.timeStep {shot.TimeStep} needs more than {MostPieces} path segments. Shorten stop.time or use a larger step."));
    }
}
