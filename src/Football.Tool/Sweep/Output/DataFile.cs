using System.Security.Cryptography;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>A growing file and the hash of its content.</summary>
internal sealed class DataFile : IDisposable
{
    private const int Chunk = 1 << 20;

    private readonly FileStream _stream;
    private readonly IncrementalHash _hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
    private readonly string _name;
    private readonly int _header;

    private DataFile(FileStream stream, string name, int header)
    {
        _stream = stream;
        _name = name;
        _header = header;
    }

    /// <summary>The present length and hash.</summary>
    public FileRecord Record => new(_name, _stream.Position, _header, Convert.ToHexStringLower(_hash.GetCurrentHash()));

    /// <summary>Makes a file, or begins again what there is.</summary>
    public static DataFile Create(string folder, string name, byte[] header)
    {
        // Who holds it is not disturbed. What other names the file has keep what is in it: it may be the input of somebody.
        Open(folder, name, FileMode.OpenOrCreate).Dispose();
        string path = Path.Combine(folder, name);
        if (new FileInfo(path).LinkTarget is null)
        {
            File.Delete(path);
        }

        var file = new DataFile(Open(folder, name, FileMode.Create), name, header.Length);
        file.Write(header);
        return file;
    }

    /// <summary>Continues after the part that a record confirms; later bytes are discarded.</summary>
    /// <exception cref="RefusedException">What there should be is not there.</exception>
    public static DataFile Continue(string folder, FileRecord record)
    {
        var file = new DataFile(Open(folder, record.Name, FileMode.OpenOrCreate), record.Name, record.Header);
        byte[] chunk = new byte[Chunk];
        long left = record.Bytes;
        while (left > 0 && file._stream.Read(chunk, 0, (int)Math.Min(chunk.Length, left)) is > 0 and int read)
        {
            file._hash.AppendData(chunk, 0, read);
            left -= read;
        }

        if (left > 0 || file.Record.Sha256 != record.Sha256)
        {
            file.Dispose();
            string path = Quote.File(Path.Combine(folder, record.Name));
            throw new RefusedException(FormattableString.Invariant($"{path} is damaged: its first {record.Bytes} bytes differ from those that were written. Remove the folder to start again."));
        }

        file._stream.SetLength(record.Bytes);
        return file;
    }

    /// <summary>The SHA-256 of a file, in hexadecimal digits.</summary>
    public static string HashOf(string path)
    {
        using FileStream from = File.OpenRead(path);
        return Convert.ToHexStringLower(SHA256.HashData(from));
    }

    public void Write(ReadOnlySpan<byte> bytes)
    {
        _stream.Write(bytes);
        _hash.AppendData(bytes);
    }

    /// <summary>Waits until all of it is on the disk.</summary>
    public void FlushToDisk() => _stream.Flush(flushToDisk: true);

    public void Dispose()
    {
        _stream.Dispose();
        _hash.Dispose();
    }

    /// <summary>Nobody else writes it meanwhile.</summary>
    private static FileStream Open(string folder, string name, FileMode mode) =>
        new(Path.Combine(folder, name), mode, FileAccess.ReadWrite, FileShare.None, bufferSize: 0);
}
