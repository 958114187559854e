using System;
using System.Collections.Generic;
using FootballPhysics.Engines;
using FootballPhysics.Prediction;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>The scene of one ball: its preset, the football objects of Unity's scene, and Unity's colliders.</summary>
    internal sealed class FootballScene
    {
        private readonly List<FootballGoal> _goals = new List<FootballGoal>();
        private readonly List<FootballKeeper> _keepers = new List<FootballKeeper>();
        private readonly FootballColliders _colliders;
        private readonly FootballColliders _collidersAhead;

        /// <summary>Compiles the scene.</summary>
        /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message contains its name.</exception>
        public FootballScene(FootballPreset preset, int hits, float greatestSpeed, PhysicsScene physics, Rigidbody own)
        {
            Stage = new BallScene(preset != null ? preset.MakeScene() : null, preset != null ? preset.Settings : null);
            if (hits != 0)
            {
                _colliders = new FootballColliders(physics, own, hits, greatestSpeed, true);
                _collidersAhead = new FootballColliders(physics, own, hits, greatestSpeed, false);
                Stage.Colliders = _colliders;
                Stage.PredictionColliders = _collidersAhead;
            }

            foreach (FootballThing thing in FootballThing.InOrder())
            {
                thing.AddTo(this);
            }

            Stage.Compile();
        }

        public BallScene Stage { get; }

        /// <summary>The maximum speed of colliders, m/s.</summary>
        public float GreatestSpeed
        {
            set
            {
                if (_colliders != null)
                {
                    _colliders.MaximumSpeed = value;
                    _collidersAhead.MaximumSpeed = value;
                }
            }
        }

        /// <summary>Adds a goal.</summary>
        public void Add(FootballGoal goal, Goal made)
        {
            Stage.Add(made);
            _goals.Add(goal);
        }

        /// <summary>Adds a keeper to a goal, or to the nearest one.</summary>
        public void Add(FootballKeeper keeper, FootballGoal goal, Vector3d feet, Player abilities)
        {
            int index = goal != null ? _goals.IndexOf(goal) : Stage.NearestGoal(feet);
            if (index < 0)
            {
                Debug.LogWarning(keeper.name + ": this keeper has no goal to guard. Add a Football Goal to the scene.", keeper);
                return;
            }

            Stage.AddKeeper(index, feet, abilities);
            _keepers.Add(keeper);
        }

        /// <summary>Sets the time, on the ball's clock, at which the positions of Unity's colliders hold, and the velocities of those without a Rigidbody.</summary>
        public void CollidersAreAt(double time, ColliderMotions motions)
        {
            if (_colliders != null)
            {
                _colliders.Time = time;
                _colliders.Motions = motions;
                _collidersAhead.Time = time;
                _collidersAhead.Motions = motions;
            }
        }

        /// <summary>Converts an event to Unity's frame, with its goal or collider.</summary>
        public FootballEvent Convert(in BallEvent happened)
        {
            int goal = happened.ColliderIndex >= 0 ? Stage.GoalOf(in happened) : -1;
            return new FootballEvent(
                in happened,
                Stage.Game,
                Stage.Game.NameOf(happened.ColliderIndex),
                UnityFrame.ToUnity(Stage.Game.ImpactOf(in happened).Impulse),
                goal >= 0 ? _goals[goal] : null,
                _colliders?.Of(Stage.ColliderOf(in happened)));
        }

        /// <summary>Applies the impulse to the body that was hit, if it is a dynamic body.</summary>
        public void Push(in FootballEvent happened)
        {
            if (happened.Kind == BallEventKind.Impact && happened.Collider != null)
            {
                Rigidbody body = happened.Collider.attachedRigidbody;
                if (body != null && !body.isKinematic)
                {
                    Vector3 point = happened.Position - (happened.Normal * (float)Stage.Game.Scene.Ball.Radius);
                    body.AddForceAtPosition(happened.Impulse * -1f, point, ForceMode.Impulse);
                }
            }
        }

        /// <summary>Draws the nets and the keepers in their current shape.</summary>
        public void Draw()
        {
            for (int i = 0; i < _goals.Count; i++)
            {
                if (_goals[i] != null)
                {
                    _goals[i].Follow(Stage.Bulges, Stage.FirstNetOf(i));
                }
            }

            for (int i = 0; i < _keepers.Count; i++)
            {
                if (_keepers[i] != null)
                {
                    _keepers[i].Follow(Stage.Keepers[i]);
                }
            }
        }
    }
}
