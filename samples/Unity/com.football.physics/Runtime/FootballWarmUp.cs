using System.Threading;
using System.Threading.Tasks;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Compiles the library's code on its own thread while the first scene loads, so that no frame of the game waits for it.</summary>
    public static class FootballWarmUp
    {
        /// <summary>The runtime optimises frequently called code after a tenth of a second.</summary>
        private const int Pause = 200;

        private static Task s_done;

        /// <summary>A task that ends when all code is compiled. On platforms without threads, such as the web, nothing is compiled, and the task has ended.</summary>
        public static Task Done => s_done ?? Task.CompletedTask;

        /// <summary>Starts the compilation once. Unity calls it before the first scene loads.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
        public static void Begin()
        {
#if !UNITY_WEBGL || UNITY_EDITOR
            s_done = s_done ?? Task.Run(Run);
#endif
        }

        private static void Run()
        {
            // Use a separate scene: a simulator with bodies or colliders belongs to one thread.
            var simulator = new Simulator(Pitch.Standard.On());
            simulator.WarmUp();
            Thread.Sleep(Pause);
            simulator.WarmUp();
        }
    }
}
