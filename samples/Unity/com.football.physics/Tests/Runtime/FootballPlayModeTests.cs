using System.Collections;
using FootballPhysics.Netcode;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace FootballPhysics.Unity.Tests
{
    /// <summary>Play-mode tests of the package: Window → General → Test Runner → PlayMode, with "testables": ["com.football.physics"] in the project's manifest.</summary>
    public sealed class FootballPlayModeTests
    {
        private const int Updates = 150;

        /// <summary>Removes every object of a test before the next test.</summary>
        [TearDown]
        public void CleanUp()
        {
            foreach (FootballThing thing in All<FootballThing>())
            {
                Object.DestroyImmediate(thing.gameObject);
            }

            foreach (FootballBall ball in All<FootballBall>())
            {
                Object.DestroyImmediate(ball.gameObject);
            }
        }

        /// <summary>A kick into a goal scores exactly one goal.</summary>
        [UnityTest]
        public IEnumerator A_shot_at_an_empty_goal_scores()
        {
            FootballBall ball = Ball();
            FootballGoal goal = Goal();
            int raised = 0;
            goal.Scored += (who, happened) => raised++;
            ball.Kick(25f, new Vector3(0f, 0.2f, 1f));
            for (int i = 0; i < Updates; i++)
            {
                yield return new WaitForFixedUpdate();
            }

            Assert.AreEqual(1, raised);
            Assert.AreEqual(1, goal.Goals);
        }

        /// <summary>A ball does not fly through a post.</summary>
        [UnityTest]
        public IEnumerator A_shot_at_a_post_comes_back()
        {
            FootballBall ball = Ball();
            FootballGoal goal = Goal();
            int raised = 0;
            goal.FrameHit += (who, happened) => raised++;
            ball.Kick(new Vector3(4.72f, 3.2f, 25f), Vector3.zero);
            for (int i = 0; i < Updates; i++)
            {
                yield return new WaitForFixedUpdate();
            }

            Assert.AreEqual(1, raised);
            Assert.Less(ball.transform.position.z, 20f);
        }

        /// <summary>The component and the library give bit-identical results.</summary>
        [UnityTest]
        public IEnumerator A_kick_is_the_library_s_kick_to_the_last_bit()
        {
            FootballBall ball = Ball();
            var direct = new FixedStepRunner(new Simulator(), FootballPreset.DefaultTimeStep);
            direct.Restore(0, ball.Runner.State);
            ball.Kick(24f, new Vector3(0.2f, 0.3f, 1f), -10f, 40f);
            direct.QueueKick(24f, UnityFrame.FromUnity(new Vector3(0.2f, 0.3f, 1f)), -10f, 40f);
            for (int i = 0; i < Updates; i++)
            {
                yield return new WaitForFixedUpdate();
            }

            while (direct.Tick < ball.Runner.Tick)
            {
                direct.Step();
            }

            Assert.IsTrue(Snapshot.Same(direct.State, ball.Runner.State));
        }

        private static FootballBall Ball()
        {
            var holder = new GameObject("Ball");
            holder.transform.position = new Vector3(0f, 0.11f, 0f);
            return holder.AddComponent<FootballBall>();
        }

        private static FootballGoal Goal()
        {
            var holder = new GameObject("Goal");
            holder.transform.position = new Vector3(0f, 0f, 20f);
            return holder.AddComponent<FootballGoal>();
        }

        private static T[] All<T>()
            where T : Component
        {
#if UNITY_6000_4_OR_NEWER
            return Object.FindObjectsByType<T>();
#elif UNITY_2023_1_OR_NEWER
            return Object.FindObjectsByType<T>(FindObjectsSortMode.None);
#else
            return Object.FindObjectsOfType<T>();
#endif
        }
    }
}
