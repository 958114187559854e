using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Interceptions and the probability of a goal.</content>
internal static unsafe partial class Exports
{
    /// <summary>Sets a player to a fit adult at the origin: reaction 0.2 s, acceleration 6 m/s^2, speed 8 m/s, reach 0.6 m, heights 0 ... 2.3 m.</summary>
    /// <param name="player">Receives the player.</param>
    /// <returns>FP_OK or FP_ARGUMENT.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_player_default")]
    public static NativeStatus PlayerDefault(NativePlayer* player)
    {
        try
        {
            Guard.Given(player, "player");
            var from = new Player();
            Put(from.Position, player->Position);
            Put(from.Velocity, player->Velocity);
            player->Reaction = from.Reaction;
            player->Acceleration = from.Acceleration;
            player->Speed = from.Speed;
            player->Reach = from.Reach;
            player->MinimumHeight = from.MinimumHeight;
            player->MaximumHeight = from.MaximumHeight;
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Finds the player who reaches the ball first. If two players arrive within a nanosecond, returns the lower index.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball; unchanged. Its path is predicted until it rests; it then stays at rest.</param>
    /// <param name="seconds">The length of the prediction, s; above 0, at most 3600.</param>
    /// <param name="players">The players at the current time.</param>
    /// <param name="n">The number of players; 0 ... 10 000.</param>
    /// <param name="out">Receives the first player.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_intercept")]
    public static NativeStatus Intercept([In] NativeScene* scene, [In] NativeState* state, double seconds, [In] NativePlayer* players, int n, NativeInterception* @out)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            BallState ball = Guard.State(state, compiled);
            Guard.Players(players, n, seconds);
            Guard.Given(@out, "out");
            Interceptor search = compiled.TakeInterceptor();
            int first = search.FindFirst(in ball, seconds, players, n, out PathPoint at);
            *@out = default;
            @out->Player = first;
            if (first >= 0)
            {
                @out->Time = at.Time;
                @out->Margin = search.Interception.TimeMargin;
                Put(at.Position, @out->Position);
                Put(at.Velocity, @out->Velocity);
            }

            compiled.GiveBack(search);
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Finds all time intervals in which each player can reach the ball.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball, as for fp_intercept.</param>
    /// <param name="seconds">The length of the prediction, s; above 0, at most 3600.</param>
    /// <param name="players">The players at the current time.</param>
    /// <param name="n">The number of players; 0 ... 10 000.</param>
    /// <param name="windows">Receives the intervals, sorted by player, then by time; null if capacity is 0.</param>
    /// <param name="capacity">The number of intervals that fit, 0 or more.</param>
    /// <param name="count">Receives the number of intervals, including those that do not fit; null to skip it.</param>
    /// <returns>FP_OK; FP_BUFFER if there are more intervals than capacity (the first ones are written); FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_intercept_windows")]
    public static NativeStatus InterceptWindows(
        [In] NativeScene* scene, [In] NativeState* state, double seconds, [In] NativePlayer* players, int n, NativeWindow* windows, int capacity, int* count)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            BallState ball = Guard.State(state, compiled);
            Guard.Players(players, n, seconds);
            Guard.Room(windows, "windows", capacity);
            Interceptor search = compiled.TakeInterceptor();
            ReadOnlySpan<InterceptWindow> found = search.FindWindows(in ball, seconds, players, n);
            int all = found.Length;
            for (int i = 0; i < Math.Min(capacity, all); i++)
            {
                NativeWindow* to = windows + i;
                to->Player = found[i].Player;
                to->Reserved = 0;
                to->From = found[i].From;
                to->To = found[i].To;
                Put(found[i].Position, to->Position);
                Put(found[i].Velocity, to->Velocity);
            }

            compiled.GiveBack(search);
            return Counted(all, capacity, count, "intervals");
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Computes the probability that a player's kick scores: by derivatives if they are accurate, otherwise by simulating random kicks.</summary>
    /// <param name="scene">The scene. Its solver settings are not used.</param>
    /// <param name="requestJson">
    /// An object in UTF-8: position, velocity, spin; orientation, a quaternion x, y, z, w, on which only the knuckle force depends; spread with speedPercent,
    /// elevationDegrees, azimuthDegrees, spinPercent and their correlations; goal, the index of a goal of the scene; keeper, a player; kicks, the number of kicks to
    /// simulate, 2 ... 100 000 000, 2 to 6 microseconds each; seed; alwaysSimulate. Only position and velocity are required.
    /// </param>
    /// <param name="bytes">Its length in bytes; at most 1 048 576.</param>
    /// <param name="out">Receives the result.</param>
    /// <returns>FP_OK; FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_goal_chance")]
    public static NativeStatus GoalChance([In] NativeScene* scene, [In] byte* requestJson, long bytes, NativeGoalChanceResult* @out) =>
        FindChance(scene, requestJson, bytes, @out, null);

    /// <summary>The same as fp_goal_chance, with progress and cancellation.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="requestJson">The request, as for fp_goal_chance.</param>
    /// <param name="bytes">Its length in bytes.</param>
    /// <param name="out">Receives the result.</param>
    /// <param name="watch">Shows the progress, and cancels the call; null for neither.</param>
    /// <returns>As fp_goal_chance; FP_CANCELLED if watch cancelled the call.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_goal_chance_watched")]
    public static NativeStatus GoalChanceWatched([In] NativeScene* scene, [In] byte* requestJson, long bytes, NativeGoalChanceResult* @out, NativeWatch* watch) =>
        FindChance(scene, requestJson, bytes, @out, watch);

    private static NativeStatus FindChance(NativeScene* scene, byte* requestJson, long bytes, NativeGoalChanceResult* @out, NativeWatch* watch)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(@out, "out");
            using var watched = Watch.Of(watch);
            GoalChanceResult found = Requests.GoalChance(compiled, Requests.Text(requestJson, bytes, "request_json"), watched, watched?.Token ?? default);
            *@out = new NativeGoalChanceResult
            {
                Scores = found.Scores,
                OnTarget = found.OnTarget,
                Covered = found.Covered,
                StandardError = found.StandardError,
                Crosses = found.Crosses,
                Aside = found.Aside,
                Height = found.Height,
                Time = found.Time,
                AsideDeviation = found.AsideDeviation,
                HeightDeviation = found.HeightDeviation,
                Correlation = found.Correlation,
                Method = (int)found.Method,
                Kicks = found.Kicks,
            };
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes the number of items. Returns FP_BUFFER if they exceed the capacity.</summary>
    private static NativeStatus Counted(int all, long capacity, int* count, string items)
    {
        if (count is not null)
        {
            *count = all;
        }

        return all <= capacity
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Buffer, string.Create(CultureInfo.InvariantCulture, $"capacity is {capacity}; there are {all} {items}."));
    }
}
