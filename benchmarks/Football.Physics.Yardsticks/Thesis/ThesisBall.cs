using System.Numerics;

namespace FootballPhysics.Yardsticks;

/// <summary>A ball by the thesis' method: its state machine, forces, integrators and recursive search of the impact, in single precision.</summary>
public sealed class ThesisBall
{
    private const float SlipTolerance = 1e-3f;

    private readonly Scene _scene;
    private readonly Integrator _method;
    private readonly ThesisIntegrators _integrators;
    private readonly float _radius;
    private float _previousSlip;

    /// <summary>Creates a ball in still air.</summary>
    /// <param name="method">The integrator.</param>
    /// <param name="scene">The scene; default: the library's. It uses all published forces.</param>
    /// <param name="tolerance">ε of the search for the impact, s; 0 for the thesis' example of an eighth of the step.</param>
    public ThesisBall(Integrator method, Scene? scene = null, float tolerance = 1e-6f)
    {
        _scene = scene ?? Scene.Published;
        _method = method;
        _integrators = new ThesisIntegrators(new ThesisForces(_scene));
        _radius = (float)_scene.Ball.Radius;
        Tolerance = tolerance;
    }

    /// <summary>ε of the search for the impact, s.</summary>
    public float Tolerance { get; }

    public Vector3 Position { get; private set; }

    public Vector3 Velocity { get; private set; }

    public Vector3 AngularVelocity { get; private set; }

    public Quaternion Orientation { get; private set; }

    public ThesisState State { get; private set; }

    /// <summary>The position of the ball's last impact on the ground.</summary>
    public Vector3 LastImpact { get; private set; }

    /// <summary>The number of impacts on the ground.</summary>
    public int Impacts { get; private set; }

    /// <summary>Kicks the ball from the shot's position.</summary>
    public void Kick(Shot shot)
    {
        Position = shot.Position.ToVector3();
        Velocity = shot.Velocity.ToVector3();
        AngularVelocity = shot.Spin.ToVector3();
        Orientation = Quaternion.Identity;
        Impacts = 0;
        bool flies = Position.Y > _radius || MathF.Abs(Velocity.Y) >= (float)_scene.Ground.MinimumBounceSpeed;
        float slip = Slip(Velocity, AngularVelocity).Length();
        State = flies ? ThesisState.Bouncing : slip < SlipTolerance ? ThesisState.Rolling : ThesisState.Sliding;
        _previousSlip = float.PositiveInfinity;
    }

    /// <summary>Advances the ball by a frame.</summary>
    public void FixedUpdate(float deltaTime)
    {
        switch (State)
        {
            case ThesisState.Stopped:
                break;
            case ThesisState.Bouncing:
                Bounce(deltaTime);
                break;
            default:
                Move(deltaTime);
                break;
        }
    }

    private void Bounce(float deltaTime)
    {
        var next = _integrators.Integrate(_method, deltaTime, Position, Orientation, Velocity, AngularVelocity, State);
        if (next.P.Y >= _radius)
        {
            (Position, Orientation, Velocity, AngularVelocity) = next;
            return;
        }

        float tolerance = Tolerance > 0f ? Tolerance : deltaTime / 8f;
        float impact = FindImpact(deltaTime / 2f, deltaTime / 2f, tolerance);
        (Position, Orientation, Velocity, AngularVelocity) =
            _integrators.Integrate(_method, impact, Position, Orientation, Velocity, AngularVelocity, State);
        LastImpact = Position;
        Impacts++;
        Respond();
        float rest = deltaTime - impact;
        if (rest > 0f && rest < deltaTime)
        {
            FixedUpdate(rest);
        }
    }

    /// <summary>The recursive search of 2.4.4: re-integrate, halve, until the halving is no longer than the tolerance.</summary>
    private float FindImpact(float time, float step, float tolerance)
    {
        if (step <= tolerance)
        {
            return time;
        }

        var next = _integrators.Integrate(_method, time, Position, Orientation, Velocity, AngularVelocity, State);
        step /= 2f;
        return FindImpact(next.P.Y < _radius ? time - step : time + step, step, tolerance);
    }

    private void Respond()
    {
        Ground ground = _scene.Ground;
        float alpha = (float)_scene.Ball.InertiaFactor;
        float ex = (float)ground.Material.TangentialRestitution;
        float ey = (float)ground.Material.NormalRestitution;
        float ez = (float)(ground.TangentialRestitutionZ ?? ground.Material.TangentialRestitution);
        Vector3 v = Velocity;
        Vector3 w = AngularVelocity;
        Velocity = new Vector3(
            ((1f - (alpha * ex)) / (alpha + 1f) * v.X) - (alpha * (1f + ex) / (alpha + 1f) * _radius * w.Z),
            -ey * v.Y,
            ((1f - (alpha * ez)) / (alpha + 1f) * v.Z) + (alpha * (ez + 1f) / (alpha + 1f) * _radius * w.X));
        AngularVelocity = new Vector3(
            ((alpha - ez) / (alpha + 1f) * w.X) + ((ez + 1f) / (alpha + 1f) * v.Z / _radius),
            (float)ground.Material.SpinRestitution * w.Y,
            ((alpha - ex) / (alpha + 1f) * w.Z) - ((ex + 1f) / (alpha + 1f) * v.X / _radius));
        Position = new Vector3(Position.X, _radius, Position.Z);
        if (Velocity.Y < (float)ground.MinimumBounceSpeed)
        {
            Velocity = new Vector3(Velocity.X, 0f, Velocity.Z);
            State = ThesisState.Sliding;
            _previousSlip = float.PositiveInfinity;
        }
    }

    private void Move(float deltaTime)
    {
        (Vector3 p, Orientation, Vector3 v, AngularVelocity) =
            _integrators.Integrate(_method, deltaTime, Position, Orientation, Velocity, AngularVelocity, State);
        Position = new Vector3(p.X, _radius, p.Z);
        Velocity = new Vector3(v.X, 0f, v.Z);
        float slip = Slip(Velocity, AngularVelocity).Length();
        if (State == ThesisState.Sliding && (slip > _previousSlip || slip < SlipTolerance))
        {
            State = ThesisState.Rolling;
            AngularVelocity = new Vector3(Velocity.Z / _radius, AngularVelocity.Y, -Velocity.X / _radius);
        }

        _previousSlip = slip;
        float energy = 0.5f * (((float)_scene.Ball.Mass * Velocity.LengthSquared()) + ((float)_scene.Ball.MomentOfInertia * AngularVelocity.LengthSquared()));
        if (State == ThesisState.Rolling && energy < (float)_scene.Ground.RestEnergy)
        {
            State = ThesisState.Stopped;
            Velocity = Vector3.Zero;
            AngularVelocity = Vector3.Zero;
        }
    }

    private Vector3 Slip(Vector3 velocity, Vector3 angularVelocity)
    {
        Vector3 slip = velocity + Vector3.Cross(_radius * Vector3.UnitY, angularVelocity);
        return new Vector3(slip.X, 0f, slip.Z);
    }
}
