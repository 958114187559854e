using System.Text;

namespace FootballPhysics.Tool.Tests;

/// <summary>A batch: one object a line, one result a line, in the same order.</summary>
public sealed class BatchTests
{
    private const string L = FootballCommand.Launch;

    [Theory]
    [InlineData("1")]
    [InlineData("2")]
    [InlineData("7")]
    public void Results_come_in_the_order_of_the_input_and_are_the_same_for_any_number_of_jobs(string jobs)
    {
        // Long runs first, so that later ones are done before them.
        var input = new StringBuilder();
        for (int i = 0; i < 300; i++)
        {
            int steps = i % 10 == 0 ? 20_000 : 10;
            input.Append(FormattableString.Invariant(
                $"{{\"name\":\"shot {i}\",\"scenario\":{{{L},\"forces\":{{\"drag\":\"{(i % 7 == 3 ? "bad" : "none")}\"}},\"stop\":{{\"at\":\"time\",\"time\":1}},\"solver\":{{\"timeStep\":{1.0 / steps}}}}}}}\n"));
        }

        FootballCommand done = FootballCommand.Simulate(input.ToString(), "--batch", "--jobs", jobs);
        Assert.Equal(1, done.ExitCode);
        Assert.Equal(Enumerable.Range(0, 300).Select(i => $"shot {i}"), done.Lines.Select(line => line.GetProperty("name").GetString()));
        Assert.All(done.Lines.Select((line, i) => (line, i)), item => Assert.Equal(item.i % 7 == 3, item.line.TryGetProperty("error", out _)));
        Assert.Equal(FootballCommand.Simulate(input.ToString(), "--batch", "--jobs", "3").Output, done.Output);
    }

    [Fact]
    public void A_bad_line_has_its_reason_in_its_place_and_the_others_come_out()
    {
        string[] lines =
        [
            $"{{{L}}}",
            "garbage",
            "",
            $"{{\"name\":\"light\",\"scenario\":{{{L},\"ball\":{{\"mass\":-1}}}}}}",
            "  \t ",
            $"{{\"name\":\"cut\",\"scenario\":{{{L}",
            $"{{\"name\":\"nan\",\"scenario\":{{{L},\"gravity\":NaN}}}}",
            $"{{\"name\":\"last\",\"scenario\":{{{L}}}}}",
        ];
        FootballCommand done = FootballCommand.Simulate(string.Join("\r\n", lines), "--batch");
        Assert.Equal(1, done.ExitCode);
        Assert.Equal([null, null, "light", "cut", "nan", "last"], done.Lines.Select(line => line.GetProperty("name").GetString()));
        Assert.Equal([false, true, true, true, true, false], done.Lines.Select(line => line.TryGetProperty("error", out _)));
        Assert.Equal("ball.mass is -1; allowed: 0.001 … 100.", done.Lines[2].GetProperty("error").GetString());
        Assert.StartsWith("gravity is NaN, which is not JSON (byte 86); allowed: ", done.Lines[4].GetProperty("error").GetString());
        Assert.Equal(2, done.Lines[1].EnumerateObject().Count());
        Assert.Contains("4 of 6 refused", done.ErrorLine);
    }

    [Fact]
    public void Nothing_in_nothing_out()
    {
        FootballCommand done = FootballCommand.Simulate("\n\n", "--batch");
        Assert.Equal((0, "", ""), (done.ExitCode, done.Output, done.Error));
    }

    [Fact]
    public void A_line_of_10_MB_is_refused_by_its_length_and_the_next_one_comes_out()
    {
        string big = $"{{\"name\":\"big\",\"scenario\":{{{L},\"padding\":\"{new string('x', 10 << 20)}\"}}}}";
        FootballCommand done = FootballCommand.Simulate($"{big}\n{new string(' ', 10 << 20)}{{{L}}}\n{{{L}}}\n", "--batch");
        Assert.Equal(1, done.ExitCode);
        Assert.Equal(3, done.Lines.Count);
        Assert.Equal("big", done.Lines[0].GetProperty("name").GetString());
        Assert.Equal("the input is too long; allowed: at most 1048576 bytes an object.", done.Lines[0].GetProperty("error").GetString());
        Assert.Contains("too long", done.Lines[1].GetProperty("error").GetString());
        Assert.True(done.Lines[2].TryGetProperty("final", out _));
    }

    [Fact]
    public void It_streams()
    {
        // The first answer is there while the input still waits for it to go on.
        using var answered = new ManualResetEventSlim();
        var output = new SignallingStream(answered);
        var input = new WaitingStream(Encoding.UTF8.GetBytes($"{{{L}}}\n"), answered);
        Assert.Equal(0, FootballCommand.Run(input, output, redirected: true, "simulate", "-", "--batch").ExitCode);
        Assert.True(input.WasAnswered);
    }

    /// <summary>Gives its bytes, then ends only when something has been answered, or after long enough to say that nothing will be.</summary>
    private sealed class WaitingStream(byte[] bytes, ManualResetEventSlim answered) : Stream
    {
        private readonly MemoryStream _inner = new(bytes);

        public bool WasAnswered { get; private set; }

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] buffer, int offset, int count)
        {
            int read = _inner.Read(buffer, offset, count);
            if (read == 0)
            {
                WasAnswered = answered.Wait(TimeSpan.FromSeconds(20));
            }

            return read;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        protected override void Dispose(bool disposing)
        {
            _inner.Dispose();
            base.Dispose(disposing);
        }
    }

    /// <summary>Tells when something is written.</summary>
    private sealed class SignallingStream(ManualResetEventSlim written) : MemoryStream
    {
        public override void Write(byte[] buffer, int offset, int count)
        {
            base.Write(buffer, offset, count);
            written.Set();
        }
    }
}
