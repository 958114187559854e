using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Web;

/// <summary>Gives every exception the one message that a user can act on.</summary>
internal static class Guard
{
    /// <summary>Calls a function.</summary>
    public static T Call<T>(Func<T> function)
    {
        try
        {
            return function();
        }
        catch (Exception e)
        {
            throw Plain(e);
        }
    }

    /// <summary>Calls a function without a result.</summary>
    public static void Call(Action function)
    {
        try
        {
            function();
        }
        catch (Exception e)
        {
            throw Plain(e);
        }
    }

    /// <summary>Returns an exception whose message is only the sentence.</summary>
    public static Exception Plain(Exception exception) => new InvalidOperationException(LibraryRefusal.Sentence(exception));
}
