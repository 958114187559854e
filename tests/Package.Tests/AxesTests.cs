using System.Globalization;
using System.Text.RegularExpressions;
using FootballPhysics.Engines;

namespace FootballPhysics.Package.Tests;

/// <summary>The table of axes in concepts.md, followed to the letter: one kick flies through each row, and <see cref="EngineFrame"/> agrees with it.</summary>
public sealed partial class AxesTests
{
    private const double Sideways = 3.43;

    /// <summary>The engines: forwards, to the left and up in their axes, and their handedness.</summary>
    private static readonly (string Engines, EngineFrame Frame, Vector3d Forward, Vector3d Left, Vector3d Up, bool IsLeftHanded)[] s_frames =
    [
        ("Godot, MonoGame, Stride, glTF", EngineFrame.RightHanded, new(0, 0, -1), new(-1, 0, 0), new(0, 1, 0), false),
        ("Unity", EngineFrame.LeftHanded, new(0, 0, 1), new(-1, 0, 0), new(0, 1, 0), true),
        ("Blender, MuJoCo, ROS, Source 2", EngineFrame.ZUpRightHanded, new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), false),
        ("Unreal", EngineFrame.ZUpLeftHanded, new(1, 0, 0), new(0, -1, 0), new(0, 0, 1), true),
    ];

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void A_kick_through_a_row_bends_to_the_left(int number)
    {
        (string engines, EngineFrame frame, Vector3d forward, Vector3d left, Vector3d up, bool mirrored) = s_frames[number];
        string[] row = [.. File.ReadLines(Path.Combine(Repository.Root, "docs", "concepts.md")).First(line => line.StartsWith($"| {engines} |", StringComparison.Ordinal)).Split('|').Select(cell => cell.Trim())];
        Assert.Contains(mirrored ? "left-handed" : "right-handed", row[2], StringComparison.Ordinal);
        Assert.Contains(up.Z == 1 ? "z up" : "y up", row[2], StringComparison.Ordinal);

        // Seen from above, the ball turns anticlockwise: about the upward axis, in the sense of the engine's hand.
        Vector3d velocity = (25 * forward) + (8 * up);
        Vector3d spin = (mirrored ? -60 : 60) * up;
        var ball = new Ball();
        ball.Kick(Cell(row[4], velocity), Cell(row[5], spin));
        for (int i = 0; i < 60; i++)
        {
            ball.Step(1 / 60.0);
        }

        // The engine's directions, converted by the same cell, measure the path.
        Assert.Equal(Sideways, Vector3d.Dot(ball.Position, Cell(row[4], left)), 0.01);
        Assert.True(Vector3d.Dot(ball.Position, Cell(row[4], forward)) > 15);
        Assert.Equal(Cell(row[4], velocity), frame.Vector(velocity));
        Assert.Equal(Cell(row[5], spin), frame.Spin(spin));
        Assert.Equal(ball.Position, frame.Vector(frame.VectorToEngine(ball.Position)));
        Assert.Equal(ball.Spin, frame.Spin(frame.SpinToEngine(ball.Spin)));

        // A point that the engine turns is the point that the library turns.
        Quaterniond turn = Quaterniond.FromRotationVector(new Vector3d(0.3, -0.8, 0.5));
        var point = new Vector3d(1, 2, 3);
        Quaterniond converted = frame.Rotation(turn);
        Assert.Equal(0, Vector3d.Distance(converted.Rotate(frame.Vector(point)), frame.Vector(turn.Rotate(point))), 1e-12);
        Vector3d axis = Cell(row[6].Replace(", w)", ")", StringComparison.Ordinal), new Vector3d(turn.X, turn.Y, turn.Z));
        Assert.Equal(new Quaterniond(axis.X, axis.Y, axis.Z, turn.W), converted);
        Assert.Equal(turn, frame.RotationToEngine(converted));
        Assert.Equal(EngineFrameName(number), row[3].Trim('`'));
    }

    private static string EngineFrameName(int number) => number switch
    {
        0 => nameof(EngineFrame.RightHanded),
        1 => nameof(EngineFrame.LeftHanded),
        2 => nameof(EngineFrame.ZUpRightHanded),
        _ => nameof(EngineFrame.ZUpLeftHanded),
    };

    /// <summary>Applies a cell such as (x, z, −y) to a vector.</summary>
    private static Vector3d Cell(string cell, Vector3d vector)
    {
        Match match = Triple().Match(cell);
        Assert.True(match.Success, cell);
        double Of(int group)
        {
            string term = match.Groups[group].Value;
            double value = term[^1] switch
            {
                'x' => vector.X,
                'y' => vector.Y,
                _ => vector.Z,
            };
            return term.Length > 1 ? 0.0 - value : value;
        }

        return new Vector3d(Of(1), Of(2), Of(3));
    }

    [GeneratedRegex(@"^\((−?[xyz]), (−?[xyz]), (−?[xyz])\)$")]
    private static partial Regex Triple();
}
