namespace FootballPhysics.Scenarios.Input;

/// <summary>The input is refused. The message is one line for the user that names field, value and what is allowed.</summary>
public sealed class RefusedException : Exception
{
    public RefusedException(string message)
        : base(message)
    {
    }

    public RefusedException(string field, string value, string allowed)
        : base($"{Quote.Short(field)} is {value}; allowed: {allowed}.")
    {
    }
}
