using System.Numerics;

namespace FootballPhysics.Yardsticks;

/// <summary>Forces and torques by the thesis' method: each its own function, which recomputes everything, in single precision.</summary>
/// <remarks>Errors of sign and brackets in its listings are corrected, so that the results can be compared with the reference.</remarks>
public sealed class ThesisForces
{
    private const float FastDrag = (float)FittedLaws.FastDrag;
    private const float DragDrop = (float)FittedLaws.DragDrop;
    private const float CriticalSpeed = (float)FittedLaws.CriticalSpeed;
    private const float SpeedScale = (float)FittedLaws.SpeedScale;
    private const float CriticalSpin = (float)FittedLaws.CriticalSpin;
    private const float SpinFactor = (float)FittedLaws.SpinFactor;
    private const float SpinPower = (float)FittedLaws.SpinPower;
    private const float LiftFactor = (float)FittedLaws.LiftFactor;
    private const float LiftPower = (float)FittedLaws.LiftPower;
    private const float PlateFactor = (float)FittedLaws.PlateFactor;
    private const float PlatePower = (float)FittedLaws.PlatePower;

    private readonly float _mass;
    private readonly float _radius;
    private readonly float _inertia;
    private readonly float _airDensity;
    private readonly float _viscosity;
    private readonly float _slidingFriction;
    private readonly float _rollingFriction;
    private readonly float _spinDamping;
    private readonly Vector3 _gravitationalForce;
    private readonly Vector3 _buoyantForce;

    public ThesisForces(Scene scene)
    {
        _mass = (float)scene.Ball.Mass;
        _radius = (float)scene.Ball.Radius;
        _inertia = (float)scene.Ball.MomentOfInertia;
        _airDensity = (float)scene.Air.Density;
        _viscosity = (float)scene.Air.KinematicViscosity;
        _slidingFriction = (float)scene.Ground.Material.SlidingFriction;
        _rollingFriction = (float)scene.Ground.Material.RollingResistance;
        _spinDamping = (float)scene.Ground.Material.SpinDamping;
        _gravitationalForce = (float)scene.Gravity * _mass * -Vector3.UnitY;
        _buoyantForce = 4f / 3f * MathF.PI * MathF.Pow(_radius, 3) * _airDensity * (float)scene.Gravity * Vector3.UnitY;
    }

    public (Vector3 Acceleration, Vector3 AngularAcceleration) CalculateAccelerationAndAngularAcceleration(
        Vector3 velocity, Vector3 angularVelocity, ThesisState state)
    {
        Vector3 acceleration = CalculateForce(velocity, angularVelocity, state) / _mass;
        Vector3 angularAcceleration = CalculateTorque(velocity, angularVelocity, acceleration, state) / _inertia;
        return (acceleration, angularAcceleration);
    }

    private Vector3 CalculateForce(Vector3 velocity, Vector3 angularVelocity, ThesisState state) =>
        _gravitationalForce + _buoyantForce + CalculateNormalForce(state) + CalculateDragForce(velocity, angularVelocity)
        + CalculateMagnusForce(velocity, angularVelocity, state) + CalculateFrictionForce(velocity, angularVelocity, state);

    private Vector3 CalculateTorque(Vector3 velocity, Vector3 angularVelocity, Vector3 acceleration, ThesisState state) =>
        CalculateFrictionTorque(velocity, angularVelocity, acceleration, state) + CalculateSpinDegradation(velocity, angularVelocity);

    private Vector3 CalculateNormalForce(ThesisState state) =>
        state != ThesisState.Bouncing ? -(_gravitationalForce + _buoyantForce) : Vector3.Zero;

    private Vector3 CalculateDragForce(Vector3 velocity, Vector3 angularVelocity)
    {
        if (velocity.Length() == 0f)
        {
            return Vector3.Zero;
        }

        float s = angularVelocity.Length() * _radius / velocity.Length();
        float dragCoefficient = velocity.Length() > CriticalSpeed && s > CriticalSpin
            ? SpinFactor * MathF.Pow(s, SpinPower)
            : FastDrag + (DragDrop / (1f + MathF.Exp((velocity.Length() - CriticalSpeed) / SpeedScale)));
        return -0.5f * _airDensity * dragCoefficient * MathF.PI * MathF.Pow(_radius, 2) * velocity.Length() * velocity;
    }

    private Vector3 CalculateMagnusForce(Vector3 velocity, Vector3 angularVelocity, ThesisState state)
    {
        if (velocity.Length() == 0f || angularVelocity.Length() == 0f)
        {
            return Vector3.Zero;
        }

        var direction = Vector3.Cross(Vector3.Normalize(angularVelocity), Vector3.Normalize(velocity));
        float s = angularVelocity.Length() * _radius / velocity.Length();
        float cdRe0 = FastDrag + (DragDrop / (1f + MathF.Exp(-CriticalSpeed / SpeedScale)));
        float cdReRef = FastDrag;
        float dragCoefficient = velocity.Length() > CriticalSpeed && s > CriticalSpin
            ? SpinFactor * MathF.Pow(s, SpinPower)
            : FastDrag + (DragDrop / (1f + MathF.Exp((velocity.Length() - CriticalSpeed) / SpeedScale)));
        float liftCoefficient = LiftFactor * MathF.Pow(s, LiftPower) * (cdRe0 - MathF.Min(dragCoefficient, cdRe0)) / (cdRe0 - cdReRef);
        Vector3 magnusForce = 0.5f * _airDensity * liftCoefficient * MathF.PI * MathF.Pow(_radius, 2) * MathF.Pow(velocity.Length(), 2) * direction;
        if (state != ThesisState.Bouncing)
        {
            magnusForce.Y = 0f;
        }

        return magnusForce;
    }

    private Vector3 CalculateFrictionForce(Vector3 velocity, Vector3 angularVelocity, ThesisState state)
    {
        float normalForce = (_gravitationalForce + _buoyantForce).Length();
        return state switch
        {
            ThesisState.Sliding => -_slidingFriction * normalForce * Unit(velocity + Vector3.Cross(_radius * Vector3.UnitY, angularVelocity)),
            ThesisState.Rolling => -_rollingFriction * normalForce * Unit(velocity),
            _ => Vector3.Zero,
        };
    }

    private Vector3 CalculateFrictionTorque(Vector3 velocity, Vector3 angularVelocity, Vector3 acceleration, ThesisState state)
    {
        if (state == ThesisState.Bouncing)
        {
            return Vector3.Zero;
        }

        float normalForce = (_gravitationalForce + _buoyantForce).Length();
        var frictionTorque = new Vector3(0, -_spinDamping * angularVelocity.Y, 0);
        if (state == ThesisState.Rolling)
        {
            frictionTorque += Vector3.Cross(acceleration / _radius, -Vector3.UnitY) * _inertia;
        }
        else
        {
            Vector3 contact = velocity + Vector3.Cross(_radius * Vector3.UnitY, angularVelocity);
            Vector3 axisOfTorque = Unit(Vector3.Cross(Vector3.UnitY, new Vector3(contact.X, 0, contact.Z)));
            Vector3 angularAcceleration = _slidingFriction * normalForce * _radius * axisOfTorque / _inertia;
            frictionTorque += angularAcceleration * _inertia;
        }

        return frictionTorque;
    }

    private Vector3 CalculateSpinDegradation(Vector3 velocity, Vector3 angularVelocity)
    {
        if (angularVelocity.Length() == 0f)
        {
            return Vector3.Zero;
        }

        float rh = _radius / 2f;
        float up = MathF.Abs(velocity.Length() + (rh * angularVelocity.Length()));
        float down = MathF.Abs(velocity.Length() - (rh * angularVelocity.Length()));
        float cUp = PlateFactor * MathF.Pow(up * 2f * _radius / _viscosity, PlatePower);
        float cDown = down > 0f ? PlateFactor * MathF.Pow(down * 2f * _radius / _viscosity, PlatePower) : 0f;
        float force = _airDensity * MathF.PI * MathF.Pow(_radius, 2) * ((MathF.Pow(up, 2) * cUp) + (MathF.Pow(down, 2) * cDown));
        return -force * rh * Vector3.Normalize(angularVelocity);
    }

    private static Vector3 Unit(Vector3 v) => v.LengthSquared() > 0f ? Vector3.Normalize(v) : Vector3.Zero;
}
