using System.Text;
using System.Text.Json;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tool.Tests;

/// <summary>Whatever is made of a scenario, its line is answered and the batch goes on.</summary>
public sealed class MutatedInputTests
{
    private static readonly string[] s_simulate =
    [
        "{\"launch\":{\"position\":[0,0.11,0],\"velocity\":[12,5,1],\"spin\":[3,30,-40]}}",
        "{\"name\":\"wrapped\",\"scenario\":{\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0]},\"samples\":true},\"expected\":{\"time\":0.4}}",
        "{\"ball\":{\"mass\":0.43,\"radius\":0.11},\"air\":{\"wind\":[1,0,-2]},\"gravity\":9.81,\"forces\":{\"drag\":\"constant\",\"buoyancy\":true},\"launch\":{\"position\":[0,2,0],\"velocity\":[9,1,0],\"orientation\":[0,0,0,1]}}",
        "{\"ground\":{\"tangentialRestitution\":[0.5,0.5],\"height\":0,\"aerodynamics\":\"none\"},\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0]},\"solver\":{\"integrator\":\"rk2\",\"timeStep\":0.02},\"stop\":{\"at\":\"rest\",\"time\":3}}",
    ];

    private static readonly string[] s_aim =
    [
        "{\"aim\":{\"from\":[0,0.11,0],\"target\":[20,1.5,3],\"speed\":25,\"spin\":{\"top\":20,\"side\":10},\"elevation\":{\"min\":0,\"max\":30}}}",
        "{\"name\":\"two\",\"scenario\":{\"aim\":{\"method\":\"direct\",\"from\":[0,0.11,0],\"target\":[25,1.9,3],\"through\":[9.15,2.4,1.6],\"speed\":27,\"maxSpin\":{\"top\":60,\"side\":60},\"maxIterations\":20}}}",
    ];

    private static readonly string[] s_pieces =
    [
        ",", ":", "{", "}", "[", "]", "{}", "[]", "{},", "\"", "\\", "\\ud800", "\\u0000", "null", "true", "NaN", "-Infinity", "1e999", "-1e999", "1e-320", "-0", "0x1", "01", "1.", ".5", "--", "+",
        "\"x\":1,", "\"launch\":{},", "\"name\":7,", "\"name\":\"n\",", "\"scenario\":{},", "/* */", "// ", "\u00e9", "\u2028", "\0", "\t", "\r", "9", "-", "e", "1e6", "\"rk4\"", "[[[[[[[[",
    ];

    private static readonly string[] s_numbers = ["0", "1", "7", "42", "1e3", "3.5e-2", "123456"];

    [Theory]
    [InlineData("simulate", 2000, 1)]
    [InlineData("aim", 300, 2)]
    public void Every_line_is_answered_and_nothing_is_thrown(string command, int count, int seed)
    {
        var random = new SeededRandom(seed);
        string[] origins = command == "aim" ? s_aim : s_simulate;
        byte[][] lines = [.. Enumerable.Range(0, count).Select(_ => Mutated(random, origins))];
        byte[] input = [.. lines.SelectMany(line => (byte[])[.. line, (byte)'\n'])];

        // The steps are bounded, so that no number can make a line long to answer.
        FootballCommand done = FootballCommand.Run(input, command, "-", "--batch", "--jobs", "2", "--set", "solver.timeStep=0.02", "--set", "stop.time=2");
        Assert.Equal(count, done.Lines.Count);
        int refused = 0;
        foreach ((JsonElement answer, byte[] line) in done.Lines.Zip(lines))
        {
            bool isRefused = answer.TryGetProperty("error", out JsonElement error);
            refused += isRefused ? 1 : 0;
            Assert.True(isRefused || answer.TryGetProperty(command == "aim" ? "status" : "final", out _), Encoding.UTF8.GetString(line));
            string message = isRefused ? error.GetString()! : "allowed";
            Assert.True(message.Contains("allowed") && !message.Contains("internal error") && !message.Contains('\n'), $"{Encoding.UTF8.GetString(line)}\n{message}");
        }

        // Neither all nor none: some mutations leave a scenario.
        Assert.InRange(refused, count / 2, count - 10);
        Assert.Equal(1, done.ExitCode);
        Assert.StartsWith($"football: {refused} of {count} refused", done.ErrorLine);
    }

    [Theory]
    [InlineData("{}")]
    [InlineData("{\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0]}}")]
    [InlineData("[1]")]
    [InlineData("\"x\"")]
    [InlineData("12")]
    [InlineData("true")]
    [InlineData("null")]
    public void A_complete_value_followed_by_a_separator_is_refused_and_the_next_line_answered(string value)
    {
        foreach (string after in (string[])[",", ":", " ,", ",,", ":\t", ",}"])
        {
            FootballCommand done = FootballCommand.Simulate($"{value}{after}\n{{{FootballCommand.Launch}}}\n", "--batch");
            Assert.Equal([true, false], done.Lines.Select(line => line.TryGetProperty("error", out _)));
            Assert.Contains("allowed: ", done.Lines[0].GetProperty("error").GetString());
        }
    }

    private static byte[] Mutated(SeededRandom random, string[] origins)
    {
        List<byte> line = [.. Encoding.UTF8.GetBytes(random.Any<string>(origins))];
        for (int i = random.Below(3); i >= 0; i--)
        {
            int at = random.Below(line.Count + 1);
            int length = Math.Min(line.Count - at, 1 + random.Below(8));
            switch (random.Below(7))
            {
                case 0:
                    line.RemoveRange(at, length);
                    break;
                case 1:
                    line.InsertRange(at, Encoding.UTF8.GetBytes(random.Any<string>(s_pieces)));
                    break;
                case 2:
                    line.InsertRange(at, line.GetRange(at, length));
                    break;
                case 3:
                    line[Math.Min(at, line.Count - 1)] = (byte)random.Below(256);
                    break;
                case 4:
                    Replace(line, random, '0', '9', s_pieces);
                    break;
                case 5:
                    Replace(line, random, '0', '9', s_numbers);
                    break;
                default:
                    Replace(line, random, '"', '"', s_pieces);
                    break;
            }

            if (line.Count == 0)
            {
                line.Add((byte)'x');
            }
        }

        // One line, and not a blank one.
        return [(byte)(random.Chance(0.02) ? 'x' : ' '), .. line.Select(b => b == '\n' ? (byte)' ' : b), .. line.TrueForAll(b => b is 32 or 9 or 10 or 13) ? "0"u8 : ""u8];
    }

    /// <summary>Puts a piece in the place of a byte between two others: a digit, a quotation mark.</summary>
    private static void Replace(List<byte> line, SeededRandom random, char from, char to, string[] pieces)
    {
        int[] places = [.. Enumerable.Range(0, line.Count).Where(i => line[i] >= from && line[i] <= to)];
        if (places.Length > 0)
        {
            int at = places[random.Below(places.Length)];
            line.RemoveAt(at);
            line.InsertRange(at, Encoding.UTF8.GetBytes(random.Any<string>(pieces)));
        }
    }
}
