using System.Diagnostics;

namespace FootballPhysics.Labs;

/// <summary>Runs a method on requests, times it, and measures the misses of its kicks.</summary>
internal sealed class AimBench
{
    private readonly ThesisAimer _aimer;
    private readonly Simulator _own;
    private readonly LookAheadRequest _ownSteps;
    private readonly Trajectory _path = new(8192);
    private readonly bool _judgeOwn;

    /// <summary>Prepares a bench for a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="settings">The thesis methods' integrator.</param>
    /// <param name="timeStep">The time step of the thesis methods, s.</param>
    /// <param name="judgeOwn">True if misses are measured in that integrator, not in the reference simulation.</param>
    public AimBench(Scene scene, SolverSettings settings, double timeStep, bool judgeOwn = false)
    {
        _aimer = new ThesisAimer(scene, settings, timeStep);
        _own = new Simulator(scene, settings);
        _ownSteps = new LookAheadRequest { TimeStep = timeStep, Duration = 30, StopAt = StopAt.Impact };
        _judgeOwn = judgeOwn;
    }

    /// <summary>The default scene with RK2.</summary>
    public static AimBench Rk2(double timeStep) => new(Scene.Published, new SolverSettings { Integrator = Integrator.Rk2 }, timeStep);

    /// <summary>Runs a method on every request.</summary>
    public AimShot[] Run(IReadOnlyList<AimRequest> requests, AimMethod method)
    {
        WarmUp(requests, method);
        return [.. requests.Select(request => Run(request, method))];
    }

    /// <summary>Runs the method until the runtime has compiled its final code.</summary>
    private void WarmUp(IReadOnlyList<AimRequest> requests, AimMethod method)
    {
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < 100 || Stopwatch.GetElapsedTime(start).TotalMilliseconds < 250; i++)
        {
            _aimer.Find(requests[i % requests.Count], method, measure: false);
        }
    }

    private AimShot Run(AimRequest request, AimMethod method)
    {
        long start = Stopwatch.GetTimestamp();
        _aimer.Find(request, method, measure: false);
        double microseconds = Stopwatch.GetElapsedTime(start).TotalMicroseconds;
        AimResult result = _aimer.Find(request, method);
        return new AimShot(request, result, _judgeOwn ? OwnMiss(request, in result) : result.Miss, microseconds);
    }

    private double OwnMiss(AimRequest request, in AimResult result)
    {
        BallState ball = _own.Launch(request.From, result.Velocity, result.Spin);
        _own.LookAhead(in ball, _ownSteps, _path);
        return _path.ClosestApproach(request.Target).Distance;
    }
}
