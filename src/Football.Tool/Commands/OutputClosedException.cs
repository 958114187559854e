namespace FootballPhysics.Tool.Commands;

/// <summary>Nobody reads the output any more: the run ends at once, without a word.</summary>
internal sealed class OutputClosedException(Exception inner) : Exception("The output was closed.", inner);
