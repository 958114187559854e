using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The air as the one-step methods use it.</summary>
internal interface IFlightLaws
{
    /// <summary>True if the methods must call <see cref="WindAt"/>.</summary>
    /// <remarks>A constant of the type, except in <see cref="SceneAir"/>: if it is false, the compiler removes the call.</remarks>
    bool HasField { get; }

    /// <summary>True if the methods must call <see cref="Side"/>: they then integrate the distance flown and the angle turned with the motion.</summary>
    /// <remarks>A constant of the type, except in <see cref="SceneAir"/> and <see cref="FieldAir{TLaw}"/>.</remarks>
    bool HasSide { get; }

    /// <summary>True if the methods must add <see cref="Sideways"/>. A constant of the type, except where <see cref="HasField"/> is not.</summary>
    bool Tilts { get; }

    /// <summary>The horizontal part of the acceleration by gravity and buoyancy, in m/s².</summary>
    Vector3d Sideways { get; }

    /// <summary>Returns the variable wind in addition to the steady one, in m/s.</summary>
    /// <param name="time">The time, in s.</param>
    /// <param name="x">The x coordinate, in m.</param>
    /// <param name="y">The y coordinate, in m.</param>
    /// <param name="z">The z coordinate, in m.</param>
    Vector3d WindAt(double time, double x, double y, double z);

    /// <summary>Turns the seams of the ball with it, once for a step.</summary>
    /// <param name="start">The ball at the start of the step.</param>
    /// <param name="seams">The axes of the seams.</param>
    void Begin(in BallState start, out SeamAxes seams);

    /// <summary>Turns the seams about the axis of the spin, for a stage within a step.</summary>
    /// <param name="seams">The axes of the seams at the start.</param>
    /// <param name="axis">The axis of the spin.</param>
    /// <param name="turn">The angle turned since the start, in rad.</param>
    /// <param name="turned">The axes of the seams at the stage.</param>
    void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned);

    /// <summary>Turns the seams to the middle of a step, and the ball to its end: one sine serves both.</summary>
    /// <param name="seams">The axes of the seams at the start.</param>
    /// <param name="start">The ball at the start.</param>
    /// <param name="half">Half the angle turned in the step, in rad.</param>
    /// <param name="middle">The axes of the seams in the middle.</param>
    /// <param name="end">The orientation at the end.</param>
    void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end);

    /// <summary>Returns the acceleration in addition to drag and lift.</summary>
    /// <param name="seams">The axes of the seams at the stage.</param>
    /// <param name="ux">The x component of the velocity relative to the air, in m/s.</param>
    /// <param name="uy">Its y component.</param>
    /// <param name="uz">Its z component.</param>
    /// <param name="perSquared">1/|u|², in s²/m².</param>
    /// <param name="speed">|u|, in m/s.</param>
    /// <param name="share">The share of <see cref="Factors"/>.</param>
    /// <param name="crossSquared">|ω × u|², in m²/s⁴.</param>
    /// <param name="distance">The distance flown through the air, in m.</param>
    /// <returns>The acceleration, in m/s².</returns>
    Vector3d Side(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance);

    /// <summary>Computes the factors at one instant: a = −drag · u + lift · (ω̂ × u), |ω|˙ = −decay.</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    /// <param name="region">The branch of the drag law that the step is locked to.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">The angular deceleration, in rad/s²; at zero spin, its limit.</param>
    /// <param name="share">q, the share of subcritical flow; defined if <see cref="HasSide"/> is true.</param>
    void Factors(double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share);
}
