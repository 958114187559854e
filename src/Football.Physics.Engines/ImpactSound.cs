using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The sound of an impact: loudness, brightness and brush, and a wave that is generated from them.</summary>
/// <remarks>
/// Loudness follows from the peak force, brightness from the duration of the contact, and brush from friction and slip. The numbers are derived from
/// <see cref="Impact"/>; the scales and the wave are a guess. Equal impacts give bit-identical waves.
/// </remarks>
public readonly record struct ImpactSound
{
    /// <summary>The peak force of the loudest sound, in N: 3000 (guess; measured kicks reach 2.9 kN).</summary>
    public const double LoudestForce = 3000;

    /// <summary>The product of friction impulse and slip of the strongest brush, in J: 50 (guess).</summary>
    public const double StrongestBrush = 50;

    /// <summary>The duration of a wave, in s: 0.25 (guess).</summary>
    public const double Duration = 0.25;

    /// <summary>The loudness below which a sound is not worth playing (guess: 40 dB below the loudest).</summary>
    private const double Inaudible = 0.01;

    /// <summary>The decay times of the tone and of the brush, in contact times (guess).</summary>
    private const double ToneDecay = 4.0;
    private const double BrushDecay = 2.0;

    /// <summary>The shares of tone and brush in the wave; together 1, so that no sample is beyond ±1.</summary>
    private const double ToneShare = 0.75;
    private const double BrushShare = 0.25;

    /// <summary>The number of overtones, each with half the amplitude of the one before and twice its decay.</summary>
    private const int Tones = 3;

    /// <summary>The range of sample rates, in Hz.</summary>
    private const int LowestRate = 8000;
    private const int HighestRate = 192_000;

    private readonly long _seed;

    /// <summary>Computes the sound of an impact.</summary>
    /// <param name="impact">The outputs of the impact; <see cref="Simulator.ImpactOf"/> returns them.</param>
    public ImpactSound(in Impact impact)
    {
        Loudness = Math.Min(1.0, impact.PeakForce / LoudestForce);
        Brightness = impact.ContactTime > 0 ? 1.0 / impact.ContactTime : 0;
        Brush = Math.Min(1.0, impact.TangentialImpulse * impact.SlipBefore / StrongestBrush);
        _seed = BitConverter.DoubleToInt64Bits(impact.NormalImpulse);
    }

    /// <summary>The amplitude of the tone, 0 … 1, in proportion to <see cref="Impact.PeakForce"/>.</summary>
    public double Loudness { get; }

    /// <summary>The frequency of the tone, in Hz: 1/T, T the contact time. About 94 for a football on a hard surface; 0 if there was no impact.</summary>
    public double Brightness { get; }

    /// <summary>The amplitude of the noise of friction, 0 … 1, in proportion to the product of friction impulse and slip.</summary>
    public double Brush { get; }

    /// <summary>True if the sound is loud enough to be played: tone or brush is above −40 dB.</summary>
    public bool IsAudible => Math.Max(Loudness, Brush) >= Inaudible;

    /// <summary>Returns the number of samples of a wave.</summary>
    /// <param name="rate">The number of samples per second, in Hz; 8000 … 192 000.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="rate"/> is out of range.</exception>
    public static int SamplesAt(int rate)
    {
        Check.Within(nameof(rate), rate, LowestRate, HighestRate);
        return (int)(Duration * rate);
    }

    /// <summary>Generates the wave: decaying tones, and noise for the brush. Does not allocate.</summary>
    /// <param name="samples">Receives the samples, −1 … 1, for one channel. If it is longer than the wave, the rest is silent.</param>
    /// <param name="rate">The number of samples per second, in Hz; 8000 … 192 000.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="rate"/> is out of range.</exception>
    public void Write(Span<float> samples, int rate)
    {
        int count = SamplesAt(rate);
        double perRate = 1.0 / rate;
        double smooth = 0;
        for (int i = 0; i < samples.Length; i++)
        {
            if (i >= count || Brightness == 0)
            {
                samples[i] = 0;
                continue;
            }

            // t in contact times. The wave fades to 0 at its end.
            double time = i * perRate;
            double t = time * Brightness;
            double noise = (2.0 * SplitMix64.At(_seed, i)) - 1.0;
            smooth += 0.5 * (noise - smooth);
            double wave = (ToneShare * Loudness * Tone(t)) + (BrushShare * Brush * Elementary.Exp(-t / BrushDecay) * smooth);
            samples[i] = (float)(wave * (1.0 - (time / Duration)));
        }
    }

    /// <summary>Returns the sum of the decaying tones, at most 1.</summary>
    private static double Tone(double t)
    {
        double sum = 0;
        double whole = 0;
        double amplitude = 1.0;
        for (int k = 1; k <= Tones; k++, amplitude *= 0.5)
        {
            Elementary.SinCos(2.0 * Math.PI * k * t, out double sine, out _);
            sum += amplitude * Elementary.Exp(-k * t / ToneDecay) * sine;
            whole += amplitude;
        }

        return sum / whole;
    }
}
