// A game without a window. `shots` kicks a few shots, steps them at 60 Hz, prints their events and draws their paths; `gallery` draws the gallery of the tool.
using System.Globalization;
using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics;
using FootballPhysics.Headless;
using FootballPhysics.Tool;

const double Frame = 1.0 / 60.0;
const string Folder = "out/shots";
CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
switch (args)
{
    case ["gallery"]:
        return GalleryPages.Write("out/gallery");
    case ["shots"]:
        break;
    default:
        Console.Error.WriteLine("Usage: Football.Physics.Headless COMMAND");
        Console.Error.WriteLine("  gallery   Draw the sample shots of the tool into out/gallery");
        Console.Error.WriteLine($"  shots     Simulate a few shots, print their events, and draw them into {Folder}");
        return args.Length == 0 ? 0 : 2;
}

var drawings = new List<XElement>();

foreach (Shot shot in Shots.All())
{
    // The simulator is the compiled scene, and the state is the ball. Copy the state to save it; step the copy to look ahead.
    var simulator = new Simulator(shot.Scene);
    BallState ball = simulator.Launch(shot.From, shot.Velocity, shot.Spin);
    var log = new StepLog();
    var path = new List<Vector3d> { ball.Position };
    var marks = new List<BallEvent>();
    Console.WriteLine($"{shot.Name}: {shot.Velocity.Length:F0} m/s");

    while (ball.Motion != MotionState.Rest && ball.Time < 12)
    {
        log.Clear();
        simulator.Step(ref ball, Frame, log);
        path.Add(ball.Position);
        foreach (BallEvent happened in log.Events.Span)
        {
            string label = $"{happened.Kind} {simulator.NameOf(happened.ColliderIndex)}".TrimEnd();
            Console.WriteLine($"  {happened.Time,5:F2} s  {label,-20} {happened.Velocity.Length,5:F1} m/s at {happened.Position:F2}");
            marks.Add(happened);
        }
    }

    drawings.Add(Drawing.Of(shot.Name, path, marks));
}

Directory.CreateDirectory(Folder);
File.WriteAllText($"{Folder}/shots.svg", Svg.Standing("Shots", Figure.Stack("", drawings)).ToString());
Console.WriteLine($"Paths: {Folder}/shots.svg");
return 0;
