using System.Globalization;
using FootballPhysics;

// One ball, with whatever laws a scene may choose.
var ball = new Ball();
ball.Kick(speed: 27, direction: new Vector3d(-0.1, 0.3, -1), topSpin: -10, sideSpin: 55);
while (ball.Events.Count == 0)
{
    ball.Step(1.0 / 60.0);
}

BallEvent landing = ball.Events[0];
Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"landed after {landing.Time:F2} s, {-landing.Position.Z:F1} m away, {landing.Position.X:F1} m to the side"));
