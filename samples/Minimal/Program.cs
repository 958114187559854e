// A free kick in fifty lines: scene, kick, look-ahead, step loop, events, aim. Metres, seconds, rad/s; y is up, −z is forwards.
using FootballPhysics;
using FootballPhysics.Aiming;
using FootballPhysics.Prediction;

// The scene: ball, air, forces and ground. The defaults are a football over turf in still air.
var scene = new Scene
{
    Air = new Air { Wind = new Vector3d(2, 0, 0) },
    Ground = Ground.Of(SurfaceMaterial.WetTurf),
};
var ball = new Ball(scene);

// The kick: 27 m/s, slightly to the right and up, with backspin, and sidespin that bends it to the left.
ball.Kick(speed: 27, direction: new Vector3d(0.25, 0.3, -1), topSpin: -10, sideSpin: 60);

// Look ahead: a path with a query for its crossing of the goal line, 22 m away.
var path = new Trajectory();
ball.LookAhead(new LookAheadRequest { Duration = 5 }, path);
var goalLine = new Plane3d(point: new Vector3d(0, 0, -22), normal: new Vector3d(0, 0, -1));
if (path.TryGetCrossing(goalLine, out PathPoint crossing))
{
    Console.WriteLine($"will cross the goal line after {crossing.Time:F2} s, {crossing.Position.Y:F2} m high");
}

// The game loop: one step per frame, and its events.
while (ball.Motion != MotionState.Rest)
{
    ball.Step(1.0 / 60.0);
    foreach (BallEvent happened in ball.Events)
    {
        Console.WriteLine($"{happened.Time,6:F2} s  {happened.Kind,-6}  at {happened.Position}, {happened.Velocity.Length:F1} m/s");
    }
}

// Aim: find the kick of 27 m/s with that sidespin that passes over the wall and reaches the corner.
AimResult kick = new Aimer(scene).Find(new AimRequest
{
    From = new Vector3d(0, 0.11, 0),
    Target = new Vector3d(-3.2, 1.8, -22),
    Speed = 27,
    SideSpin = 60,
});
Console.WriteLine($"{kick.Status}: velocity {kick.Velocity}, passes the corner at {1000 * kick.Miss:F1} mm after {kick.Time:F2} s");

ball.Place(new Vector3d(0, 0.11, 0));
ball.Kick(kick.Velocity, kick.Spin);
