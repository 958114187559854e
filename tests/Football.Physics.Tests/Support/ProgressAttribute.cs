using System.Diagnostics;
using System.Globalization;
using System.Reflection;
using Xunit.v3;

[assembly: FootballPhysics.Tests.Progress]

namespace FootballPhysics.Tests;

/// <summary>Tells how many tests of an assembly are done, so that a run of minutes is no silence.</summary>
[AttributeUsage(AttributeTargets.Assembly)]
internal sealed class ProgressAttribute : BeforeAfterTestAttribute
{
    private const int Often = 250;

    private static readonly Stopwatch s_clock = Stopwatch.StartNew();
    private static int s_done;

    public override void After(MethodInfo methodUnderTest, IXunitTest test)
    {
        int done = Interlocked.Increment(ref s_done);
        if (done % Often == 0)
        {
            Xunit.TestContext.Current.SendDiagnosticMessage(string.Create(CultureInfo.InvariantCulture, $"{done} tests done in {s_clock.Elapsed.TotalSeconds:0} s"));
        }
    }
}
