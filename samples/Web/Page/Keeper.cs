using FootballPhysics.Prediction;
using FootballPhysics.Shapes;

/// <summary>A goalkeeper of two bodies (trunk and gloves). He dives once, towards the point at which the library predicts the ball on the goal line.</summary>
internal sealed class Keeper
{
    /// <summary>The distance from his feet to his gloves when he is stretched, m.</summary>
    private const double Length = 2.2;

    /// <summary>The distance from his feet to his shoulders, m.</summary>
    private const double Shoulders = 1.4;

    private readonly Player _player;
    private readonly Goal _goal;
    private readonly KinematicBody _trunk;
    private readonly KinematicBody _gloves;
    private readonly Vector3d _feet;
    private readonly Vector3d _ready;
    private Vector3d _reached;
    private Vector3d _landing;
    private double _from = double.PositiveInfinity;
    private double _until = double.PositiveInfinity;

    /// <summary>Creates a goalkeeper at the centre of a goal, half a metre in front of its line.</summary>
    /// <param name="goal">The goal.</param>
    /// <param name="reaction">His reaction time, s.</param>
    /// <param name="speed">The top speed of his gloves, m/s.</param>
    public Keeper(Goal goal, double reaction, double speed)
    {
        _goal = goal;
        _feet = goal.Center + new Vector3d(0, 0, 0.5);
        _ready = _feet + new Vector3d(0, 1.2, 0.25);
        _player = new Player { Position = _feet, Reaction = reaction, Acceleration = 14, Speed = speed, Reach = 0.6, MaximumHeight = 2.6 };
        _trunk = Bodies.Add("keeper", new CapsuleShape(new Vector3d(0, -0.6, 0), new Vector3d(0, 0.6, 0), 0.2), SurfaceMaterial.Boot);
        _gloves = Bodies.Add("gloves", new SphereShape(Vector3d.Zero, 0.17), SurfaceMaterial.Glove);
        MoveTo(0);
    }

    /// <summary>The bodies of the goalkeeper, for the scene.</summary>
    public KinematicBodies Bodies { get; } = [];

    /// <summary>The result of the library's search for a save.</summary>
    public KeeperResult Answer { get; private set; }

    /// <summary>Watches a shot, and plans his dive.</summary>
    /// <param name="path">The path of the ball without the goalkeeper.</param>
    public void Watch(Trajectory path)
    {
        Answer = new Interception().FindSave(path, _player, _goal);
        (_from, _until) = (double.PositiveInfinity, double.PositiveInfinity);
        double aside = Answer.Crossing.Position.X - _feet.X;
        if (!Answer.Crosses || Math.Abs(aside) > (0.5 * _goal.Width) + 1 || Answer.Crossing.Position.Y > _goal.Height + 0.8)
        {
            return;                                        // no dive: the shot is wide or high
        }

        _from = path.StartTime + _player.Reaction;
        _until = Math.Max(Answer.Crossing.Time, _from + 0.25);

        // Dive to the crossing if he gets there in time, otherwise as far as he can reach.
        double covers = Math.Max(Math.Abs(Answer.ReachLeft), Math.Abs(Answer.ReachRight)) - _player.Reach;
        double share = Answer.Saves ? 1 : Math.Clamp(covers / Math.Max(Math.Abs(aside), 1e-9), 0.2, 0.9);
        var target = new Vector3d(Answer.Crossing.Position.X, Math.Max(0.15, Answer.Crossing.Position.Y), _feet.Z - 0.1);
        _reached = Vector3d.Lerp(_ready, target, share);
        _landing = new Vector3d(_reached.X, Math.Min(_reached.Y, 0.25), _reached.Z);
    }

    /// <summary>Moves his bodies to their pose at a time. Call it before the step that begins at that time.</summary>
    public void MoveTo(double time)
    {
        const double moment = 1e-4;
        (Vector3d feet, Vector3d shoulders, Vector3d gloves) = At(time);
        (Vector3d feetNext, Vector3d shouldersNext, Vector3d glovesNext) = At(time + moment);
        Vector3d up = (shoulders - feet).Normalized();
        Vector3d upNext = (shouldersNext - feetNext).Normalized();
        Vector3d middle = feet + (0.75 * up);
        Vector3d middleNext = feetNext + (0.75 * upNext);
        double half = Math.Sqrt(Math.Max(1e-9, 0.5 * (1 + up.Y)));
        var turn = new Quaterniond(0.5 * up.Z / half, 0, -0.5 * up.X / half, half);
        _trunk.MoveTo(middle, turn, (middleNext - middle) / moment, Vector3d.Cross(up, upNext - up) / moment, time);
        _gloves.MoveTo(gloves, (glovesNext - gloves) / moment, time);
    }

    /// <summary>Returns the positions of feet, shoulders and gloves at a time.</summary>
    public (Vector3d Feet, Vector3d Shoulders, Vector3d Gloves) At(double time)
    {
        double dived = Math.Clamp((time - _from) / (_until - _from), 0, 1);
        double fallen = Math.Clamp((time - _until - 0.1) / 0.4, 0, 1);
        Vector3d gloves = double.IsPositiveInfinity(_from) || dived <= 0 ? _ready
            : Vector3d.Lerp(Vector3d.Lerp(_ready, _reached, dived * (2 - dived)), _landing, fallen * fallen);

        // He leans towards his gloves. If leaning is not enough, his feet move aside.
        double aside = gloves.X - _feet.X;
        double lean = Math.Clamp(aside / Length, -0.97, 0.97);
        double height = Math.Sqrt(1 - (lean * lean));
        double lifted = Math.Max(0, gloves.Y - (Length * height) - 0.2);
        var feet = new Vector3d(_feet.X + aside - (Length * lean), Math.Max(0.1, lifted), _feet.Z);
        var up = new Vector3d(lean, height, 0);
        return (feet, feet + (Shoulders * up), gloves);
    }
}
