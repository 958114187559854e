using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>An event of a ball, in Unity's frame.</summary>
    public readonly struct FootballEvent
    {
        private readonly BallEvent _happened;
        private readonly Simulator _game;

        internal FootballEvent(in BallEvent happened, Simulator game, string surface, Vector3 impulse, FootballGoal goal, Collider collider)
        {
            _happened = happened;
            _game = game;
            Surface = surface;
            Impulse = impulse;
            Goal = goal;
            Collider = collider;
            ApproachSpeed = (float)happened.ApproachSpeed;
            Normal = UnityFrame.ToUnity(happened.Normal);
            Kind = happened.Kind;
            Time = happened.Time;
            Position = UnityFrame.ToUnity(happened.Position);
            VelocityBefore = UnityFrame.ToUnity(happened.VelocityBefore);
            SpinBefore = UnityFrame.SpinToUnity(happened.SpinBefore);
            Velocity = UnityFrame.ToUnity(happened.Velocity);
            Spin = UnityFrame.SpinToUnity(happened.Spin);
        }

        /// <summary>The kind of the event.</summary>
        public BallEventKind Kind { get; }

        /// <summary>The name of the collider: "ground", "left post" (on the goalkeeper's left), "back net", the name of an obstacle; null if there is none.</summary>
        public string Surface { get; }

        /// <summary>The normal of the contact, from the object to the ball; zero if there is no contact.</summary>
        public Vector3 Normal { get; }

        /// <summary>The exact time inside the fixed step, s, on the ball's clock.</summary>
        public double Time { get; }

        /// <summary>The position of the ball's centre, m.</summary>
        public Vector3 Position { get; }

        /// <summary>Velocity just before, m/s.</summary>
        public Vector3 VelocityBefore { get; }

        /// <summary>Spin just before, rad/s.</summary>
        public Vector3 SpinBefore { get; }

        /// <summary>Velocity just after, m/s.</summary>
        public Vector3 Velocity { get; }

        /// <summary>Spin just after, rad/s.</summary>
        public Vector3 Spin { get; }

        /// <summary>The impulse on the ball, N s; the other object gets the opposite one. Zero if the event is not an impact.</summary>
        public Vector3 Impulse { get; }

        /// <summary>The speed relative to the other object along the normal, m/s; for example for the volume of a sound.</summary>
        public float ApproachSpeed { get; }

        /// <summary>The outputs of an impact for sound, haptics and looks: peak force, contact time, compression, slip, energy. All are 0 if the event is not an impact.</summary>
        /// <remarks>The value is computed on each access; a game that does not read it pays nothing.</remarks>
        public Impact Outputs => _game is null ? default : _game.ImpactOf(in _happened);

        /// <summary>The goal of the event; null if there is none.</summary>
        public FootballGoal Goal { get; }

        /// <summary>Unity's collider that the ball hit; null if there is none.</summary>
        public Collider Collider { get; }
    }
}
