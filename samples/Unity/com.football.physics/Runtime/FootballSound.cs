using FootballPhysics.Engines;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>Plays a generated sound at each impact of the ball on this object: loud by the peak force, bright by a short contact, with a brush by the slip. It needs no recording.</summary>
    [AddComponentMenu("Football/Football Sound"), DisallowMultipleComponent, RequireComponent(typeof(FootballBall), typeof(AudioSource))]
    public sealed class FootballSound : MonoBehaviour
    {
        /// <summary>The number of sounds that can play at the same time.</summary>
        private const int Voices = 8;

        [SerializeField, Range(0f, 1f), Tooltip("Volume of the loudest impact.")]
        private float volume = 1f;

        private readonly AudioClip[] _clips = new AudioClip[Voices];
        private float[] _samples;
        private int _next;

        /// <summary>The volume of the loudest impact, 0 to 1.</summary>
        public float Volume { get => volume; set => volume = value; }

        /// <summary>The sound of the last impact.</summary>
        public ImpactSound Last { get; private set; }

        private void OnEnable()
        {
            // Make room now, so that no step allocates.
            Prepare(AudioSettings.outputSampleRate);
            GetComponent<FootballBall>().Impact += Play;
        }

        private void OnDisable()
        {
            GetComponent<FootballBall>().Impact -= Play;
        }

        private void OnDestroy()
        {
            foreach (AudioClip clip in _clips)
            {
                if (clip != null)
                {
                    Destroy(clip);
                }
            }
        }

        private void Play(FootballBall ball, FootballEvent happened)
        {
            Last = new ImpactSound(happened.Outputs);
            if (!Last.IsAudible || volume <= 0f)
            {
                return;
            }

            // Use the clips in turn: the oldest one has ended.
            int rate = AudioSettings.outputSampleRate;
            Prepare(rate);
            Last.Write(_samples, rate);
            AudioClip clip = _clips[_next];
            _next = (_next + 1) % Voices;
            clip.SetData(_samples, 0);
            GetComponent<AudioSource>().PlayOneShot(clip, volume);
        }

        private void Prepare(int rate)
        {
            int count = ImpactSound.SamplesAt(rate);
            if (_samples != null && _samples.Length == count)
            {
                return;
            }

            OnDestroy();
            _samples = new float[count];
            for (int i = 0; i < Voices; i++)
            {
                _clips[i] = AudioClip.Create("football impact", count, 1, rate, false);
            }
        }
    }
}
