namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>A file of a data set, or its finished part.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="Header">How many of the bytes come before the first row.</param>
/// <param name="Sha256">Their SHA-256, in hexadecimal digits.</param>
internal sealed record FileRecord(string Name, long Bytes, int Header, string Sha256);
