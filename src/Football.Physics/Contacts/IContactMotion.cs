using FootballPhysics.Integration;

namespace FootballPhysics.Contacts;

/// <summary>The equations of a ball on its contacts, whose modes stay the same for a piece.</summary>
internal interface IContactMotion : IMotionSystem
{
    /// <summary>The number of margins.</summary>
    int Margins { get; }

    /// <summary>Computes the forces at a motion, for the margins.</summary>
    void Look(double time, in Motion at);

    /// <summary>Returns a margin at the last computed forces: it is positive until its event, which ends the piece. 0 if the event cannot occur.</summary>
    /// <param name="index">The margin.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">The motion at which the forces were computed.</param>
    double Margin(int index, double time, in Motion at);
}
