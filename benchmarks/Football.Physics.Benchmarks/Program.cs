using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Running;

namespace FootballPhysics.Benchmarks;

internal static class Program
{
    private static int Main(string[] args)
    {
        if (args is ["quick", ..])
        {
            return QuickCommand.Run(args[1..]);
        }

        if (args is ["paired", ..])
        {
            return PairedCommand.Run(args[1..]);
        }

        IConfig config = DefaultConfig.Instance.AddColumn(new ErrorColumn());
        BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args, config);
        return 0;
    }
}
