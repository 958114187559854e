using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public sealed class AudioClip : Object
    {
        private AudioClip(int samples, int frequency)
        {
            this.samples = samples;
            this.frequency = frequency;
            Data = new float[samples];
        }

        public int samples { get; }

        public int frequency { get; }

        /// <summary>What was set last.</summary>
        public float[] Data { get; }

        public static AudioClip Create(string name, int lengthSamples, int channels, int frequency, bool stream) =>
            channels == 1 && !stream ? new AudioClip(lengthSamples, frequency) { name = name } : throw new NotSupportedException();

        public bool SetData(float[] data, int offsetSamples)
        {
            if (offsetSamples != 0 || data.Length > samples)
            {
                throw new ArgumentException("The clip is shorter.", nameof(data));
            }

            data.CopyTo(Data, 0);
            return true;
        }
    }

    public sealed class AudioSource : Behaviour
    {
        /// <summary>What was played, in order: the clip's samples, which later sounds may replace, and its volume.</summary>
        public List<(float[] Samples, int Rate, float Volume)> Played { get; } = new List<(float[] Samples, int Rate, float Volume)>(1024);

        public void PlayOneShot(AudioClip clip, float volumeScale) => Played.Add((clip.Data, clip.frequency, volumeScale));
    }

    public static class AudioSettings
    {
        public static int outputSampleRate { get; set; } = 48000;
    }
}
