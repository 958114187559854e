using System;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <content>Where the ball goes.</content>
    public sealed partial class FootballBall
    {
        private readonly StepLog _log = new StepLog();
        private Vector3[] _path = Array.Empty<Vector3>();
        private FootballScene _preview;
        private int _previewStamp;

        /// <summary>The path ahead, if nobody touches the ball: a point every step, the present one first. Keepers are left out. Allocates nothing.</summary>
        /// <param name="points">Filled from the start.</param>
        /// <returns>How many points were filled in; fewer than there is room for when the ball comes to rest.</returns>
        public int PredictPath(Span<Vector3> points)
        {
            FixedStepRunner runner = Runner;
            ApplyChanges();
            _scene.CollidersAreAt(runner.State.Time);
            return Follow(_scene.Stage.Ahead, _scene.Stage.PredictionState(runner.State), _runner.TimeStep, points);
        }

        /// <summary>The path of a kick from where the ball is, in a game that runs. Allocates nothing.</summary>
        /// <param name="velocity">Velocity, m/s.</param>
        /// <param name="spin">Spin, rad/s.</param>
        /// <param name="points">Filled from the start.</param>
        /// <returns>How many points were filled in.</returns>
        public int PredictKick(Vector3 velocity, Vector3 spin, Span<Vector3> points)
        {
            FixedStepRunner runner = Runner;
            ApplyChanges();
            _scene.CollidersAreAt(runner.State.Time);
            BallState state = _scene.Stage.PredictionState(runner.State);
            _scene.Stage.Ahead.Kick(ref state, UnityFrame.FromUnity(velocity), UnityFrame.SpinFromUnity(spin));
            return Follow(_scene.Stage.Ahead, state, _runner.TimeStep, points);
        }

        /// <summary>The path of the kick that the editor shows, from where the ball is; without a game running. It follows the preset, goals, walls and colliders. Allocates nothing but where they change.</summary>
        /// <param name="points">Filled from the start.</param>
        /// <returns>How many points were filled in.</returns>
        public int PreviewPath(Span<Vector3> points)
        {
            int stamp = Stamp();
            if (_preview == null || stamp != _previewStamp)
            {
                TryGetComponent(out Rigidbody own);
                _preview = new FootballScene(preset, hits.value, greatestSpeed, own);
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
