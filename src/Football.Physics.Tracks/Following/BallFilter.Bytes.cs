using System.Buffers.Binary;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <content>The filter as bytes.</content>
public sealed partial class BallFilter
{
    private const ulong Magic = 0x0133_7265_746C_6946;

    /// <summary>The bytes before the content: the magic number, the length, the hash of scene and settings, and the hash of the content.</summary>
    private const int Header = 32;

    /// <summary>The number of bytes that <see cref="Save(Span{byte})"/> writes now; it changes with each point.</summary>
    public int SavedBytes
    {
        get
        {
            var stream = new FilterStream(default, false);
            Transfer(ref stream);
            return Header + stream.Count;
        }
    }

    /// <summary>Saves the whole filter: its points, hypotheses and estimate.</summary>
    /// <param name="destination">Receives the bytes.</param>
    /// <returns>The number of bytes.</returns>
    /// <exception cref="ArgumentException"><paramref name="destination"/> has fewer bytes than <see cref="SavedBytes"/>.</exception>
    public int Save(Span<byte> destination)
    {
        int bytes = SavedBytes;
        Check.Bytes(nameof(destination), destination.Length, bytes);
        Span<byte> content = destination.Slice(Header, bytes - Header);
        var stream = new FilterStream(content, false);
        Transfer(ref stream);
        BinaryPrimitives.WriteUInt64LittleEndian(destination, Magic);
        BinaryPrimitives.WriteInt64LittleEndian(destination.Slice(8), bytes);
        BinaryPrimitives.WriteUInt64LittleEndian(destination.Slice(16), Owner());
        BinaryPrimitives.WriteUInt64LittleEndian(destination.Slice(24), Hash(content, Magic));
        return bytes;
    }

    /// <summary>Saves the whole filter.</summary>
    /// <returns>The bytes.</returns>
    public byte[] Save()
    {
        byte[] bytes = new byte[SavedBytes];
        Save(bytes);
        return bytes;
    }

    /// <summary>Restores a filter that <see cref="Save(Span{byte})"/> saved. It then gives the same bits as the saved one.</summary>
    /// <param name="source">The bytes.</param>
    /// <exception cref="ArgumentException">These are not the bytes of a filter with this scene and these settings; nothing changes.</exception>
    public void Restore(ReadOnlySpan<byte> source)
    {
        if (source.Length < Header || BinaryPrimitives.ReadUInt64LittleEndian(source) != Magic)
        {
            throw new ArgumentException("source does not contain a filter. Pass the bytes of Save.", nameof(source));
        }

        long length = BinaryPrimitives.ReadInt64LittleEndian(source.Slice(8));
        if (length < Header || length > source.Length || BinaryPrimitives.ReadUInt64LittleEndian(source.Slice(24)) != Hash(source.Slice(Header, (int)length - Header), Magic))
        {
            throw new ArgumentException("source is damaged. Pass the complete bytes of Save.", nameof(source));
        }

        if (BinaryPrimitives.ReadUInt64LittleEndian(source.Slice(16)) != Owner())
        {
            throw new ArgumentException("source is from a filter with another scene or other settings. Create the filter with the same ones.", nameof(source));
        }

        byte[] content = source.Slice(Header, (int)length - Header).ToArray();
        var stream = new FilterStream(content, true);
        Transfer(ref stream);
    }

    private void Transfer(ref FilterStream stream)
    {
        _points.Transfer(ref stream);
        _search.Transfer(ref stream);
        stream.Numbers(_kicks);
        BallEstimate estimate = Estimate;
        Span<BallState> state = [estimate.State];
        stream.Plain(state);
        estimate.State = state[0];
        stream.Numbers(estimate.Covariances);
        estimate.KickProbability = stream.Number(estimate.KickProbability);
        estimate.KickTime = stream.Number(estimate.KickTime);
        estimate.KickDeviation = stream.Number(estimate.KickDeviation);
        estimate.IsOutlier = stream.Flag(estimate.IsOutlier);
        estimate.IsHeld = stream.Flag(estimate.IsHeld);
        stream.Numbers(_ahead);
        stream.Number(ref _aheadFrom);
        stream.Number(ref _aheadStep);
    }

    /// <summary>A hash of the scene and the settings.</summary>
    private ulong Owner()
    {
        Span<byte> bytes = stackalloc byte[8 * sizeof(double)];
        Span<double> values =
        [
            Settings.Noise, Settings.PixelNoise, Settings.KickVelocity, Settings.KickSpin, Settings.KicksPerSecond, Settings.OutlierShare, Settings.Window, Settings.MaximumGap,
        ];
        var stream = new FilterStream(bytes, false);
        stream.Numbers(values);
        return Hash(bytes, Simulator.SceneHash);
    }

    /// <summary>A hash by multiplication and shifts (FNV-1a on 64-bit words).</summary>
    private static ulong Hash(ReadOnlySpan<byte> bytes, ulong seed)
    {
        const ulong Prime = 0x0000_0100_0000_01B3;
        ulong hash = 0xCBF2_9CE4_8422_2325 ^ seed;
        unchecked
        {
            while (bytes.Length >= sizeof(ulong))
            {
                hash = (hash ^ BinaryPrimitives.ReadUInt64LittleEndian(bytes)) * Prime;
                hash ^= hash >> 29;
                bytes = bytes.Slice(sizeof(ulong));
            }

            foreach (byte rest in bytes)
            {
                hash = (hash ^ rest) * Prime;
            }

            return (hash ^ (hash >> 32)) * Prime;
        }
    }
}
