
namespace FootballPhysics.Labs.Following;

/// <summary>Random calls of a filter, most of them bad: each must be rejected with nothing changed, or leave a finite estimate.</summary>
internal static class FollowHostile
{
    public static LabCounts Run(LabRun run, int calls) => LabCounts.Of(calls, 20_000, (counts, part, count) => Play(counts, run.Random(5_000_000 + part), count));

    private static void Play(LabCounts counts, SeededRandom random, int calls)
    {
        var filter = new BallFilter();
        var path = new Trajectory();
        TrackCamera camera = TrackCamera.LookingAt(new Vector3d(0, 10, 40), Vector3d.Zero, 1500, 1920, 1080);
        double now = 0;
        byte[] saved = [];
        for (int i = 0; i < calls; i++)
        {
            counts.Add("calls");
            byte[]? before = random.Chance(0.02) ? filter.Save() : null;
            try
            {
                Call();
            }
            catch (Exception e) when (e is ArgumentException or InvalidOperationException)
            {
                counts.Add("rejected");
                counts.Require(e.Message.Length > 10, "without a message", $"{e.GetType().Name}");
                if (before is not null)
                {
                    counts.Require(before.AsSpan().SequenceEqual(filter.Save()), "changed by a rejected call", $"{e.Message}");
                }
            }

            catch (Exception e)
            {
                counts.Require(false, "other exceptions", $"{e.GetType().Name} {e.StackTrace?.Replace('\n', ' ')}");
                filter = new BallFilter();
            }

            BallState state = filter.Estimate.State;
            bool isSound = !filter.HasEstimate || (state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite && double.IsFinite(filter.Estimate.PositionDeviation)
                && double.IsFinite(filter.Estimate.VelocityDeviation) && double.IsFinite(filter.Estimate.SpinDeviation) && filter.Estimate.KickProbability is >= 0 and <= 1);
            counts.Require(isSound, "not finite", $"{state.Position} {state.Velocity} {filter.Estimate.VelocityDeviation}");
        }

        double Odd(double fair) => random.Below(12) switch
        {
            0 => double.NaN,
            1 => double.PositiveInfinity,
            2 => -1e300,
            3 => double.Epsilon,
            4 => -fair,
            _ => fair,
        };

        void Call()
        {
            switch (random.Below(10))
            {
                case < 5:
                    now += random.Chance(0.02) ? random.Uniform(-10, 50) : random.Uniform(0, 0.05);
                    filter.Update(Odd(now), new Vector3d(Odd(random.Uniform(-50, 50)), random.Uniform(-5, 20), random.Uniform(-30, 30)), random.Chance(0.2) ? Odd(random.Log(1e-9, 1e3)) : null);
                    break;
                case 5:
                    filter.Update(now, Odd(random.Uniform(-50, 50)), random.Uniform(-30, 30), random.Chance(0.5) ? 0 : null);
                    break;
                case 6:
                    filter.Update(now + 0.01, camera, Odd(random.Uniform(-2000, 4000)), random.Uniform(-2000, 4000));
                    break;
                case 7:
                    if (random.Chance(0.5))
                    {
                        filter.LookAhead(Odd(random.Log(1e-9, 2)), path);
                    }
                    else
                    {
                        filter.DeviationAt(Odd(path.EndTime));
                    }

                    break;
                case 8:
                    if (random.Chance(0.1))
                    {
                        saved = filter.Save();
                    }

                    byte[] bytes = [.. saved];
                    if (bytes.Length > 0 && random.Chance(0.9))
                    {
                        bytes[random.Below(bytes.Length)] ^= (byte)random.Below(256);
                    }

                    filter.Restore(bytes);
                    now = filter.HasEstimate ? filter.Estimate.State.Time : now;
                    break;
                default:
                    byte[] noise = new byte[random.Below(200)];
                    for (int i = 0; i < noise.Length; i++)
                    {
                        noise[i] = (byte)random.Below(256);
                    }

                    filter.Restore(noise);
                    break;
            }
        }
    }
}
