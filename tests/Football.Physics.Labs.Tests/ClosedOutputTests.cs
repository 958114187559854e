
namespace FootballPhysics.Labs.Tests;

/// <summary>Whoever reads the output may go away, and whoever reads the hints may never have been there.</summary>
public sealed class ClosedOutputTests
{
    private const string Scenario = "{" + FootballCommand.Launch + "}";
    private const int BrokenPipe = 32;
    private const int DiskFull = 28;

    [Theory]
    [InlineData("sweep", "--count", "1000000000000")]
    [InlineData("simulate", "-", "--batch")]
    [InlineData("simulate", "-")]
    [InlineData("kick")]
    [InlineData("lab", "vacuum")]
    [InlineData("--help")]
    public void A_closed_output_ends_any_run_at_once_and_quietly(params string[] args)
    {
        FootballCommand done = FootballCommand.Run(new MemoryStream(Encoded(Scenario)), new FailingStream(BrokenPipe), redirected: true, args);
        Assert.Equal(141, done.ExitCode);
        Assert.DoesNotContain("football: ", done.Error);
    }

    [Fact]
    public void A_batch_whose_output_is_closed_reads_no_more_of_its_endless_input()
    {
        var input = new EndlessStream(Encoded(Scenario + "\n"));
        Assert.Equal(141, FootballCommand.Run(input, new FailingStream(BrokenPipe), redirected: true, "simulate", "-", "--batch").ExitCode);
    }

    [Fact]
    public void A_full_disk_is_told()
    {
        FootballCommand done = FootballCommand.Run(new MemoryStream(Encoded(Scenario)), new FailingStream(DiskFull), redirected: true, "simulate", "-");
        Assert.Equal((1, "football: It is full.\n"), (done.ExitCode, done.Error));
    }

    [Theory]
    [InlineData("football sweep --count 1000000000000 | head -n 1; echo ${PIPESTATUS[0]}", 2, "141\n")]
    [InlineData("yes '" + Scenario + "' 2>/dev/null | football simulate --batch - | head -n 1; echo ${PIPESTATUS[1]}", 2, "141\n")]
    [InlineData("echo '" + Scenario + "' | football simulate - >&-; echo $?", 1, "141\n")]
    [InlineData("echo garbage | football simulate - 2>&-; echo $?", 1, "1\n")]
    [InlineData("echo garbage | football simulate - 2>/dev/full; echo $?", 1, "1\n")]
    [InlineData("football simulate - <&- 2>&1; echo $?", 2, "football: the input is empty; allowed: a JSON object.\n1\n")]
    [InlineData("football simulate --batch - <&-; echo $?", 1, "0\n")]
    [InlineData("football sweep - <&- 2>&1; echo $?", 2, "football: the input is empty; allowed: a JSON object.\n1\n")]
    [InlineData("echo '" + Scenario + "' > one; football simulate one <&- >&-; echo $?", 1, "141\n")]
    [InlineData("football simulate /dev/null <&- 2>&-; echo $?", 1, "1\n")]
    [InlineData("football lab vacuum 2>/dev/full | tail -n 1; echo ${PIPESTATUS[0]}", 2, "0\n")]
    [InlineData("{ football kick; football kick --speed 5; } > both 2>/dev/null; wc -l < both", 1, "2\n")]
    public async Task A_shell_sees_the_same(string line, int lines, string ends)
    {
        Shell done = await Shell.RunAsync(line);
        Assert.Equal("", done.Error);
        Assert.EndsWith(ends, done.Output);
        Assert.Equal(lines, done.Output.Count(c => c == '\n'));
    }

    [Fact]
    public async Task An_input_without_end_is_read_no_further_than_it_may_go()
    {
        Shell one = await Shell.RunAsync("football simulate /dev/zero");
        Assert.Equal((1, "", "football: the input is too long; allowed: at most 1048576 bytes an object.\n"), (one.ExitCode, one.Output, one.Error));
        Shell batch = await Shell.RunAsync("(echo '" + Scenario + "'; cat /dev/zero) | football simulate - --batch");
        Assert.Equal(1, batch.ExitCode);
        Assert.StartsWith("{\"name\":null,\"final\"", batch.Output);
        Assert.StartsWith("football: the input is a line of more than 67108864 bytes", batch.Error);
    }

    private static byte[] Encoded(string text) => System.Text.Encoding.UTF8.GetBytes(text);

    /// <summary>Fails at the first byte.</summary>
    private sealed class FailingStream(int error) : MemoryStream
    {
        public override void Write(byte[] buffer, int offset, int count) => throw new IOException("It is full.", error);

        public override void Write(ReadOnlySpan<byte> buffer) => throw new IOException("It is full.", error);
    }

    /// <summary>The same bytes again and again.</summary>
    private sealed class EndlessStream(byte[] bytes) : MemoryStream
    {
        private int _at;

        public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

        public override int Read(Span<byte> buffer)
        {
            for (int i = 0; i < buffer.Length; i++)
            {
                buffer[i] = bytes[_at++ % bytes.Length];
            }

            return buffer.Length;
        }
    }
}
