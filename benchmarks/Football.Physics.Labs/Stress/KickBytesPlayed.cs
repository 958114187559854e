using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Stress;

/// <summary>Changed kick logs: an accepted log is simulated in a scene with nets. Kicks for balls that the match lacks are rejected when due.</summary>
internal sealed class KickBytesPlayed : FuzzTarget
{
    private const double Tick = 1 / 60.0;
    private const int MostTicks = 8;
    private readonly KickLogFuzz _logs = new();

    public override string Name => "kick logs";

    public override byte[] Make(SeededRandom random, int mutations) => _logs.Make(random, mutations);

    public override bool Try(byte[] input)
    {
        if (_logs.Try(input))
        {
            return true;
        }

        KickLog log = KickLog.FromBytes(input);
        Simulator simulator = HallScenes.All[log.Count % HallScenes.All.Count];
        var runner = new FixedStepRunner(simulator, Tick);
        for (int i = 0; i < log.Count; i++)
        {
            KickInput kick = log[i];
            int before = runner.Kicks.Count;
            try
            {
                runner.Kicks.Add(new KickInput(i, kick.Velocity, kick.Spin, kick.Player, kick.Ball));
                Must(kick.Ball == 0, "a kick for a ball that the match lacks is accepted");
            }
            catch (ArgumentOutOfRangeException)
            {
                Must(kick.Ball != 0 && runner.Kicks.Count == before, "a kick is rejected, or changes the log all the same");
            }
        }

        for (int i = Math.Min(log.Count, MostTicks); i >= 0; i--)
        {
            runner.Step();
            BallState state = runner.State;
            MustBeShort(simulator, ref state, Tick);
        }

        return false;
    }
}
