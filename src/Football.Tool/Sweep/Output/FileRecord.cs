namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>A file of a data set, or its confirmed part.</summary>
/// <param name="Name">The name.</param>
/// <param name="Bytes">The length, in bytes.</param>
/// <param name="Header">The length of the header before the first row, in bytes.</param>
/// <param name="Sha256">The SHA-256 of the bytes, in hexadecimal digits.</param>
internal sealed record FileRecord(string Name, long Bytes, int Header, string Sha256);
