using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>A piece of a slide or a roll.</summary>
internal struct SurfacePiece
{
    /// <summary>The equations, locked for the piece, with the forces at the start.</summary>
    public SurfaceSystem System;

    /// <summary>The motion at the start.</summary>
    public Motion From;

    /// <summary>The rates at the start.</summary>
    public MotionRates Start;

    /// <summary>The speed of the slip or the roll at the start, m/s.</summary>
    public double Size;

    /// <summary>The proposed length, s.</summary>
    public double Length;

    /// <summary>True if the piece ends where the ball loses its load.</summary>
    public bool OverEdge;

    /// <summary>True if the piece ends at a contact.</summary>
    public bool Meets;

    /// <summary>The contact at its end, if it meets one.</summary>
    public Separation Met;
}
