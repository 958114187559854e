using System;
using System.Collections.Generic;

namespace FootballPhysics.Shims
{
    /// <summary>The network of the stand-ins: each message arrives some ticks late, also after a later one.</summary>
    public static class LateNetwork
    {
        private static readonly List<(long Due, Action Deliver)> s_waiting = new List<(long Due, Action Deliver)>();
        private static Random s_random = new Random(1);
        private static long s_now;

        /// <summary>The number of messages that were late by at least a tick.</summary>
        public static int Late { get; private set; }

        /// <summary>The greatest delay, ticks.</summary>
        public static int Most { get; set; }

        /// <summary>Begins with nothing on its way.</summary>
        public static void Reset(int most, int seed)
        {
            s_waiting.Clear();
            s_random = new Random(seed);
            s_now = 0;
            Late = 0;
            Most = most;
        }

        /// <summary>Sends a message.</summary>
        public static void Post(Action deliver)
        {
            int delay = 1 + s_random.Next(Most);
            Late++;
            s_waiting.Add((s_now + delay, deliver));
        }

        /// <summary>Goes on by a tick, and delivers what is due.</summary>
        public static void Tick()
        {
            s_now++;
            var due = s_waiting.FindAll(message => message.Due <= s_now);
            s_waiting.RemoveAll(message => message.Due <= s_now);
            due.ForEach(message => message.Deliver());
        }
    }
}
