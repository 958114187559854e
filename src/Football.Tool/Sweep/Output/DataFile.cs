using System.Security.Cryptography;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>A file that grows, and the hash of its content.</summary>
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

    /// <summary>The current length and hash.</summary>
    public FileRecord Record => new(_name, _stream.Position, _header, Convert.ToHexStringLower(_hash.GetCurrentHash()));

    /// <summary>Creates a file, or truncates an existing one, and writes the header.</summary>
    public static DataFile Create(string folder, string name, byte[] header)
    {
        // Opening the file fails if another process writes it. The file is then deleted and created again, so that other hard links keep their
        // content: it may be an input of another program.
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

    /// <summary>Opens a file to continue after the part that a record confirms. Later bytes are discarded.</summary>
    /// <exception cref="RefusedException">The file does not match the record.</exception>
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

    /// <summary>Returns the SHA-256 of a file, in hexadecimal digits.</summary>
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

    /// <summary>Waits until the content is on the disk.</summary>
    public void FlushToDisk() => _stream.Flush(flushToDisk: true);

    public void Dispose()
    {
        _stream.Dispose();
        _hash.Dispose();
    }

    /// <summary>Opens a file so that no other process can write it.</summary>
    private static FileStream Open(string folder, string name, FileMode mode) =>
        new(Path.Combine(folder, name), mode, FileAccess.ReadWrite, FileShare.None, bufferSize: 0);
}
