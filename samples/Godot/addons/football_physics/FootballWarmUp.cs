#nullable enable
using System.Threading;
using System.Threading.Tasks;

namespace FootballPhysics.GodotAddon;

/// <summary>Compiles the library's code on its own thread while the game loads, so that no frame waits for it.</summary>
public static class FootballWarmUp
{
    /// <summary>The runtime optimises frequently called code after a tenth of a second.</summary>
    private const int Pause = 200;

    private static Task? s_done;

    /// <summary>A task that ends when all code is compiled.</summary>
    public static Task Done => s_done ?? Task.CompletedTask;

    /// <summary>Starts the compilation once. The first ball that enters the tree calls it.</summary>
    public static void Begin() => s_done ??= Task.Run(Run);

    private static void Run()
    {
        // Use a separate scene: a simulator with bodies or colliders belongs to one thread.
        var simulator = new Simulator(Pitch.Standard.On());
        simulator.WarmUp();
        Thread.Sleep(Pause);
        simulator.WarmUp();
    }
}
