using System;

namespace Football.Physics;

/// <summary>Geometry of the sphere that stands for the ball.</summary>
public static class Sphere
{
    /// <summary>The area that a sphere turns to the air, A = π r².</summary>
    /// <param name="radius">Radius in metres; greater than 0.</param>
    /// <returns>The cross section in square metres.</returns>
    public static double CrossSection(double radius) => Math.PI * radius * radius;
}
