using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Aim;

/// <summary>Finds the kick for an aim scenario.</summary>
internal static class AimRun
{
    [ThreadStatic]
    private static AimScenario? s_compiledFor;

    [ThreadStatic]
    private static ThesisAimer? s_aimer;

    /// <summary>Finds the kick, and checks that it is finite.</summary>
    /// <exception cref="RefusedException">The motion overflowed, although each number is allowed.</exception>
    public static AimResult Find(AimScenario scenario)
    {
        AimResult result = Find(scenario, Compiled(scenario));
        return IsFinite(in result)
            ? result
            : throw new RefusedException("the motion overflows. Reduce the speeds, the coefficients or the distances.");
    }

    /// <summary>Finds the kick without checking the result.</summary>
    /// <param name="scenario">The scenario.</param>
    /// <param name="aimer">An aimer for the scene of the scenario.</param>
    public static AimResult Find(AimScenario scenario, ThesisAimer aimer)
    {
        AimRequest request = scenario.Request;
        return scenario.After is { } after ? new BankShotAimer(scenario.Scene).Find(request, after)
            : scenario.Slowest ? aimer.Direct.FindSlowest(request)
            : scenario.ArrivalTime is { } time ? aimer.Direct.FindAtTime(request, time)
            : scenario.ArrivalSpeed is { } speed ? aimer.Direct.FindAtSpeed(request, speed)
            : aimer.Find(request, scenario.Method);
    }

    /// <summary>Returns the thread's last aimer if the scene is the same, as is usual in a batch; otherwise a new one.</summary>
    private static ThesisAimer Compiled(AimScenario scenario)
    {
        if (s_aimer is null || s_compiledFor!.Scene != scenario.Scene || s_compiledFor.Settings != scenario.Settings || s_compiledFor.TimeStep != scenario.TimeStep)
        {
            s_aimer = new ThesisAimer(scenario.Scene, scenario.Settings, scenario.TimeStep);
            s_compiledFor = scenario;
        }

        return s_aimer;
    }

    private static bool IsFinite(in AimResult result) =>
        result.Velocity.IsFinite && result.Spin.IsFinite && result.Closest.IsFinite && double.IsFinite(result.Miss)
        && double.IsFinite(result.WaypointMiss ?? 0) && double.IsFinite(result.Time);
}
