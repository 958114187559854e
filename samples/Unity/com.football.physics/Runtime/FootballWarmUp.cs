using System.Threading;
using System.Threading.Tasks;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Has the library's code compiled on a thread of its own while the first scene loads, so that no frame of the game waits for it.</summary>
    public static class FootballWarmUp
    {
        /// <summary>The runtime optimises frequently called code after a tenth of a second.</summary>
        private const int Pause = 200;

        private static Task s_done;

        /// <summary>Ends when all is compiled; where there are no threads, as on the web, it never starts and has ended.</summary>
        public static Task Done => s_done ?? Task.CompletedTask;

        /// <summary>Starts it, once; Unity calls it before the first scene is loaded.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
        public static void Begin()
        {
#if !UNITY_WEBGL || UNITY_EDITOR
            s_done = s_done ?? Task.Run(Run);
#endif
        }

        private static void Run()
        {
            // A scene of its own: a simulator with bodies or colliders is for one thread.
            var simulator = new Simulator(Pitch.Standard.On());
            simulator.WarmUp();
            Thread.Sleep(Pause);
            simulator.WarmUp();
        }
    }
}
