namespace Football.Physics;

/// <summary>One kick on its way to be found, in the frame of its target: forward, up, left.</summary>
internal struct BatchAimState
{
    /// <summary>Horizontal unit vector to the target, and the distance.</summary>
    public double ForwardX;
    public double ForwardZ;
    public double Distance;

    /// <summary>Height of the target above the ball.</summary>
    public double Rise;

    /// <summary>Wind along forward and left.</summary>
    public double WindForward;
    public double WindLeft;

    /// <summary>Whether the ball lies on the ground.</summary>
    public bool OnGround;

    public double Speed;
    public double Top;
    public double Side;
    public double SpinRate;

    /// <summary>Unit vector of the kick.</summary>
    public double DirectionForward;
    public double DirectionUp;
    public double DirectionLeft;

    /// <summary>Time to the target.</summary>
    public double Time;

    /// <summary>How the crossing moves with elevation and azimuth.</summary>
    public CrossingJacobian Jacobian;

    /// <summary>The last flight's crossing, and the step that led to it.</summary>
    public double Up;
    public double Left;
    public double Miss;
    public double StepElevation;
    public double StepAzimuth;

    /// <summary>Turns the kick; both angles are small.</summary>
    public void Turn(double elevation, double azimuth)
    {
        // tan x = x + x³/3 within 2e-4 x for |x| ≤ 0.2: what is missing, the next correction mends.
        double horizontal = Math.Sqrt((DirectionForward * DirectionForward) + (DirectionLeft * DirectionLeft));
        double e = elevation * (1.0 + (elevation * elevation * (1.0 / 3.0)));
        double a = azimuth * (1.0 + (azimuth * azimuth * (1.0 / 3.0)));
        double slope = DirectionUp / horizontal;
        slope = (slope + e) / (1.0 - (slope * e));
        double forward = DirectionForward - (a * DirectionLeft);
        double left = DirectionLeft + (a * DirectionForward);
        double scale = 1.0 / Math.Sqrt(1.0 + (slope * slope));
        double flat = scale / Math.Sqrt((forward * forward) + (left * left));
        DirectionForward = forward * flat;
        DirectionLeft = left * flat;
        DirectionUp = slope * scale;
    }
}
