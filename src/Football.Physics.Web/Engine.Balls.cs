using System.Runtime.InteropServices.JavaScript;

namespace FootballPhysics.Web;

/// <content>The functions for balls.</content>
internal static partial class Engine
{
    [JSExport]
    internal static int CreateBall(int scene) => Guard.Call(() => s_balls.Add(new WebBall(s_scenes[scene])));

    [JSExport]
    internal static void FreeBall(int ball) => s_balls.Remove(ball);

    /// <summary>Returns the address of the numbers of a ball; see <see cref="WebBall.Memory"/>.</summary>
    [JSExport]
    internal static int BallMemory(int ball) => Guard.Call(() => s_balls[ball].Memory);

    [JSExport]
    internal static void Place(int ball, double x, double y, double z) => Guard.Call(() => s_balls[ball].Change(b => b.Place(new Vector3d(x, y, z))));

    [JSExport]
    internal static void Launch(int ball, double x, double y, double z, double vx, double vy, double vz, double sx, double sy, double sz) => Guard.Call(
        () => s_balls[ball].Change(b => b.Launch(new Vector3d(x, y, z), new Vector3d(vx, vy, vz), new Vector3d(sx, sy, sz))));

    /// <summary>Places a ball with a motion and an orientation; its clock continues.</summary>
    [JSExport]
    internal static void Restart(int ball, double[] numbers) => Guard.Call(() => s_balls[ball].Restart(numbers));

    [JSExport]
    internal static void Kick(int ball, double vx, double vy, double vz, double sx, double sy, double sz) => Guard.Call(
        () => s_balls[ball].Change(b => b.Kick(new Vector3d(vx, vy, vz), new Vector3d(sx, sy, sz))));

    /// <summary>Places the bodies of the scene, steps the ball, and writes its numbers and events.</summary>
    [JSExport]
    internal static void Step(int ball, double dt)
    {
        // No closure, which would allocate: a frame makes only this call.
        try
        {
            s_balls[ball].Step(dt);
        }
        catch (Exception e)
        {
            throw Guard.Plain(e);
        }
    }

    /// <summary>Predicts the path of a ball, and returns the address of its rows: t, x, y, z.</summary>
    [JSExport]
    internal static int LookAhead(int ball, double seconds, int samples, double timeStep, string stopAt) => Guard.Call(() => s_balls[ball].LookAhead(seconds, samples, timeStep, stopAt));

    /// <summary>Returns the end of the last prediction, in s.</summary>
    [JSExport]
    internal static double LookAheadEnd(int ball) => Guard.Call(() => s_balls[ball].Ahead.EndTime);

    /// <summary>Returns the outputs of an impact of the last step.</summary>
    [JSExport]
    internal static double[] Impact(int ball, int index) => Guard.Call(() => s_balls[ball].Impact(index));

    /// <summary>Returns the sound of an impact of the last step: loudness, brightness, brush, and the samples of its wave.</summary>
    [JSExport]
    internal static double[] ImpactSound(int ball, int index, int rate) => Guard.Call(() => s_balls[ball].Sound(index, rate));

    /// <summary>Returns the squash of the drawn ball: the scales along and across its axis, and the axis.</summary>
    [JSExport]
    internal static double[] Squash(int ball) => Guard.Call(() => s_balls[ball].Squash());

    /// <summary>Returns the forces with which the next step begins; empty if it begins with impulses.</summary>
    [JSExport]
    internal static double[] Forces(int ball, double dt) => Guard.Call(() => s_balls[ball].Forces(dt));

    /// <summary>Returns the number of events of the last prediction, and their address.</summary>
    [JSExport]
    internal static int[] LookAheadEvents(int ball) => Guard.Call(() => s_balls[ball].LookAheadEvents());

    /// <summary>Computes, as JSON, whether a goalkeeper saves the ball on the last predicted path.</summary>
    [JSExport]
    internal static string Keeper(int ball, string player, int goal) => Guard.Call(() => s_balls[ball].Keeper(System.Text.Encoding.UTF8.GetBytes(player), goal));

    /// <summary>Returns the bulges of the nets: depth, position and direction of each.</summary>
    [JSExport]
    internal static double[] Bulges(int ball) => Guard.Call(() => s_balls[ball].Bulges());

    /// <summary>Returns the hash of the state, as 16 hexadecimal digits.</summary>
    [JSExport]
    internal static string Hash(int ball) => Guard.Call(() => Snapshot.Hash(s_balls[ball].Ball.State).ToString("x16", System.Globalization.CultureInfo.InvariantCulture));

    /// <summary>Returns the state as bytes.</summary>
    [JSExport]
    internal static byte[] Save(int ball) => Guard.Call(() =>
    {
        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(s_balls[ball].Ball.State, bytes);
        return bytes;
    });

    /// <summary>Restores a state from its bytes.</summary>
    [JSExport]
    internal static void Restore(int ball, byte[] bytes) => Guard.Call(() => s_balls[ball].Change(b => b.State = Snapshot.Read(bytes)));

    /// <summary>Returns the position, velocity, spin and orientation of a body.</summary>
    [JSExport]
    internal static double[] Body(int scene, int body) => Guard.Call(() => s_scenes[scene].Body(body));
}
