using System;

namespace FootballPhysics.Unity
{
    /// <content>The events of the ball.</content>
    public sealed partial class FootballBall
    {
        /// <summary>Raised for every event of the ball. The events below are raised by kind.</summary>
        public event Action<FootballBall, FootballEvent> Happened;

        /// <summary>The ball hit an object: the ground, a post, a wall.</summary>
        public event Action<FootballBall, FootballEvent> Impact;

        /// <summary>The ball began to slide on a surface.</summary>
        public event Action<FootballBall, FootballEvent> Slide;

        /// <summary>The ball began to roll without slip.</summary>
        public event Action<FootballBall, FootballEvent> Roll;

        /// <summary>The ball came to rest.</summary>
        public event Action<FootballBall, FootballEvent> Rest;

        /// <summary>The ball hit a net.</summary>
        public event Action<FootballBall, FootballEvent> Net;

        /// <summary>A goal: the whole ball has crossed the line.</summary>
        public event Action<FootballBall, FootballEvent> Goal;

        /// <summary>The same events for the inspector.</summary>
        public FootballBallEvents Events => events;

        private void Raise(FootballEvent happened)
        {
            Happened?.Invoke(this, happened);
            switch (happened.Kind)
            {
                case BallEventKind.Impact:
                    Impact?.Invoke(this, happened);
                    break;
                case BallEventKind.Slide:
                    Slide?.Invoke(this, happened);
                    break;
                case BallEventKind.Roll:
                    Roll?.Invoke(this, happened);
                    break;
                case BallEventKind.Rest:
                    Rest?.Invoke(this, happened);
                    break;
                case BallEventKind.Net:
                    Net?.Invoke(this, happened);
                    break;
                case BallEventKind.Goal:
                    Goal?.Invoke(this, happened);
                    break;
            }

            events.Invoke(happened);
            if (happened.Goal != null)
            {
                happened.Goal.Raise(happened);
            }
        }
    }
}
