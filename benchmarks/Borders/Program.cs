using System.Diagnostics;
using System.Globalization;
using FootballPhysics;

// The kick, the steps and the rounds of cost.c.
const int Steps = 100;
const int Rounds = 40_000;
var simulator = new Simulator();
var log = new StepLog();
BallState kick = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(3, 9, -24), new Vector3d(0, 40, 0));
double least = double.PositiveInfinity;
for (int round = 0; round < Rounds; round++)
{
    least = Math.Min(least, Fly());
}

Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| C#, `Simulator.Step` | {least:0.0} |"));

double Fly()
{
    BallState state = kick;
    long start = Stopwatch.GetTimestamp();
    for (int i = 0; i < Steps; i++)
    {
        log.Clear();
        simulator.Step(ref state, 0.01, log);
    }

    return 1e9 * Stopwatch.GetElapsedTime(start).TotalSeconds / Steps;
}
