#nullable enable
using System.Threading;
using System.Threading.Tasks;

namespace FootballPhysics.GodotAddon;

/// <summary>Has the library's code compiled on a thread of its own while the game loads, so that no frame waits for it.</summary>
public static class FootballWarmUp
{
    /// <summary>From a tenth of a second on the runtime compiles in full what has run often.</summary>
    private const int Pause = 200;

    private static Task? s_done;

    /// <summary>Ends when all is compiled.</summary>
    public static Task Done => s_done ?? Task.CompletedTask;

    /// <summary>Starts it, once; the first ball that enters the tree calls it.</summary>
    public static void Begin() => s_done ??= Task.Run(Run);

    private static void Run()
    {
        // A scene of its own: a simulator with bodies or colliders is for one thread.
        var simulator = new Simulator(Pitch.Standard.On());
        simulator.WarmUp();
        Thread.Sleep(Pause);
        simulator.WarmUp();
    }
}
