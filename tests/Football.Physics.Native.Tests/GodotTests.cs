using System.Globalization;
using System.Text;
using FootballPhysics.Package.Tests;

namespace FootballPhysics.Native.Tests;

/// <summary>The kicks of tests/Native/godot_host.c, in C#: they give the lines of tests/Native/godot.txt, which tests/native.sh compares with the extension for Godot.</summary>
public sealed class GodotTests
{
    private const string Goal =
        """{"goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}], "zones": [{"name": "area", "shape": "box", "center": [0, 2, -14], "halfSize": [9, 3, 2]}]}""";

    private const string Shelf = """{"obstacles": [{"name": "shelf", "shape": "box", "center": [0, 0.5, 0], "halfSize": [1, 0.5, 1]}]}""";

    [Fact]
    public void The_extension_for_Godot_prints_the_hashes_and_events_of_CSharp()
    {
        var kick = new Play("{}");
        kick.Kick(new Vector3d(3, 8, -22), new Vector3d(0, 40, 0), 120, 60);
        var fine = new Play("{}");
        fine.Kick(new Vector3d(3, 8, -22), new Vector3d(0, 40, 0), 960, 480);
        Vector3d direction = new(0.25, 0.25, -1), unit = direction / direction.Length;
        var spun = new Play("{}");
        spun.Kick(27 * unit, KickVectors.Spin(unit, -10, 60), 240, 60);
        var shot = new Play(Goal);
        shot.Kick(new Vector3d(0, 4, -24), Vector3d.Zero, 900, 60);
        var shelf = new Play(Shelf);
        shelf.Place(new Vector3d(0, 1.125, 0), 30);
        shelf.Kick(new Vector3d(2, 0, 0), Vector3d.Zero, 900, 60);

        string[] lines =
        [
            "FootballScene: 3 methods, 2 properties, 0 signals, 0 constants",
            "FootballBall: 13 methods, 5 properties, 10 signals, 5 constants",
            .. kick.Impacts,
            Row("normal", 120, 1.0 / 60, kick),
            Row("time_scale 0.3", 400, 0.3 / 60, kick),
            Row("time_scale 8", 15, 8.0 / 60, kick),
            Row("time_scale 8, 480 ticks, set later", 120, 1.0 / 60, kick),
            Row("time_scale 8, 480 ticks, set before", 120, 8.0 / 480, fine),
            Row("240 ticks, set later", 480, 1.0 / 240, kick),
            "360000 frames of 1/100 s as a float: 1 to 1 steps per frame",
            $"kick 27 m/s, top spin -10, side spin 60: {spun.Hash} after 240 steps",
            $"saved at 60, restored: {kick.Hash} after 120 steps, as before",
            $"a shot into the goal: {shot.Counts("impact", "net", "goal", "enter_zone", "exit_zone", "rest")}, {shot.Hash}",
            $"over the edge of a shelf: {shelf.Counts("impact", "slide", "roll", "contact_end", "rest")}",
            "left: 0 names, 0 strings, 0 arrays, 0 objects, 0 variants, 0 scenes",
            string.Empty,
        ];
        Repository.AssertCurrent("tests/Native/godot.txt", string.Join('\n', lines));
    }

    private static string Row(string name, int frames, double delta, Play play) =>
        string.Create(CultureInfo.InvariantCulture, $"{name}: {frames} frames of {delta:F6} s, ball time {play.Time:F6} s, {play.Hash}");

    /// <summary>A ball that rests at the origin, and all its events.</summary>
    private sealed class Play
    {
        private readonly CompiledScene _scene;
        private readonly List<BallEvent> _events = [];
        private readonly StepLog _log = new();
        private BallState _ball;

        public Play(string scene)
        {
            _scene = Requests.Scene(Encoding.UTF8.GetBytes(scene));
            _ball = _scene.Simulator.Launch(Vector3d.Zero, Vector3d.Zero, Vector3d.Zero);
        }

        public double Time => _ball.Time;

        public string Hash => $"hash {Snapshot.Hash(in _ball):x16}";

        public IEnumerable<string> Impacts => _events.Where(each => each.Kind == BallEventKind.Impact)
            .Select(each => string.Create(CultureInfo.InvariantCulture, $"impact on ground after {each.Time:F3} s"));

        public void Place(Vector3d position, int steps)
        {
            new PlaceInput(0, 0, 0, position, Vector3d.Zero, Vector3d.Zero, null).Apply(_scene.Simulator, ref _ball);
            Step(steps, 60);
        }

        public void Kick(Vector3d velocity, Vector3d spin, int steps, int perSecond)
        {
            _scene.Simulator.Kick(ref _ball, velocity, spin);
            Step(steps, perSecond);
        }

        public string Counts(params string[] kinds) => string.Join(
            ", ", kinds.Select(kind => $"{kind} {_events.Count(each => kind.Replace("_", string.Empty, StringComparison.Ordinal).Equals(each.Kind.ToString(), StringComparison.OrdinalIgnoreCase))}"));

        private void Step(int steps, int perSecond)
        {
            for (int i = 0; i < steps; i++)
            {
                _log.Clear();
                _scene.Simulator.Step(ref _ball, 1.0 / perSecond, _log);
                for (int k = 0; k < _log.Events.Count; k++)
                {
                    _events.Add(_log.Events[k]);
                }
            }
        }
    }
}
