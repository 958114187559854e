namespace FootballPhysics.Scenarios.Input;

/// <summary>The input is rejected. The message is one line for the user.</summary>
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
