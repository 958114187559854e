using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Web;

/// <summary>Replaces every exception by one whose message the user can act on.</summary>
internal static class Guard
{
    /// <summary>Calls a function, and returns its result.</summary>
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

    /// <summary>Returns an exception whose message is only the sentence of the library.</summary>
    public static Exception Plain(Exception exception) => new InvalidOperationException(LibraryRefusal.Sentence(exception));
}
