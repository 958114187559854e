using System.Numerics;
using System.Reflection;
using FootballPhysics;
using FootballPhysics.Golden;

#if FOLLOW
// With --follow, the lines of the live filter.
if (args.Contains("--follow"))
{
    foreach (string line in GoldenFollow.Lines())
    {
        Console.WriteLine(line);
    }

    return;
}
#endif

// A shot, as a game would play it.
var ball = new Ball();
ball.Kick(speed: 27, direction: new Vector3(-0.1f, 0.3f, -1f), topSpin: -10, sideSpin: 55);
while (ball.Events.Count == 0)
{
    ball.Step(1.0 / 60.0);
}

BallEvent landing = ball.Events[0];
Console.Error.WriteLine(FormattableString.Invariant(
    $"landed after {landing.Time:F2} s, {-landing.Position.Z:F1} m away, {landing.Position.X:F1} m to the side"));
string target = typeof(Ball).Assembly.GetCustomAttribute<System.Runtime.Versioning.TargetFrameworkAttribute>()?.FrameworkName ?? "?";
Console.Error.WriteLine($"assembly for {target} on {System.Runtime.InteropServices.RuntimeInformation.FrameworkDescription}");

// With --states, each line has the path of its balls too. With --some, every fifth line, for slow machines.
foreach (string line in args.Contains("--states") ? GoldenTrace.Lines() : GoldenShots.Lines(args.Contains("--some") ? 5 : 1))
{
    Console.WriteLine(line);
}
