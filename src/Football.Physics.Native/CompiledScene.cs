namespace FootballPhysics.Native;

/// <summary>A compiled scene, the object of a scene handle in C.</summary>
internal sealed class CompiledScene : Handled
{
    /// <summary>A spare aimer; null if it is in use or not created yet. Only one thread at a time may use an aimer.</summary>
    private Aimer? _aimer;

    /// <summary>A spare computation of derivatives; null if it is in use or not created yet.</summary>
    private LaunchDerivatives? _derivatives;

    private GoalChance? _goalChance;
    private Interceptor? _interceptor;

    /// <summary>Compiles a scene.</summary>
    public CompiledScene(Scene scene, SolverSettings settings)
    {
        Simulator = new Simulator(scene, settings);
        Aerodynamics = new Aerodynamics(scene);
    }

    /// <summary>The simulator of the scene.</summary>
    public Simulator Simulator { get; }

    /// <summary>The air of the scene, for bodies that C moves.</summary>
    public Aerodynamics Aerodynamics { get; }

    /// <summary>Returns an aimer. The caller gives it back.</summary>
    public Aimer TakeAimer() => Interlocked.Exchange(ref _aimer, null) ?? new Aimer(Simulator);

    /// <summary>Returns a computation of derivatives. The caller gives it back.</summary>
    public LaunchDerivatives TakeDerivatives() => Interlocked.Exchange(ref _derivatives, null) ?? new LaunchDerivatives(Simulator);

    /// <summary>Returns a search for chances to score. The caller gives it back.</summary>
    public GoalChance TakeGoalChance() => Interlocked.Exchange(ref _goalChance, null) ?? new GoalChance(Simulator.Scene);

    /// <summary>Returns a search for interceptions. The caller gives it back.</summary>
    public Interceptor TakeInterceptor() => Interlocked.Exchange(ref _interceptor, null) ?? new Interceptor(Simulator);

    /// <summary>Keeps an aimer for the next call.</summary>
    public void GiveBack(Aimer aimer) => Volatile.Write(ref _aimer, aimer);

    /// <summary>Keeps a computation of derivatives for the next call.</summary>
    public void GiveBack(LaunchDerivatives derivatives) => Volatile.Write(ref _derivatives, derivatives);

    /// <summary>Keeps a search for chances to score for the next call.</summary>
    public void GiveBack(GoalChance goalChance) => Volatile.Write(ref _goalChance, goalChance);

    /// <summary>Keeps a search for interceptions for the next call.</summary>
    public void GiveBack(Interceptor interceptor) => Volatile.Write(ref _interceptor, interceptor);
}
