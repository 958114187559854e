namespace FootballPhysics.Yardsticks;

/// <summary>Drag, Magnus force and spin decay with constant coefficients.</summary>
public readonly struct PlainConstant : IPlainLaw
{
    private readonly double _upward;
    private readonly double _drag;
    private readonly double _magnus;
    private readonly double _decay;

    public PlainConstant(Scene scene)
    {
        BallProperties ball = scene.Ball;
        double area = Math.PI * ball.Radius * ball.Radius;
        _upward = -scene.Gravity + (4.0 / 3.0 * area * ball.Radius * scene.Air.Density * scene.Gravity / ball.Mass);
        _drag = 0.5 * scene.Air.Density * scene.Forces.DragCoefficient * area / ball.Mass;
        _magnus = scene.Forces.MagnusCoefficient * Math.PI * scene.Air.Density * ball.Radius * ball.Radius * ball.Radius / ball.Mass;
        _decay = scene.Forces.SpinDecayCoefficient / ball.MomentOfInertia;
    }

    public void Rates(in PlainVector u, in PlainVector spin, out PlainVector acceleration, out PlainVector spinAcceleration)
    {
        acceleration = new PlainVector(0, _upward, 0) - ((_drag * u.Length) * u) + (_magnus * PlainVector.Cross(spin, u));
        spinAcceleration = -_decay * spin;
    }
}
