using System.Globalization;

namespace FootballPhysics.Passes;

/// <summary>The code that runs in a step. Each play is played twice: code that runs only in the first one initialises something.</summary>
/// <param name="detail">The names to print below each step: "--list" for files, "--methods" for bodies.</param>
internal sealed class StepTable(string? detail)
{
    public void Print()
    {
        var onGround = new Vector3d(0, 0.11, 0);
        var open = new Scene();
        Tell("flight", 0.5, open, new Vector3d(0, 2, 0), new Vector3d(20, 8, 3), new Vector3d(0, 40, -10));
        Tell("roll", 0.5, open, onGround, new Vector3d(4, 0, 0), new Vector3d(0, 0, -4 / 0.11));
        Tell("slide", 0.2, open, onGround, new Vector3d(12, 0, 0), default);
        Tell("bounce", 1.2, open, new Vector3d(0, 0.6, 0), new Vector3d(14, -3, 1), default);
        Tell("a whole kick", 12, open, onGround, new Vector3d(20, 6, 3), new Vector3d(0, 40, -10));

        // From the penalty spot of a standard pitch into a post, and into the net.
        Vector3d spot = new(0, 0.11, (Pitch.Standard.Length / 2) - 11);
        Tell("into a post", 1.2, Pitch.Standard.On(), spot, new Vector3d(8.2, 5.2, 24), default);
        Tell("into a net", 1.2, Pitch.Standard.On(), spot, new Vector3d(4, 5, 24), default);
    }

    private void Tell(string what, double seconds, Scene scene, Vector3d from, Vector3d velocity, Vector3d spin)
    {
        var simulator = new Simulator(scene);
        Busiest(simulator, seconds, from, velocity, spin);
        (Method[] ran, string[] calls, string counted, string met) = Busiest(simulator, seconds, from, velocity, spin);
        string[] files = [.. ran.Select(MarkedLibrary.PathOf).Distinct().Order(StringComparer.Ordinal)];
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what,-14} {files.Length,3} files, {counted}   {met}"));
        foreach (string name in detail == "--methods" ? calls : detail == "--list" ? files : [])
        {
            Console.WriteLine("    " + name);
        }
    }

    /// <summary>Returns the step of a play that runs the most lines.</summary>
    private static (Method[] Ran, string[] Calls, string Counted, string Met) Busiest(Simulator simulator, double seconds, Vector3d from, Vector3d velocity, Vector3d spin)
    {
        (Method[] Ran, string[] Calls, string Counted, string Met) most = ([], [], "", "");
        BallState ball = simulator.Launch(from, velocity, spin);
        var log = new StepLog();
        while (ball.Time < seconds && ball.Motion != MotionState.Rest)
        {
            double start = ball.Time;
            log.Clear();
            Array.Clear(MarkedLibrary.Passed);
            Array.Clear(MarkedLibrary.Counts);
            simulator.Step(ref ball, 0.01, log);
            int[] counts = MarkedLibrary.Counts;
            int[] passed = MarkedLibrary.Passed;
            int[] numbers = [.. Enumerable.Range(0, passed.Length).Where(i => passed[i] > 0)];
            Method[] ran = [.. numbers.Select(i => MarkedLibrary.Methods[i])];
            int lines = ran.Sum(method => method.Lines);
            if (lines > most.Ran.Sum(method => method.Lines))
            {
                most = (
                    ran,
                    [.. numbers.Select(i => MarkedLibrary.Methods[i]).Zip(numbers, (at, i) => $"{MarkedLibrary.PathOf(at)} {at.Name}: {at.Lines} lines, {passed[i]} calls")],
                    string.Create(CultureInfo.InvariantCulture, $"{ran.Length,3} methods, {lines,4} working lines, {counts[0],6} calls, {counts[1],5} changes of file, {counts[2],4} of folder"),
                    string.Create(CultureInfo.InvariantCulture, $"step from {start:0.00} s")
                        + string.Concat(log.Events.Span.ToArray().Select(happened => $", {happened.Kind} {simulator.NameOf(happened.ColliderIndex)}".TrimEnd())));
            }
        }

        return most;
    }
}
