// A game without a window: kicks a few shots, steps them at 60 Hz, prints what happens, and draws their paths; then the gallery of the tool.
using System.Globalization;
using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics;
using FootballPhysics.Headless;
using FootballPhysics.Tool;

const double Frame = 1.0 / 60.0;
const string Folder = "out/shots";
CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
var drawings = new List<XElement>();

foreach (Shot shot in Shots.All())
{
    // The simulator is the compiled scene, the state is the ball: copy it to save it, step the copy to look ahead.
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
            string what = $"{happened.Kind} {simulator.NameOf(happened.ColliderIndex)}".TrimEnd();
            Console.WriteLine($"  {happened.Time,5:F2} s  {what,-20} {happened.Velocity.Length,5:F1} m/s at {happened.Position:F2}");
            marks.Add(happened);
        }
    }

    drawings.Add(Drawing.Of(shot.Name, path, marks));
}

Directory.CreateDirectory(Folder);
File.WriteAllText($"{Folder}/shots.svg", Svg.Standing("Shots", Figure.Stack("", drawings)).ToString());
Console.WriteLine($"Paths: {Folder}/shots.svg");
Console.WriteLine();

return GalleryPages.Write("out/gallery");
