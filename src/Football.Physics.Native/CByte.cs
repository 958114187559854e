namespace FootballPhysics.Native;

/// <summary>A byte of C that is not part of a text.</summary>
internal struct CByte
{
    /// <summary>The value, 0 ... 255.</summary>
    public byte Value;
}
