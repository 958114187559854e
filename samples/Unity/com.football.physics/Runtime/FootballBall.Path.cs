using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <content>Predictions of the ball's path.</content>
    public sealed partial class FootballBall
    {
        private readonly StepLog _log = new StepLog();
        private Vector3[] _path = Array.Empty<Vector3>();
        private FootballScene _preview;
        private int _previewStamp;

        /// <summary>Predicts the path of the ball without keepers: one point per step, beginning with the current position. Allocates nothing.</summary>
        /// <param name="points">Receives the points.</param>
        /// <returns>The number of points written. It is smaller than the length of the span if the ball comes to rest.</returns>
        public int PredictPath(Span<Vector3> points)
        {
            FixedStepRunner runner = Runner;
            ApplyChanges();
            PlaceColliders();
            return Follow(_scene.Stage.Ahead, _scene.Stage.PredictionState(runner.State), _runner.TimeStep, points);
        }

        /// <summary>Predicts the path of a kick from the ball's position, while the game runs. Allocates nothing.</summary>
        /// <param name="velocity">Velocity, m/s.</param>
        /// <param name="spin">Spin, rad/s.</param>
        /// <param name="points">Receives the points.</param>
        /// <returns>The number of points written.</returns>
        public int PredictKick(Vector3 velocity, Vector3 spin, Span<Vector3> points)
        {
            FixedStepRunner runner = Runner;
            ApplyChanges();
            PlaceColliders();
            BallState state = _scene.Stage.PredictionState(runner.State);
            _scene.Stage.Ahead.Kick(ref state, UnityFrame.FromUnity(velocity), UnityFrame.SpinFromUnity(spin));
            return Follow(_scene.Stage.Ahead, state, _runner.TimeStep, points);
        }

        /// <summary>Predicts the path of the kick that the editor shows, from the ball's position, without a running game. It follows changes of the preset, goals, walls and colliders, and allocates only after such a change.</summary>
        /// <param name="points">Receives the points.</param>
        /// <returns>The number of points written.</returns>
        public int PreviewPath(Span<Vector3> points)
        {
            int stamp = Stamp();
            if (_preview == null || stamp != _previewStamp)
            {
                _preview = NewScene();
                _previewStamp = stamp;
            }

            Simulator ahead = _preview.Stage.Ahead;
            BallState state = ahead.Launch(UnityFrame.FromUnity(transform.position), default, default);
            Vector3d direction = UnityFrame.FromUnity(kick.Direction);
            ahead.Kick(ref state, (kick.speed / direction.Length) * direction, KickVectors.Spin(direction, kick.topSpin, kick.sideSpin));
            return Follow(ahead, state, TimeStep, points);
        }

        private void OnDrawGizmosSelected()
        {
            int room = 1 + (int)(gizmoSeconds / TimeStep);
            if (_path.Length != room)
            {
                _path = new Vector3[room];
            }

            int count = _runner != null ? PredictPath(_path) : PreviewPath(_path);
            Gizmos.color = Color.yellow;
            for (int i = 1; i < count; i++)
            {
                Gizmos.DrawLine(_path[i - 1], _path[i]);
            }

            Gizmos.DrawWireSphere(_path[count - 1], Radius);
        }

        private void OnDrawGizmos()
        {
            // Between the steps of a game, the forces are those with which the next step begins.
            BallForces forces = gizmoForces > 0f && _runner != null ? _runner.Simulator.ForcesAt(_runner.State, _runner.TimeStep) : null;
            if (forces == null)
            {
                return;
            }

            Vector3 ball = UnityFrame.ToUnity(_runner.State.Position);
            DrawForce(ball, forces.Weight + forces.Buoyancy, Color.white);
            DrawForce(ball, forces.Drag, Color.red);
            DrawForce(ball, forces.Magnus, Color.green);
            DrawForce(ball, forces.Knuckle, Color.magenta);
            DrawForce(ball, forces.Custom, Color.cyan);
            DrawForce(ball, forces.Nets, Color.gray);
            foreach (ContactForce contact in forces.Contacts)
            {
                Vector3 point = UnityFrame.ToUnity(contact.Point);
                DrawForce(point, contact.Load, Color.blue);
                DrawForce(point, contact.Friction, Color.yellow);
            }
        }

        private void DrawForce(Vector3 from, Vector3d force, Color color)
        {
            Vector3 arrow = gizmoForces * UnityFrame.ToUnity(force);
            if (arrow.magnitude > 1e-3f)
            {
                Gizmos.color = color;
                Gizmos.DrawLine(from, from + arrow);
                Gizmos.DrawWireSphere(from + arrow, 0.02f);
            }
        }

        private int Follow(Simulator simulator, BallState state, double timeStep, Span<Vector3> points)
        {
            using (s_path.Auto())
            {
                int count = 0;
                while (count < points.Length)
                {
                    points[count++] = UnityFrame.ToUnity(state.Position);
                    if (state.Motion == MotionState.Rest)
                    {
                        break;
                    }

                    _log.Clear();
                    simulator.Step(ref state, timeStep, _log);
                }

                return count;
            }
        }
    }
}
