namespace FootballPhysics.Tool.Commands;

/// <summary>Thrown if the reader of the output has closed it. The run then ends without a message.</summary>
internal sealed class OutputClosedException(Exception inner) : Exception("The output was closed.", inner);
