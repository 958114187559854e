using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>The events of a ball, for connections in the inspector.</summary>
    [Serializable]
    public sealed class FootballBallEvents
    {
        [Tooltip("The ball hit something: the ground, a post, a wall.")]
        public FootballUnityEvent impact = new FootballUnityEvent();

        [Tooltip("The ball began to slide on a surface.")]
        public FootballUnityEvent slide = new FootballUnityEvent();

        [Tooltip("The ball began to roll without slip.")]
        public FootballUnityEvent roll = new FootballUnityEvent();

        [Tooltip("The ball came to rest.")]
        public FootballUnityEvent rest = new FootballUnityEvent();

        [Tooltip("The ball lost contact with the surface it slid or rolled on.")]
        public FootballUnityEvent leave = new FootballUnityEvent();

        [Tooltip("The ball hit a net.")]
        public FootballUnityEvent net = new FootballUnityEvent();

        [Tooltip("A goal: the whole ball has crossed the line.")]
        public FootballUnityEvent goal = new FootballUnityEvent();

        [Tooltip("Moving objects pinned the ball or released it; see the ball's motion.")]
        public FootballUnityEvent squeezed = new FootballUnityEvent();

        [Tooltip("The ball entered a zone of the scene, named by the event's Surface.")]
        public FootballUnityEvent enterZone = new FootballUnityEvent();

        [Tooltip("The ball left a zone of the scene, named by the event's Surface.")]
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
