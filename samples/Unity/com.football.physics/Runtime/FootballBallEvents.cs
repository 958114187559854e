using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>What happens to a ball, as events that are wired up in the inspector.</summary>
    [Serializable]
    public sealed class FootballBallEvents
    {
        [Tooltip("The ball hit something: the ground, a post, a wall.")]
        public FootballUnityEvent impact = new FootballUnityEvent();

        [Tooltip("The ball stayed down, slipping.")]
        public FootballUnityEvent slide = new FootballUnityEvent();

        [Tooltip("The ball began to roll without slip.")]
        public FootballUnityEvent roll = new FootballUnityEvent();

        [Tooltip("The ball came to rest.")]
        public FootballUnityEvent rest = new FootballUnityEvent();

        [Tooltip("A ball that was carried left what carried it.")]
        public FootballUnityEvent leave = new FootballUnityEvent();

        [Tooltip("The ball met a net.")]
        public FootballUnityEvent net = new FootballUnityEvent();

        [Tooltip("The whole ball is over the line of a goal.")]
        public FootballUnityEvent goal = new FootballUnityEvent();

        [Tooltip("Things that move leave the ball no room, or it has room again: the ball's motion says which.")]
        public FootballUnityEvent squeezed = new FootballUnityEvent();

        [Tooltip("The ball entered a zone of the scene, whose name is the surface of the event.")]
        public FootballUnityEvent enterZone = new FootballUnityEvent();

        [Tooltip("The ball left a zone of the scene, whose name is the surface of the event.")]
        public FootballUnityEvent exitZone = new FootballUnityEvent();

        internal void Invoke(FootballEvent happened)
        {
            FootballUnityEvent listeners = happened.Kind switch
            {
                BallEventKind.Impact => impact,
                BallEventKind.Slide => slide,
                BallEventKind.Roll => roll,
                BallEventKind.Rest => rest,
                BallEventKind.ContactEnd => leave,
                BallEventKind.Net => net,
                BallEventKind.Goal => goal,
                BallEventKind.Pinned => squeezed,
                BallEventKind.EnterZone => enterZone,
                BallEventKind.ExitZone => exitZone,
                _ => throw new ArgumentOutOfRangeException(nameof(happened)),
            };
            listeners.Invoke(happened);
        }
    }
}
