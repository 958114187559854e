namespace FootballPhysics.Native;

/// <summary>A byte of C that is no part of a text.</summary>
internal struct CByte
{
    /// <summary>Its value.</summary>
    public byte Value;
}
